// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/pages/jobs/holdcard.h"

#include "ui/conditionwords.h"
#include "ui/widgets/statefield.h"
#include "ui/words.h"

namespace pages {

using robot::Act;
using robot::Condition;
using robot::Situation;
using values::Status;

HoldCard::HoldCard(const Context &context, QWidget *parent)
    : OrderCard(context, tr("Hold"), parent),
      m_hold {new widgets::StateField(tr("Held by"), ui::Type::State)},
      m_others {new widgets::Line(ui::Role::Amber)}
{
    m_hold->value()->setObjectName(QStringLiteral("jobsHold"));
    m_others->setObjectName(QStringLiteral("heldElsewhere"));
    body()->addWidget(m_hold);
    body()->addWidget(m_others);
    m_release = addButton(Act::ReleaseHold);
    connect(m_release, &widgets::OrderButton::clicked, this, &HoldCard::release);
    connect(&m_orders, &robot::Orders::situationChanged, this, &HoldCard::showStatus);
    showStatus();
}

void HoldCard::showStatus()
{
    m_hold->show(widgets::shown(m_state.status(), m_state.freshness(robot::topics::status), ui::holdWord));
    const auto &status = m_orders.situation().status;
    QStringList elsewhere;
    if (status && status->data2.testFlag(Status::HeldByPendant))
        elsewhere << ui::reason(Condition::NotHeldByPendant, m_profile.model);
    if (status && status->data2.testFlag(Status::HeldExternally))
        elsewhere << ui::reason(Condition::NotHeldExternally, m_profile.model);
    m_others->setWords(elsewhere.join(u' '));
}

void HoldCard::release()
{
    order(m_release, protocol::HoldOff {}, {Act::ReleaseHold},
        [](const Situation &s) { return s.status && !s.status->data2.testFlag(Status::HeldByCommand); });
}

} // namespace pages
