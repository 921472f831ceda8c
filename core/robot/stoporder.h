// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "robot/reading.h"
#include "values/status.h"
#include <QObject>

namespace session {
class Session;
}

namespace robot {

/// What can be stopped with 0x83 (reference §6).
enum class Stop { Hold, ServoOff };

/// HOLD on or servo off, carried through: it is sent again until a status that was read afterwards agrees ("held by
/// command", servo off), or 2 s have passed. It asks for no level, waits in no queue and can be given again at any
/// time. Deletes itself when finished.
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

    void start();

Q_SIGNALS:
    /// A status was read on the way; it is newer than what the poller knows.
    void statusRead(const values::Status &status, robot::Time at);
    /// Emitted once, last.
    void finished(robot::StopOrder::Outcome outcome, const std::optional<values::Error> &refusal);

private:
    void order();
    void onReply(const values::Result<void> &reply);
    void check();
    [[nodiscard]] bool agrees(const values::Status &status) const;
    void tryAgain();
    void finish(Outcome outcome, const std::optional<values::Error> &refusal = {});

    Stop m_stop;
    session::Session &m_session;
    bool m_isFinished = false;
};

} // namespace robot
