// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "robot/jog.h"

#include "protocol/codes.h"

using namespace std::chrono_literals;
using motion::StepEngine;
using values::Result;

namespace robot {

namespace {

constexpr auto beat = 50ms;

/// Every condition of a step but that nothing runs, which the engine looks at itself.
bool allowsMotion(const Orders &orders)
{
    return std::ranges::none_of(orders.findings(Act::Jog),
        [](const Finding &finding) { return finding.blocks() && finding.condition != Condition::NotRunning; });
}

} // namespace

Jog::Jog(Orders &orders, const Result<motion::Limits> &limits, QObject *parent)
    : QObject {parent}, m_orders {orders}, m_limits {limits}
{
    connect(&orders.arming(), &Arming::changed, this, [this] { obey(m_engine.setArmed(m_orders.isArmed(), now())); });
    connect(&orders, &Orders::linkDropped, this, [this] { obey(m_engine.loseLink(now())); });
    m_clock.setInterval(beat);
    m_clock.setTimerType(Qt::PreciseTimer);
    connect(&m_clock, &QTimer::timeout, this, [this] {
        obey(m_engine.tick(now()));
        look();
    });
    obey(m_engine.setArmed(orders.isArmed(), now()));
}

void Jog::setChoice(const motion::JogChoice &choice)
{
    if (isAwake())
        release();
    m_choice = choice;
}

bool Jog::isAwake() const { return m_engine.button() || m_engine.progress() != StepEngine::Progress::Idle; }

std::optional<motion::JogDirection> Jog::pressed() const
{
    return m_engine.button() ? std::optional(m_direction) : std::nullopt;
}

void Jog::press(motion::JogDirection direction)
{
    m_complaint = m_limits ? QString() : m_limits.error().detail;
    m_lastReply.reset();
    m_stepsSent = 0;
    if (m_limits) {
        const bool isFree = !m_engine.button();
        if (isFree)
            m_direction = direction;
        obey(m_engine.press(0, now()));
        look();
    }
    Q_EMIT changed();
}

void Jog::release() { obey(m_engine.release(now())); }
void Jog::setWindowActive(bool isActive) { obey(m_engine.setWindowActive(isActive, now())); }

void Jog::obey(StepEngine::Act act)
{
    if (act == StepEngine::Act::Step)
        sendStep();
    else if (act == StepEngine::Act::Hold)
        m_orders.hold();
    if (!isAwake())
        m_clock.stop();
    else if (!m_clock.isActive())
        m_clock.start();
    Q_EMIT changed();
}

/// A status at rest counts when the position was read after it.
void Jog::look()
{
    if (m_isReading || !isAwake())
        return;
    m_isReading = true;
    m_orders.read(
        protocol::ReadStatus {}, this, [this](const Result<values::Status> &status) { onStatus(status); },
        session::Priority::Control);
}

void Jog::onStatus(const Result<values::Status> &status)
{
    m_isReading = false;
    if (!status)
        return;
    m_orders.controller().poller().note<Kind::Status>(topics::status.number, *status); // conditions look there
    if (status->isRunning() || !allowsMotion(m_orders))
        return feed(*status, now());
    m_present = presentOf(m_orders.controller().state(), m_choice.group);
    readPlaces(places(), *status, now());
}

/// Everything that a step is reckoned from.
QList<values::ControlGroup> Jog::places() const
{
    using values::ControlGroup;
    const int group = m_choice.group.instance;
    if (m_choice.frame != motion::JogFrame::Axes)
        return {ControlGroup::robotCartesian(group)};
    if (group > 20)
        return {m_choice.group};
    const int robot = group > 10 ? group - 10 : group;
    const bool hasTrack = group > 10 || m_present.hasTrack;
    return hasTrack ? QList {ControlGroup::robotPulse(robot), ControlGroup::basePulse(robot)}
                    : QList {ControlGroup::robotPulse(robot)};
}

/// One after the other; what is too old by then waits for the next status.
void Jog::readPlaces(const QList<values::ControlGroup> &groups, const values::Status &status, Time statusAt)
{
    if (groups.isEmpty()) {
        if (now() - statusAt < StepEngine::statusLimit)
            feed(status, statusAt);
        return;
    }
    m_isReading = true;
    m_orders.read(
        protocol::ReadPosition {groups.first()}, this,
        [this, groups, status, statusAt](const Result<values::Position> &position) {
            m_isReading = false;
            if (!position) {
                m_complaint = protocol::explain(position.error());
                return;
            }
            m_present.at(groups.first()) = *position;
            readPlaces(groups.sliced(1), status, statusAt);
        },
        session::Priority::Control);
}

void Jog::feed(const values::Status &status, Time at)
{
    obey(m_engine.takeStatus({status.isRunning(), allowsMotion(m_orders)}, at));
}

void Jog::sendStep()
{
    const auto plan = motion::planStep(m_choice, m_direction, m_present, *m_limits);
    if (!plan) {
        m_complaint = plan.error().detail;
        return obey(m_engine.takeReply(StepEngine::Reply::Refused, now()));
    }
    ++m_stepsSent;
    send(m_orders, Act::Jog, *plan, m_present, this, [this](const Result<void> &result) { onReply(result); });
}

void Jog::onReply(const Result<void> &result)
{
    m_lastReply = result;
    obey(m_engine.takeReply(replyOf(result), now()));
}

} // namespace robot
