// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "demo.h"

#include "virtualcontroller/server.h"

namespace pendesk {

using virtualcontroller::Server;

Demo::Demo() = default;
Demo::~Demo() = default;

values::Result<settings::Profile> Demo::start()
{
    if (!m_server) {
        virtualcontroller::Options options;
        options.port = 0;
        options.filePort = 0;
        auto server = std::make_unique<Server>(options);
        server->memory() = virtualcontroller::Memory::demo();
        if (auto started = server->start(); !started)
            return tl::unexpected(started.error());
        m_server = std::move(server);
    }
    settings::Profile profile;
    profile.name = QStringLiteral("Demo");
    profile.host = QStringLiteral("127.0.0.1");
    profile.port = m_server->port();
    profile.filePort = m_server->filePort();
    profile.isSimulation = true;
    return profile;
}

} // namespace pendesk
