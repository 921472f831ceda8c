// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "session/filesession.h"
#include <QObject>
#include <optional>

namespace files {

/// Asks whether files of the controller may be changed at this moment, and tells why not. Calls back once, at once or
/// from the event loop, unless the context is gone by then.
using Guard = std::function<void(QObject *context, std::function<void(const values::Result<void> &)> handler)>;

enum class OperationState { Waiting, Running, Done, Failed, Cancelled };

/// A long procedure with a controller's files. It is the context of its own requests: deleting it ends them at the next
/// block border. Nothing is repeated by itself; start() begins again after a failure.
class Operation : public QObject
{
    Q_OBJECT

public:
    using QObject::QObject;

    [[nodiscard]] OperationState state() const { return m_state; }
    [[nodiscard]] bool isOver() const { return m_state > OperationState::Running; }
    /// Why it failed; empty in the other states.
    [[nodiscard]] const std::optional<values::Error> &error() const { return m_error; }
    /// How long it took, or has taken so far.
    [[nodiscard]] session::Milliseconds duration() const;

    /// Does nothing while it runs or after it was done.
    void start();
    /// Waiting again after Failed or Cancelled; does nothing in the other states.
    void reset();
    /// Ends it at the next block border; what cannot be stopped any more still happens.
    void cancel();

Q_SIGNALS:
    void progressed();
    /// It is Done, Failed or Cancelled. Never from within start() or cancel().
    void finished();

protected:
    virtual void run() = 0;
    /// What is under way is to come back with Cancelled.
    virtual void interrupt() = 0;
    /// What it is when the session goes away in the middle.
    [[nodiscard]] virtual values::ErrorKind lossKind() const { return values::ErrorKind::NoAnswer; }
    /// The requests go to this session. If it goes away, because the link was closed, the operation fails.
    void use(session::FileSession &session);
    [[nodiscard]] session::FileSession *session() const { return m_session; }
    void finish(const values::Result<void> &result);
    /// Cancelled between two steps.
    [[nodiscard]] bool isCancelling() const { return m_isCancelling; }

private:
    void begin();

    QPointer<session::FileSession> m_session;
    bool m_usesSession = false;
    OperationState m_state = OperationState::Waiting;
    std::optional<values::Error> m_error;
    session::Time m_startedAt {};
    session::Time m_endedAt {};
    bool m_isCancelling = false;
};

} // namespace files
