// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "robot/robotstate.h"

using namespace std::chrono_literals;

namespace robot {

Milliseconds period(Topic topic)
{
    switch (topic) {
    case Topic::Status:
    case Topic::BasePosition:
    case Topic::PulsePosition: return 100ms;
    case Topic::Job: return 250ms;
    case Topic::BaseAxisNames:
    case Topic::PulseAxisNames:
    case Topic::SystemInformation: break;
    }
    return 0ms;
}

RobotState::RobotState(QObject *parent) : QObject {parent} { }

/// Calls `function` with the reading of `topic`: the one place that knows which member belongs to it.
template <typename Function> void RobotState::visit(Topic topic, Function function)
{
    switch (topic) {
    case Topic::Status: return function(m_status);
    case Topic::Job: return function(m_job);
    case Topic::BasePosition: return function(m_basePosition);
    case Topic::PulsePosition: return function(m_pulsePosition);
    case Topic::BaseAxisNames: return function(m_baseAxisNames);
    case Topic::PulseAxisNames: return function(m_pulseAxisNames);
    case Topic::SystemInformation: return function(m_systemInformation);
    }
}

template <typename Value> void RobotState::store(Reading<Value> &reading, Topic topic, const Value &value, Time now)
{
    reading.take(value, now);
    update(topic, now, true);
}

void RobotState::takeStatus(const values::Status &status, Time now) { store(m_status, Topic::Status, status, now); }
void RobotState::takeJob(const values::ExecutingJob &job, Time now) { store(m_job, Topic::Job, job, now); }
void RobotState::takeBasePosition(const values::Position &position, Time now)
{
    store(m_basePosition, Topic::BasePosition, position, now);
}
void RobotState::takePulsePosition(const values::Position &position, Time now)
{
    store(m_pulsePosition, Topic::PulsePosition, position, now);
}
void RobotState::takeBaseAxisNames(const values::AxisNames &names, Time now)
{
    store(m_baseAxisNames, Topic::BaseAxisNames, names, now);
}
void RobotState::takePulseAxisNames(const values::AxisNames &names, Time now)
{
    store(m_pulseAxisNames, Topic::PulseAxisNames, names, now);
}
void RobotState::takeSystemInformation(const values::SystemInformation &information, Time now)
{
    store(m_systemInformation, Topic::SystemInformation, information, now);
}

void RobotState::refuse(Topic topic, const values::Error &error, Time now)
{
    visit(topic, [&](auto &reading) { reading.refuse(error); });
    update(topic, now, true);
}

void RobotState::update(Topic topic, Time now, bool readAgain)
{
    Freshness fresh = Freshness::Unknown;
    visit(topic, [&](const auto &reading) { fresh = reading.freshness(now, period(topic), m_isLinkUp); });
    const Freshness before = std::exchange(m_freshness[std::size_t(topic)], fresh);
    if (readAgain || before != fresh)
        Q_EMIT changed(topic);
}

void RobotState::tick(Time now)
{
    for (int topic = 0; topic < topicCount; ++topic)
        update(Topic(topic), now, false);
}

void RobotState::setLinkUp(bool up, Time now)
{
    m_isLinkUp = up;
    tick(now);
}

void RobotState::clear()
{
    for (int topic = 0; topic < topicCount; ++topic) {
        visit(Topic(topic), [](auto &reading) { reading = {}; });
        update(Topic(topic), {}, true);
    }
}

} // namespace robot
