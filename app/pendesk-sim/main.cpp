// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "options.h"

#include <QCoreApplication>
#include <QSocketNotifier>
#include <csignal>
#include <cstdio>
#include <sys/socket.h>
#include <unistd.h>

using virtualcontroller::Server;

namespace {

enum ExitCode { Done = 0, Failed = 1, WrongUsage = 2 };

int signalPipe[2];

/// All that may be done inside a signal handler: the event loop does the rest.
void passOn(int)
{
    const char byte = 1;
    [[maybe_unused]] const auto written = write(signalPipe[1], &byte, 1);
}

/// Ends the event loop on SIGINT and SIGTERM.
void endOnSignals(QCoreApplication &application)
{
    if (socketpair(AF_UNIX, SOCK_STREAM, 0, signalPipe) != 0)
        return;
    auto *notifier = new QSocketNotifier {signalPipe[0], QSocketNotifier::Read, &application};
    QObject::connect(notifier, &QSocketNotifier::activated, &application, &QCoreApplication::quit);
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
    endOnSignals(application);
    std::printf("pendesk-sim: %s ready on %s\n", options->memory.dialect.name,
        qPrintable(portsOf(*servers, options->server.address)));
    std::fflush(stdout);
    return QCoreApplication::exec();
}
