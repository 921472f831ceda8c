// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "robot/poller.h"

#include "session/session.h"
#include <functional>

using namespace std::chrono_literals;
using values::ControlGroup;
using values::Error;
using values::Result;

namespace robot {

namespace {

/// How often something that is read once is asked for until it is answered.
constexpr auto patience = 500ms;

Time now() { return std::chrono::steady_clock::now(); }

} // namespace

Poller::Poller(RobotState &state, QObject *parent) : QObject {parent}, m_state {state}
{
    m_timer.setSingleShot(true);
    m_timer.setTimerType(Qt::PreciseTimer);
    connect(&m_timer, &QTimer::timeout, this, &Poller::poll);
}

Poller::~Poller() = default;

Poller::Interest Poller::want(const QList<Topic> &topics)
{
    auto interest = std::make_shared<const QList<Topic>>(topics);
    std::erase_if(m_interests, [](const auto &old) { return old.expired(); });
    m_interests.push_back(interest);
    if (m_session)
        m_timer.start(0ms);
    return interest;
}

bool Poller::isWanted(Topic topic) const
{
    if (topic == Topic::Status || topic == Topic::SystemInformation)
        return true;
    return !m_isProbing && std::ranges::any_of(m_interests, [topic](const auto &weak) {
        const auto interest = weak.lock();
        return interest && interest->contains(topic);
    });
}

void Poller::start(session::Session &session)
{
    stop();
    m_session = &session;
    m_context = std::make_unique<QObject>();
    m_slots = {};
    m_timer.start(0ms);
}

void Poller::stop()
{
    m_timer.stop();
    m_context.reset();
    m_session = nullptr;
}

void Poller::readNow(Topic topic)
{
    slot(topic).due = {};
    if (m_session)
        m_timer.start(0ms);
}

void Poller::setProbing(bool probing)
{
    m_isProbing = probing;
    for (Slot &slot : m_slots)
        slot.isDone = false; // another controller may stand there now
    if (m_session)
        m_timer.start(0ms);
}

void Poller::poll()
{
    const Time at = now();
    for (int i = 0; i < topicCount; ++i) {
        const auto topic = Topic(i);
        Slot &current = slot(topic);
        if (current.due > at || current.isDone || !isWanted(topic))
            continue;
        const auto pace = period(topic) > 0ms ? period(topic) : patience;
        current.due = current.due + pace > at ? current.due + pace : at + pace;
        if (!current.isWaiting)
            read(topic);
    }
    schedule(at);
}

void Poller::schedule(Time at)
{
    Time next = Time::max();
    for (int i = 0; i < topicCount; ++i) {
        if (const Slot &current = slot(Topic(i)); !current.isDone && isWanted(Topic(i)))
            next = std::min(next, current.due);
    }
    if (next < Time::max())
        m_timer.start(std::chrono::ceil<Milliseconds>(std::max<Time::duration>(next - at, 1ms)));
}

void Poller::read(Topic topic)
{
    constexpr auto base = ControlGroup::robotCartesian(1);
    constexpr auto pulse = ControlGroup::robotPulse(1);
    switch (topic) {
    case Topic::Status: return ask(topic, protocol::ReadStatus {}, &RobotState::takeStatus);
    case Topic::Job: return ask(topic, protocol::ReadExecutingJob {}, &RobotState::takeJob);
    case Topic::BasePosition: return ask(topic, protocol::ReadPosition {base}, &RobotState::takeBasePosition);
    case Topic::PulsePosition: return ask(topic, protocol::ReadPosition {pulse}, &RobotState::takePulsePosition);
    case Topic::BaseAxisNames: return ask(topic, protocol::ReadAxisNames {base}, &RobotState::takeBaseAxisNames);
    case Topic::PulseAxisNames: return ask(topic, protocol::ReadAxisNames {pulse}, &RobotState::takePulseAxisNames);
    case Topic::SystemInformation:
        return ask(topic, protocol::ReadSystemInformation::robot(1), &RobotState::takeSystemInformation);
    }
}

template <typename Request, typename Take> void Poller::ask(Topic topic, const Request &request, Take take)
{
    slot(topic).isWaiting = true;
    m_session->send(request, m_context.get(), [this, topic, take](const Result<typename Request::Reply> &value) {
        const Time at = now();
        if (value)
            std::invoke(take, m_state, *value, at);
        settle(topic, value ? std::nullopt : std::optional {value.error()}, at);
    });
}

void Poller::settle(Topic topic, const std::optional<Error> &error, Time at)
{
    Slot &current = slot(topic);
    current.isWaiting = false;
    const bool isAnswered = !error || error->kind == values::ErrorKind::Refused;
    if (error && (isAnswered || error->kind == values::ErrorKind::Malformed))
        m_state.refuse(topic, *error, at);
    current.isDone = isAnswered && period(topic) == 0ms;
    Q_EMIT finished(topic, error);
}

} // namespace robot
