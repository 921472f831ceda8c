// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/pages/optionscard.h"

#include <QHBoxLayout>

namespace pages {

namespace {

QString holdCondition(robot::LinkState state)
{
    switch (state) {
    case robot::LinkState::Monitoring:
        return OptionsCard::tr("always: the button above, the Pause key or Ctrl+Shift+H.");
    case robot::LinkState::Checking:
    case robot::LinkState::Lost:
        return OptionsCard::tr("sent repeatedly until confirmed or 2 s have passed. Have the pendant at hand.");
    case robot::LinkState::Disconnected: break;
    }
    return OptionsCard::tr("there is no connection: use the pendant.");
}

} // namespace

OptionsCard::OptionsCard(QWidget *parent)
    : Card(tr("What can I do now?"), parent),
      m_mark {widgets::text({}, ui::Type::Body, ui::Role::Text1)},
      m_condition {widgets::sentence({}, ui::Role::Text2)}
{
    m_condition->setObjectName(QStringLiteral("holdCondition"));
    auto *row = new QHBoxLayout;
    row->setSpacing(8);
    row->addWidget(m_mark, 0, Qt::AlignTop);
    row->addWidget(widgets::text(tr("HOLD"), ui::Type::Body, ui::Role::Text1), 0, Qt::AlignTop);
    row->addWidget(m_condition, 1, Qt::AlignTop);
    body()->addLayout(row);
    body()->addWidget(widgets::sentence(
        tr("This release watches. Starting, moving and writing are not part of it."), ui::Role::Text2));
    body()->addStretch();
    showLink({});
}

void OptionsCard::showLink(const ui::LinkView &link)
{
    const bool isPossible = link.state != robot::LinkState::Disconnected;
    m_mark->setText(isPossible ? QStringLiteral("✓") : QStringLiteral("✗"));
    m_mark->setAccessibleName(isPossible ? tr("possible") : tr("not possible"));
    widgets::setTextRole(m_mark, isPossible ? ui::Role::Text1 : ui::Role::Amber);
    m_condition->setText(holdCondition(link.state));
}

} // namespace pages
