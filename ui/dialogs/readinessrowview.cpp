// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/dialogs/readinessrowview.h"

#include "ui/readinesswords.h"
#include "ui/widgets/text.h"
#include "ui/widgets/valuelabel.h"
#include <QHBoxLayout>
#include <QPainter>

namespace dialogs {

using robot::Allowance;
using robot::Freshness;
using robot::LinkState;
using robot::ReadinessFacts;
using robot::ReadinessRow;

namespace {

Freshness freshnessOf(const ReadinessRow &row, const ReadinessFacts &facts, bool isStale)
{
    if (facts.link == LinkState::Disconnected || facts.link == LinkState::Checking)
        return Freshness::Unknown;
    const bool isOfNow = row.subject == robot::Subject::Reading && facts.link == LinkState::Lost;
    return isStale && !isOfNow ? Freshness::Stale : Freshness::Live;
}

/// So that the columns of all rows stand in line.
QString widest()
{
    QString result;
    for (const Allowance allowance : {Allowance::Allowed, Allowance::NotAllowed, Allowance::NotKnown}) {
        if (const QString text = ui::word(allowance).text; text.size() > result.size())
            result = text;
    }
    return result;
}

} // namespace

ReadinessRowView::ReadinessRowView(robot::Subject subject, QWidget *parent)
    : QWidget(parent),
      m_sentence {widgets::sentence({}, ui::Role::Text2)},
      m_remedy {widgets::sentence({}, ui::Role::Text1)},
      m_allowance {new widgets::ValueLabel(ui::Type::Heading)},
      m_evidence {widgets::text({}, ui::Type::Label, ui::Role::Text2)}
{
    const QString name = QLatin1String(robot::key(subject));
    setObjectName(name + QStringLiteral("Readiness"));
    m_allowance->setTitle(ui::title(subject));
    m_allowance->setObjectName(name + QStringLiteral("Allowance"));
    m_evidence->setObjectName(name + QStringLiteral("Evidence"));
    m_sentence->setObjectName(name + QStringLiteral("Sentence"));
    m_remedy->setObjectName(name + QStringLiteral("Remedy"));
    m_allowance->show({{widest(), widgets::Lamp::Filled}, Freshness::Live, {}});
    m_allowance->setMinimumWidth(m_allowance->sizeHint().width());
    auto *state = new QVBoxLayout;
    state->setSpacing(2);
    state->addWidget(m_allowance);
    state->addWidget(m_evidence);
    state->addStretch();
    auto *words = new QVBoxLayout;
    words->setSpacing(2);
    words->addWidget(widgets::text(ui::title(subject), ui::Type::Heading, ui::Role::Text1));
    words->addWidget(m_sentence);
    words->addWidget(m_remedy);
    words->addStretch();
    auto *row = new QHBoxLayout(this);
    row->setContentsMargins(0, 8, 8, 8);
    row->setSpacing(ui::space::gap);
    row->addLayout(state);
    row->addLayout(words, 1);
}

void ReadinessRowView::show(const ReadinessRow &row, const ReadinessFacts &facts, const QString &staleNote)
{
    const Freshness freshness = freshnessOf(row, facts, !staleNote.isEmpty());
    m_allowance->show(freshness == Freshness::Unknown ? widgets::unknown()
                                                      : widgets::Shown {ui::word(row.allowance), freshness,
                                                          freshness == Freshness::Stale ? staleNote : QString()});
    m_evidence->setText(ui::word(row.evidence));
    m_sentence->setText(freshness == Freshness::Unknown ? QString() : ui::sentence(row, facts));
    m_sentence->setVisible(freshness != Freshness::Unknown);
    const QString remedy = freshness == Freshness::Unknown ? QString() : ui::remedy(row, facts);
    m_remedy->setText(remedy);
    m_remedy->setVisible(!remedy.isEmpty());
}

void ReadinessRowView::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    painter.setPen(ui::color(ui::Role::Hairline, this));
    painter.drawLine(0, height() - 1, width(), height() - 1);
}

} // namespace dialogs
