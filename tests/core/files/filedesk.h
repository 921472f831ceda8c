// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "files/operation.h"
#include "session/udptransport.h"
#include "virtualcontroller/server.h"
#include <QSignalSpy>
#include <QTest>
#include <csignal>
#include <sys/resource.h>

/// A virtual controller on real sockets and a session to its file port.
struct FileDesk {
    explicit FileDesk(virtualcontroller::Faults faults = virtualcontroller::Faults {}, session::FilePolicy policy = {})
        : server {options(std::move(faults))},
          isStarted {server.start().has_value()},
          transport {QHostAddress {QHostAddress::LocalHost}, server.filePort()},
          session {transport, policy}
    {
        server.memory().files.clear();
    }

    static virtualcontroller::Options options(virtualcontroller::Faults faults)
    {
        virtualcontroller::Options options;
        options.port = 0;
        options.filePort = 0;
        options.faults = std::move(faults);
        return options;
    }

    /// Starts `operation` and waits for its end.
    [[nodiscard]] static bool finish(files::Operation &operation)
    {
        QSignalSpy finished {&operation, &files::Operation::finished};
        operation.start();
        return operation.isOver() || finished.wait(60000);
    }

    [[nodiscard]] std::map<QByteArray, QByteArray> &files() { return server.memory().files; }

    virtualcontroller::Server server;
    bool isStarted;
    session::UdpTransport transport;
    session::FileSession session;
};

/// Files of this process cannot grow beyond `bytes` while it lives: a full disk.
class FullDisk
{
public:
    explicit FullDisk(rlim_t bytes)
    {
        ::signal(SIGXFSZ, SIG_IGN);
        ::getrlimit(RLIMIT_FSIZE, &m_before);
        const rlimit limit {bytes, m_before.rlim_max};
        ::setrlimit(RLIMIT_FSIZE, &limit);
    }
    ~FullDisk() { ::setrlimit(RLIMIT_FSIZE, &m_before); }
    FullDisk(const FullDisk &) = delete;
    FullDisk &operator=(const FullDisk &) = delete;

private:
    rlimit m_before {};
};

/// A guard that lets everything pass.
inline files::Guard always()
{
    return [](QObject *, const std::function<void(const values::Result<void> &)> &handler) { handler({}); };
}

/// The smallest job there is, of about `lines` lines.
inline QByteArray jobText(const QByteArray &name, int lines = 0)
{
    QByteArray text = "/JOB\r\n//NAME " + name
        + "\r\n//POS\r\n///NPOS 0,0,0,0,0,0\r\n//INST\r\n///DATE 2026/01/12 08:30\r\n///ATTR SC,RW\r\n///GROUP1 "
          "RB1\r\nNOP\r\n";
    for (int line = 0; line < lines; ++line)
        text += "SET B000 " + QByteArray::number(line) + "\r\n";
    return text + "END\r\n";
}
