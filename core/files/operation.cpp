// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "files/operation.h"

using values::ErrorKind;

namespace files {

session::Milliseconds Operation::duration() const
{
    if (m_state == OperationState::Waiting)
        return {};
    const session::Time end = isOver() ? m_endedAt : values::now();
    return std::chrono::duration_cast<session::Milliseconds>(end - m_startedAt);
}

void Operation::start()
{
    if (m_state == OperationState::Running || m_state == OperationState::Done)
        return;
    m_state = OperationState::Running;
    m_error.reset();
    m_isCancelling = false;
    m_startedAt = values::now();
    QMetaObject::invokeMethod(this, &Operation::begin, Qt::QueuedConnection);
}

void Operation::begin()
{
    if (m_usesSession && !m_session)
        finish(values::failure(ErrorKind::NotSent, QStringLiteral("the link was closed")));
    else
        run();
}

void Operation::use(session::FileSession &session)
{
    m_session = &session;
    m_usesSession = true;
    connect(&session, &QObject::destroyed, this, [this] {
        if (m_state == OperationState::Running)
            finish(values::failure(lossKind()));
    });
}

void Operation::reset()
{
    if (m_state != OperationState::Failed && m_state != OperationState::Cancelled)
        return;
    m_state = OperationState::Waiting;
    m_error.reset();
}

void Operation::cancel()
{
    if (m_state == OperationState::Waiting) {
        m_state = OperationState::Cancelled;
        const auto tell = [this] {
            if (m_state == OperationState::Cancelled) // and not begun again meanwhile
                Q_EMIT finished();
        };
        QMetaObject::invokeMethod(this, tell, Qt::QueuedConnection);
    } else if (m_state == OperationState::Running) {
        m_isCancelling = true;
        interrupt();
    }
}

void Operation::finish(const values::Result<void> &result)
{
    m_endedAt = values::now();
    if (result)
        m_state = OperationState::Done;
    else if (result.error().kind == ErrorKind::Cancelled)
        m_state = OperationState::Cancelled;
    else
        m_state = OperationState::Failed;
    if (m_state == OperationState::Failed)
        m_error = result.error();
    Q_EMIT finished();
}

} // namespace files
