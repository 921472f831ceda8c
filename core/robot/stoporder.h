// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "robot/reading.h"
#include "values/status.h"
#include <QObject>
#include <QTimer>

namespace session {
class Session;
}

namespace robot {

/// What can be stopped with 0x83 (reference §6).
enum class Stop { Hold, ServoOff };

/// HOLD on or servo off, carried through: it is sent at once and every 40 ms, and the status is asked for just as often
/// beside it, until a status agrees ("held by command", servo off), or 2 s have passed. A status that agreed from the
/// beginning counts only once the order was accepted, because it may be older than an order that is still on its way.
/// It asks for no level and waits in no queue. Deletes itself when finished.
class StopOrder : public QObject
{
    Q_OBJECT

public:
    enum class Outcome {
        Confirmed, ///< The status says so.
        Refused, ///< The controller refused; see the error.
        Unconfirmed, ///< 2 s passed. The robot may or may not have stopped: use the pendant.
    };

    /// `session` must outlive the order, or be its parent's to end with it.
    StopOrder(Stop stop, session::Session &session, QObject *parent);

    /// Sends at once; the 2 s begin. Again while it is under way: once more at once, and the 2 s begin again.
    void start();

Q_SIGNALS:
    /// A status was read on the way; it is newer than what the poller knows.
    void statusRead(const values::Status &status, robot::Time at);
    /// Emitted once, last.
    void finished(robot::StopOrder::Outcome outcome, const std::optional<values::Error> &refusal);

private:
    void order();
    void check();
    void repeat();
    void onReply(const values::Result<void> &reply);
    void onStatus(const values::Status &status);
    [[nodiscard]] bool agrees(const values::Status &status) const;
    void finish(Outcome outcome, const std::optional<values::Error> &refusal = {});

    Stop m_stop;
    session::Session &m_session;
    QTimer m_patience;
    QTimer m_pace;
    bool m_isOrdering = false; ///< An order waits for its answer; the session repeats it meanwhile.
    bool m_isChecking = false;
    bool m_isAccepted = false;
    bool m_hasDisagreed = false; ///< A status that was read since the start did not agree.
    bool m_agrees = false; ///< The last one did.
    bool m_isFinished = false;
};

} // namespace robot
