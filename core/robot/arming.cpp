// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "robot/arming.h"

using namespace std::chrono_literals;
using values::Status;

namespace robot {

namespace {

constexpr auto tickPeriod = 100ms;

Status::Data1 modeOf(const Status &status)
{
    return status.data1 & (Status::Data1 {Status::Teach} | Status::Play | Status::Remote);
}

} // namespace

Arming::Arming(Milliseconds stillness, QObject *parent) : QObject {parent}, m_stillness {stillness}
{
    connect(&m_clock, &QTimer::timeout, this, [this] { tick(values::Clocks::read()); });
}

bool Arming::arm(const QObject &robot, const Situation &situation, Time now)
{
    if (obstacle(Act::Arm, situation))
        return false;
    if (m_robot && m_robot != &robot)
        drop(Drop::OtherController);
    m_robot = &robot;
    m_mode = modeOf(*situation.status);
    m_lastActivity = now;
    m_lastTick = values::Clocks::read();
    m_clock.start(tickPeriod);
    Q_EMIT changed();
    return true;
}

void Arming::drop(Drop reason)
{
    const QObject *robot = std::exchange(m_robot, nullptr);
    if (!robot)
        return;
    m_clock.stop();
    Q_EMIT dropped(robot, reason);
    Q_EMIT changed();
}

void Arming::follow(const QObject &robot, const Situation &situation)
{
    if (!isArmed(robot))
        return;
    if (!situation.isLinkUp)
        drop(Drop::CommunicationLost);
    else if (situation.level < Level::Operate)
        drop(Drop::AccessDropped);
    else if (situation.status && situation.status->hasAlarm())
        drop(Drop::Alarm);
    else if (situation.status && modeOf(*situation.status) != m_mode)
        drop(Drop::ModeChanged);
}

Milliseconds Arming::remaining(Time now) const
{
    if (!m_robot)
        return 0ms;
    return std::max(0ms, std::chrono::ceil<Milliseconds>(m_lastActivity + idleLimit - now));
}

void Arming::noteActivity(Time now)
{
    tick(now);
    m_lastActivity = now;
}

void Arming::tick(const values::Clocks &clocks)
{
    const auto before = std::exchange(m_lastTick, clocks);
    if (m_robot && values::hasGap(before, clocks, tickPeriod + m_stillness, m_stillness))
        return drop(Drop::Standstill);
    tick(clocks.passed);
}

void Arming::tick(Time now)
{
    if (m_robot && remaining(now) == 0ms)
        drop(Drop::Idle);
}

} // namespace robot
