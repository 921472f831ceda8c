// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "robot/stoporder.h"

#include "protocol/codes.h"
#include "session/session.h"

using namespace std::chrono_literals;
using session::Priority;
using values::ErrorKind;
using values::Result;

namespace robot {

namespace {

constexpr auto stopPatience = 2s;
constexpr auto stopPeriod = 40ms;

} // namespace

StopOrder::StopOrder(Stop stop, session::Session &session, QObject *parent)
    : QObject {parent}, m_stop {stop}, m_session {session}
{
    m_patience.setSingleShot(true);
    m_pace.setTimerType(Qt::PreciseTimer);
    connect(
        &m_patience, &QTimer::timeout, this, [this] { finish(m_agrees ? Outcome::Confirmed : Outcome::Unconfirmed); });
    connect(&m_pace, &QTimer::timeout, this, &StopOrder::repeat);
}

void StopOrder::start()
{
    order();
    check();
    m_patience.start(stopPatience);
    m_pace.start(stopPeriod);
}

void StopOrder::order()
{
    m_isOrdering = true;
    const auto handler = [this](const Result<void> &reply) { onReply(reply); };
    if (m_stop == Stop::Hold)
        m_session.send(protocol::HoldOn {}, this, handler);
    else
        m_session.send(protocol::ServoOff {}, this, handler);
}

void StopOrder::check()
{
    m_isChecking = true;
    const auto handler = [this](const Result<values::Status> &status) {
        m_isChecking = false;
        if (status)
            onStatus(*status);
    };
    m_session.send(protocol::ReadStatus {}, this, handler, Priority::Stop);
}

void StopOrder::repeat()
{
    if (!m_isOrdering)
        order();
    if (!m_isChecking)
        check();
}

void StopOrder::onReply(const Result<void> &reply)
{
    m_isOrdering = false;
    if (reply)
        m_isAccepted = true;
    else if (reply.error().kind == ErrorKind::Refused && !protocol::isBusy(reply.error()))
        finish(Outcome::Refused, reply.error());
}

void StopOrder::onStatus(const values::Status &status)
{
    m_agrees = agrees(status);
    m_hasDisagreed = m_hasDisagreed || !m_agrees;
    Q_EMIT statusRead(status, now());
    if (m_agrees && (m_isAccepted || m_hasDisagreed))
        finish(Outcome::Confirmed);
}

bool StopOrder::agrees(const values::Status &status) const
{
    return m_stop == Stop::Hold ? status.data2.testFlag(values::Status::HeldByCommand) : !status.isServoOn();
}

void StopOrder::finish(Outcome outcome, const std::optional<values::Error> &refusal)
{
    if (std::exchange(m_isFinished, true))
        return;
    m_pace.stop();
    m_patience.stop();
    Q_EMIT finished(outcome, refusal);
    deleteLater();
}

} // namespace robot
