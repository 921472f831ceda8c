// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "virtualcontroller/server.h"
#include <QCoreApplication>
#include <cstdio>

int main(int argc, char *argv[])
{
    const QCoreApplication application {argc, argv};
    virtualcontroller::Server server;
    if (const auto started = server.start(); !started) {
        std::fprintf(stderr, "pendesk-sim: %s\n", qPrintable(started.error().detail));
        return 1;
    }
    std::printf("pendesk-sim: YRC1000 ready on 127.0.0.1:%d, files %d\n", server.port(), server.filePort());
    std::fflush(stdout);
    return QCoreApplication::exec();
}
