// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "options.h"
#include "session/session.h"
#include "session/udptransport.h"
#include "station/station.h"
#include <QHostAddress>

namespace pendeskctl {

/// One controller as a verb sees it: both ports for reading, the station for what changes something, and the way out.
class Desk : public QObject
{
public:
    Desk(const Call &call, const QHostAddress &address);
    /// What was ordered is in the journal by then.
    ~Desk() override;

    [[nodiscard]] const Call &call() const { return m_call; }
    [[nodiscard]] session::Session &robot() { return m_robot; }
    [[nodiscard]] session::FileSession &files() { return m_files; }
    [[nodiscard]] protocol::Dialect dialect() const { return m_call.profile.dialect(); }
    [[nodiscard]] protocol::TextCodec codec() const { return protocol::TextCodec {m_call.profile.encoding}; }

    /// Asks the controller which model it is, unless the call told; then `next`. Ends the program without an answer.
    void identify(const std::function<void()> &next);
    /// Opens the station with the level that --yes gives, and goes on when it is monitored. Ends the program if it does
    /// not come to that.
    void openStation(const std::function<void()> &next);
    /// Only after openStation().
    [[nodiscard]] station::Station &station() const;

    /// Ends the program.
    void finish(ExitCode code);
    /// Ends it with the error in words.
    void fail(const values::Error &error);
    /// Says whom it is about: the controller, or `subject`.
    void complainOf(const values::Error &error, const QString &subject = {}) const;

private:
    struct Site;

    Call m_call;
    session::UdpTransport m_robotTransport;
    session::UdpTransport m_fileTransport;
    session::Session m_robot;
    session::FileSession m_files;
    std::unique_ptr<Site> m_site;
};

/// Calls `begin` from the event loop and runs until somebody calls Desk::finish(); the exit code.
[[nodiscard]] int run(const Call &call, const std::function<void(Desk &)> &begin);
/// As run(), with the station open.
[[nodiscard]] int change(const Call &call, const std::function<void(Desk &)> &begin);

} // namespace pendeskctl
