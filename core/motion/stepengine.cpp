// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "motion/stepengine.h"

#include <utility>

namespace motion {

StepEngine::Act StepEngine::press(int button, Time now)
{
    m_now = now; // what was before the button went down has nothing to do with it
    if (m_button)
        return lose(); // two buttons: none of them can be meant
    if (m_isArmed && m_isActive)
        m_button = button;
    return look(now);
}

StepEngine::Act StepEngine::release(Time now)
{
    m_now = now;
    return lose();
}

StepEngine::Act StepEngine::setArmed(bool isArmed, Time now)
{
    m_isArmed = isArmed;
    return isArmed ? look(now) : lose();
}

StepEngine::Act StepEngine::setWindowActive(bool isActive, Time now)
{
    m_isActive = isActive;
    return isActive ? look(now) : lose();
}

StepEngine::Act StepEngine::takeStatus(const Status &status, Time now)
{
    m_status = status;
    m_statusAt = now;
    settle(now);
    if (!status.allowsMotion)
        return lose();
    return look(now);
}

/// A short step may be over before anybody sees it run; but one that was just accepted may not have begun.
void StepEngine::settle(Time now)
{
    if (m_progress != Progress::Moving)
        return;
    if (m_status.isRunning)
        m_hasRun = true;
    else if (m_hasRun || now - m_acceptedAt >= startLimit)
        m_progress = Progress::Idle;
}

StepEngine::Act StepEngine::takeReply(Reply reply, Time now)
{
    if (m_progress != Progress::Sent)
        return look(now);
    if (reply == Reply::Refused) {
        m_button.reset();
        m_progress = Progress::Idle;
        return Act::Nothing;
    }
    begin(now);
    return reply == Reply::Accepted ? look(now) : lose();
}

/// What was sent and not answered may be moving.
StepEngine::Act StepEngine::loseLink(Time now)
{
    m_now = now;
    m_statusAt.reset();
    if (m_progress == Progress::Sent)
        begin(now);
    return lose();
}

void StepEngine::begin(Time now)
{
    m_progress = Progress::Moving;
    m_acceptedAt = now;
    m_hasRun = false;
}

StepEngine::Act StepEngine::tick(Time now) { return look(now); }

/// The button no longer counts, and what is on its way is held.
StepEngine::Act StepEngine::lose()
{
    m_button.reset();
    const bool isOnItsWay = m_progress != Progress::Idle;
    return isOnItsWay && !std::exchange(m_isHeld, true) ? Act::Hold : Act::Nothing;
}

StepEngine::Act StepEngine::look(Time now)
{
    const bool hasPaused = m_now && now - *m_now > pauseLimit;
    m_now = now;
    if (m_progress != Progress::Idle && now - m_sentAt > stepLimit) {
        const Act act = lose();
        m_progress = Progress::Idle;
        return act;
    }
    if (hasPaused && m_button)
        return lose();
    if (!mayStep(now))
        return Act::Nothing;
    m_progress = Progress::Sent;
    m_sentAt = now;
    m_isHeld = false;
    return Act::Step;
}

bool StepEngine::mayStep(Time now) const
{
    return m_button && m_isArmed && m_isActive && m_progress == Progress::Idle && m_statusAt
        && now - *m_statusAt < statusLimit && m_status.allowsMotion && !m_status.isRunning;
}

} // namespace motion
