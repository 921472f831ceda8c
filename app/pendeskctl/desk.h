// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "files/operation.h"
#include "options.h"
#include "session/session.h"
#include "session/udptransport.h"
#include <QHostAddress>

namespace pendeskctl {

/// One controller as a verb sees it: both ports, and the way out.
class Desk : public QObject
{
public:
    Desk(const Call &call, const QHostAddress &address);

    [[nodiscard]] const Call &call() const { return m_call; }
    [[nodiscard]] session::Session &robot() { return m_robot; }
    [[nodiscard]] session::FileSession &files() { return m_files; }
    [[nodiscard]] protocol::Dialect dialect() const { return m_call.profile.dialect(); }
    [[nodiscard]] protocol::TextCodec codec() const { return protocol::TextCodec {m_call.profile.encoding}; }

    /// Files may be changed: asked of the controller each time it is called. Never while a job runs.
    [[nodiscard]] files::Guard guard();

    /// Ends the program.
    void finish(ExitCode code);
    /// Ends it with the error in words.
    void fail(const values::Error &error);
    /// Says whom it is about: the controller, or `subject`.
    void complainOf(const values::Error &error, const QString &subject = {}) const;

private:
    Call m_call;
    session::UdpTransport m_robotTransport;
    session::UdpTransport m_fileTransport;
    session::Session m_robot;
    session::FileSession m_files;
};

/// Calls `begin` from the event loop and runs until somebody calls Desk::finish(); the exit code.
[[nodiscard]] int run(const Call &call, const std::function<void(Desk &)> &begin);

} // namespace pendeskctl
