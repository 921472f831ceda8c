// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "robot/stoporder.h"

#include "protocol/codes.h"
#include "session/session.h"
#include <QTimer>

using namespace std::chrono_literals;
using session::Priority;
using values::ErrorKind;
using values::Result;

namespace robot {

namespace {

constexpr auto stopPatience = 2s;
constexpr auto pause = 50ms; ///< Between a status that does not confirm and the next try.

} // namespace

StopOrder::StopOrder(Stop stop, session::Session &session, QObject *parent)
    : QObject {parent}, m_stop {stop}, m_session {session}
{
}

void StopOrder::start()
{
    QTimer::singleShot(stopPatience, this, [this] { finish(Outcome::Unconfirmed); });
    order();
}

void StopOrder::order()
{
    const auto handler = [this](const Result<void> &reply) { onReply(reply); };
    if (m_stop == Stop::Hold)
        m_session.send(protocol::HoldOn {}, this, handler);
    else
        m_session.send(protocol::ServoOff {}, this, handler);
}

void StopOrder::onReply(const Result<void> &reply)
{
    if (reply)
        check();
    else if (reply.error().kind == ErrorKind::Refused && !protocol::isBusy(reply.error()))
        finish(Outcome::Refused, reply.error());
    else
        tryAgain();
}

bool StopOrder::agrees(const values::Status &status) const
{
    return m_stop == Stop::Hold ? status.data2.testFlag(values::Status::HeldByCommand) : !status.isServoOn();
}

void StopOrder::check()
{
    const auto judge = [this](const Result<values::Status> &status) {
        if (status)
            Q_EMIT statusRead(*status, now());
        if (status && agrees(*status))
            finish(Outcome::Confirmed);
        else
            tryAgain();
    };
    m_session.send(protocol::ReadStatus {}, this, judge, Priority::Stop);
}

void StopOrder::tryAgain() { QTimer::singleShot(pause, this, &StopOrder::order); }

void StopOrder::finish(Outcome outcome, const std::optional<values::Error> &refusal)
{
    if (std::exchange(m_isFinished, true))
        return;
    Q_EMIT finished(outcome, refusal);
    deleteLater();
}

} // namespace robot
