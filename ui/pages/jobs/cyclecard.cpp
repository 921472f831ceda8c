// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/pages/jobs/cyclecard.h"

#include "ui/widgets/flow.h"
#include "ui/widgets/statefield.h"
#include "ui/words.h"
#include <QAbstractItemView>
#include <QComboBox>
#include <QHBoxLayout>

namespace pages {

using robot::Act;
using robot::Situation;
using values::CycleMode;
using values::Status;

namespace {

struct Mode {
    CycleMode mode;
    Status::Data1Flag flag;
};

constexpr Mode modes[] {
    {CycleMode::Step, Status::Step},
    {CycleMode::OneCycle, Status::OneCycle},
    {CycleMode::Continuous, Status::Continuous},
};

/// The words of the status, so that both fields speak alike.
QString wordOf(Status::Data1Flag flag) { return ui::cycleWord(Status {flag, {}}).text; }

} // namespace

CycleCard::CycleCard(const Context &context, QWidget *parent)
    : OrderCard(context, tr("Cycle"), parent),
      m_actual {new widgets::StateField(tr("Actual"), ui::Type::State)},
      m_requested {new widgets::StateField(tr("Requested here"), ui::Type::State)},
      m_choice {new QComboBox}
{
    m_actual->value()->setObjectName(QStringLiteral("cycleActual"));
    m_requested->value()->setObjectName(QStringLiteral("cycleRequested"));
    m_requested->show({{widgets::dash()}, robot::Freshness::Live, tr("Nothing was requested from here.")});
    m_choice->setObjectName(QStringLiteral("cycleChoice"));
    m_choice->view()->setObjectName(QStringLiteral("cycleChoices"));
    m_choice->setAccessibleName(tr("Cycle mode to request"));
    for (const Mode &mode : modes)
        m_choice->addItem(wordOf(mode.flag));
    auto *row = new widgets::Flow;
    row->addWidget(m_actual);
    row->addWidget(m_requested);
    body()->addLayout(row);
    body()->addWidget(m_choice);
    m_select = addButton(Act::SelectCycle);
    m_select->setText(tr("Request"));
    connect(m_select, &widgets::OrderButton::clicked, this, &CycleCard::request);
    connect(&m_orders, &robot::Orders::situationChanged, this, &CycleCard::showStatus);
    showStatus();
}

void CycleCard::showStatus()
{
    m_actual->show(widgets::shown(m_state.status(), m_state.freshness(robot::topics::status), ui::cycleWord));
}

void CycleCard::request()
{
    const Mode mode = modes[m_choice->currentIndex()];
    const auto &status = m_orders.situation().status;
    m_requested->show({{wordOf(mode.flag)}, robot::Freshness::Live, {}});
    order(m_select, protocol::SelectCycle {mode.mode},
        {Act::SelectCycle, {}, status ? ui::cycleWord(*status).text : QString(), wordOf(mode.flag)},
        [mode](const Situation &s) { return s.status && s.status->data1.testFlag(mode.flag); });
}

} // namespace pages
