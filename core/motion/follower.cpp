// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "motion/follower.h"

#include "motion/geometry.h"

namespace motion {

namespace {

constexpr double lengthTolerance = 0.05; ///< mm
constexpr double angleTolerance = 0.02; ///< degrees
constexpr int pulseTolerance = 20;
/// A move may take twice as long as it should and this much more.
constexpr std::chrono::seconds patience {5};

bool areSamePulses(const values::AxisWords &a, const values::AxisWords &b)
{
    if (a.count() != b.count())
        return false;
    for (int axis = 0; axis < a.count(); ++axis) {
        if (std::abs(qint64(a[axis]) - b[axis]) > pulseTolerance)
            return false;
    }
    return true;
}

} // namespace

bool isSamePlace(const values::Position &a, const values::Position &b)
{
    if (a.type != b.type)
        return false;
    if (a.type == values::PositionType::Pulse)
        return areSamePulses(a.axes, b.axes);
    const auto from = poseOf(a);
    const auto to = poseOf(b);
    return from && to && distance(*from, *to) <= lengthTolerance && rotationDistance(*from, *to) <= angleTolerance;
}

Follower::Follower(const std::optional<values::Position> &target, Time sentAt, std::chrono::milliseconds expected)
    : m_target {target}, m_deadline {sentAt + 2 * expected + patience}
{
}

Follower::Outcome Follower::end(Outcome outcome)
{
    if (m_outcome == Outcome::UnderWay)
        m_outcome = outcome;
    return m_outcome;
}

Follower::Outcome Follower::takeReply(StepEngine::Reply reply, Time now)
{
    if (reply == StepEngine::Reply::Refused)
        return end(Outcome::Refused);
    if (reply == StepEngine::Reply::Unknown)
        return end(Outcome::Unknown);
    if (!m_acceptedAt)
        m_acceptedAt = now;
    return tick(now);
}

Follower::Outcome Follower::takeStatus(bool isRunning, Time now)
{
    m_hasRun |= isRunning && m_acceptedAt;
    const bool mustHaveBegun = m_acceptedAt && (m_hasRun || now - *m_acceptedAt >= StepEngine::startLimit);
    m_isResting = !isRunning && mustHaveBegun;
    if (!m_isResting)
        m_restedAt.reset();
    return tick(now);
}

/// Two equal positions at rest: one of them may still have been on its way.
Follower::Outcome Follower::takePosition(const values::Position &position, Time now)
{
    m_position = position;
    if (!m_isResting)
        return tick(now);
    if (!m_restedAt || !isSamePlace(*m_restedAt, position)) {
        m_restedAt = position;
        return tick(now);
    }
    if (!m_target)
        return end(Outcome::Rested);
    return end(isSamePlace(position, *m_target) ? Outcome::Arrived : Outcome::Stopped);
}

Follower::Outcome Follower::loseLink() { return end(Outcome::Unknown); }

Follower::Outcome Follower::tick(Time now) { return now > m_deadline ? end(Outcome::Unknown) : m_outcome; }

} // namespace motion
