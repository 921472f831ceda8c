// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/pages/optionscard.h"

#include "ui/conditionwords.h"
#include <QGridLayout>

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

constexpr robot::Act acts[] {robot::Act::StartJob, robot::Act::SelectJob, robot::Act::ReleaseHold, robot::Act::ServoOn,
    robot::Act::ResetAlarm, robot::Act::WriteVariable, robot::Act::Upload, robot::Act::Move};

} // namespace

OptionsCard::OptionsCard(robot::Orders &orders, QWidget *parent)
    : Card(tr("What can I do now?"), parent), m_orders {orders}
{
    auto *grid = new QGridLayout;
    grid->setHorizontalSpacing(8);
    grid->setVerticalSpacing(4);
    grid->setColumnStretch(2, 1);
    m_hold = addRow(grid, QStringLiteral("hold"), tr("HOLD"));
    for (const robot::Act act : acts)
        m_acts << addRow(grid, QLatin1String(robot::key(act)), ui::title(act));
    body()->addLayout(grid);
    body()->addStretch();
    connect(&orders, &robot::Orders::situationChanged, this, &OptionsCard::showActs);
    showLink({});
    showActs();
}

OptionsCard::Row OptionsCard::addRow(QGridLayout *grid, const QString &name, const QString &title)
{
    const Row row {
        widgets::text({}, ui::Type::Body, ui::Role::Text1), new widgets::Line(ui::Role::Text2, ui::Type::Body)};
    row.reason->setObjectName(name + QStringLiteral("Condition"));
    const int line = grid->rowCount();
    grid->addWidget(row.mark, line, 0, Qt::AlignTop);
    grid->addWidget(widgets::text(title, ui::Type::Body, ui::Role::Text1), line, 1, Qt::AlignTop);
    grid->addWidget(row.reason, line, 2, Qt::AlignTop);
    return row;
}

void OptionsCard::showRow(const Row &row, bool isPossible, const QString &reason) const
{
    row.mark->setText(isPossible ? QStringLiteral("✓") : QStringLiteral("✗"));
    row.mark->setAccessibleName(isPossible ? tr("possible") : tr("not possible"));
    row.reason->setWords(reason);
}

void OptionsCard::showLink(const ui::LinkView &link)
{
    const bool isPossible = link.state != robot::LinkState::Disconnected;
    widgets::setTextRole(m_hold.mark, isPossible ? ui::Role::Text1 : ui::Role::Amber);
    showRow(m_hold, isPossible, holdCondition(link.state));
}

void OptionsCard::showActs()
{
    for (qsizetype i = 0; i < m_acts.size(); ++i) {
        const auto obstacle = m_orders.obstacle(acts[i]);
        showRow(m_acts[i], !obstacle, obstacle ? ui::complaint(*obstacle) : QString());
        if (obstacle)
            m_acts[i].reason->setToolTip(ui::reason(*obstacle, m_orders.controller().profile().model));
    }
}

} // namespace pages
