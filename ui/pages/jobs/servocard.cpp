// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/pages/jobs/servocard.h"

#include "ui/widgets/question.h"
#include "ui/widgets/statefield.h"
#include "ui/words.h"

namespace pages {

using robot::Act;
using robot::Situation;

ServoCard::ServoCard(const Context &context, QWidget *parent)
    : OrderCard(context, tr("Servo"), parent),
      m_servo {new widgets::StateField(tr("Servo power"), ui::Type::State)},
      m_warning {widgets::sentence(tr("A job is running: servo off stops it at once."), ui::Role::Amber)}
{
    m_servo->value()->setObjectName(QStringLiteral("jobsServo"));
    body()->addWidget(m_servo);
    m_on = addButton(Act::ServoOn);
    m_on->setText(tr("Servo on…"));
    m_off = addButton(Act::ServoOff);
    m_warning->setObjectName(QStringLiteral("servoOffWarning"));
    body()->addWidget(m_warning);
    widgets::keepRoom(m_warning);
    connect(m_on, &widgets::OrderButton::clicked, this, &ServoCard::confirmOn);
    connect(m_off, &widgets::OrderButton::clicked, this, &ServoCard::switchOff);
    connect(&context.station.state(), &robot::RobotState::changed, this, [this](const robot::TopicRange &range) {
        if (range.contains(robot::topics::status))
            showStatus();
    });
    showStatus();
}

void ServoCard::showStatus()
{
    m_servo->show(widgets::shown(m_state.status(), m_state.freshness(robot::topics::status), ui::servoWord));
    m_warning->setVisible(m_orders.situation().status && m_orders.situation().status->isRunning());
}

void ServoCard::confirmOn()
{
    const QString text =
        tr("Switch servo power on at %1?\n\nThe robot can move from then on. Nobody may be inside the fence.");
    widgets::ask("servoOnBox", tr("Servo on"), text.arg(m_profile.name),
        {{"confirmServoOn", tr("Servo on"), [this] { switchOn(); }}}, this);
}

void ServoCard::switchOn()
{
    order(m_on, protocol::ServoOn {}, {Act::ServoOn},
        [](const Situation &s) { return s.status && s.status->isServoOn(); });
}

void ServoCard::switchOff()
{
    begin(m_off, [](const Situation &s) { return s.status && !s.status->isServoOn(); });
    m_orders.servoOff(this, [this](const values::Result<void> &result) {
        end(m_off, Act::ServoOff, result);
        m_off->stopExpecting(); // it can be ordered again at any time
    });
}

} // namespace pages
