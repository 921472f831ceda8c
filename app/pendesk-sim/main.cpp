// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "options.h"

#include <QCoreApplication>
#include <QHostAddress>
#include <QTimer>
#include <csignal>
#include <cstdio>

using virtualcontroller::Server;

namespace {

enum ExitCode { Done = 0, Failed = 1, WrongUsage = 2 };

volatile std::sig_atomic_t isEnding = 0;

/// All that may be done inside a signal handler: the event loop does the rest.
void passOn(int) { isEnding = 1; }

/// Ends the event loop on SIGINT and SIGTERM, within a tenth of a second.
void endOnSignals(QTimer &look)
{
    QObject::connect(&look, &QTimer::timeout, [] {
        if (isEnding)
            QCoreApplication::quit();
    });
    look.start(std::chrono::milliseconds {100});
    std::signal(SIGINT, passOn);
    std::signal(SIGTERM, passOn);
}

int complain(const values::Error &error)
{
    std::fprintf(stderr, "pendesk-sim: %s\n", qPrintable(error.detail));
    if (error.kind != values::ErrorKind::BadInput)
        return Failed;
    std::fputs(qPrintable(usage()), stderr);
    return WrongUsage;
}

/// "127.0.0.1:10040, files 10041", for several controllers each in turn.
QString portsOf(const std::vector<std::unique_ptr<Server>> &servers, const QString &address)
{
    QStringList texts;
    for (const auto &server : servers)
        texts += QStringLiteral("%1:%2, files %3").arg(address).arg(server->port()).arg(server->filePort());
    return texts.join(QStringLiteral("; "));
}

/// One server after the other; each pair of ports follows the one before.
values::Result<std::vector<std::unique_ptr<Server>>> startAll(const SimOptions &options)
{
    std::vector<std::unique_ptr<Server>> servers;
    for (int index = 0; index < options.count; ++index) {
        auto one = options.server;
        one.port = quint16(one.port == 0 ? 0 : one.port + 2 * index);
        one.filePort = quint16(one.filePort == 0 ? 0 : one.filePort + 2 * index);
        servers.push_back(std::make_unique<Server>(one));
        servers.back()->setMemory(options.memory);
        if (const auto started = servers.back()->start(); !started)
            return tl::unexpected(started.error());
    }
    return servers;
}

} // namespace

int main(int argc, char *argv[])
{
    QCoreApplication application {argc, argv};
    const auto options = parseOptions(QCoreApplication::arguments());
    if (!options)
        return complain(options.error());
    if (!options->ended.isEmpty()) {
        std::fputs(qPrintable(options->ended), stdout);
        return Done;
    }
    const auto servers = startAll(*options);
    if (!servers)
        return complain(servers.error());
    if (!QHostAddress {options->server.address}.isLoopback())
        std::fprintf(stderr,
            "pendesk-sim: Warning: %s can be reached from other computers. Whoever finds this virtual controller can "
            "use it; it knows no password, as a real one.\n",
            qPrintable(options->server.address));
    QTimer look;
    endOnSignals(look);
    std::printf("pendesk-sim: %s ready on %s\n", options->memory.dialect.name,
        qPrintable(portsOf(*servers, options->server.address)));
    std::fflush(stdout);
    return QCoreApplication::exec();
}
