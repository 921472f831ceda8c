// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "robot/holdorder.h"

#include "protocol/codes.h"
#include "session/session.h"
#include <QTimer>

using namespace std::chrono_literals;
using session::Priority;
using values::ErrorKind;
using values::Result;

namespace robot {

namespace {

constexpr auto patience = 2s;
constexpr auto pause = 50ms; ///< Between a status that does not confirm and the next try.

Time now() { return std::chrono::steady_clock::now(); }

} // namespace

HoldOrder::HoldOrder(session::Session &session, QObject *parent) : QObject {parent}, m_session {session} { }

void HoldOrder::start()
{
    QTimer::singleShot(patience, this, [this] { finish(Outcome::Unconfirmed); });
    order();
}

void HoldOrder::order()
{
    m_session.send(protocol::HoldOn {}, this, [this](const Result<void> &reply) {
        if (reply)
            check();
        else if (reply.error().kind == ErrorKind::Refused && !protocol::isBusy(reply.error()))
            finish(Outcome::Refused, reply.error());
        else
            tryAgain();
    });
}

void HoldOrder::check()
{
    const auto judge = [this](const Result<values::Status> &status) {
        if (status)
            Q_EMIT statusRead(*status, now());
        if (status && status->data2.testFlag(values::Status::HeldByCommand))
            finish(Outcome::Confirmed);
        else
            tryAgain();
    };
    m_session.send(protocol::ReadStatus {}, this, judge, Priority::Stop);
}

void HoldOrder::tryAgain() { QTimer::singleShot(pause, this, &HoldOrder::order); }

void HoldOrder::finish(Outcome outcome, const std::optional<values::Error> &refusal)
{
    if (std::exchange(m_isFinished, true))
        return;
    Q_EMIT finished(outcome, refusal);
    deleteLater();
}

} // namespace robot
