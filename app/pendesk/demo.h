// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "settings/profile.h"
#include "values/error.h"
#include <memory>

namespace virtualcontroller {
class Server;
}

namespace pendesk {

/// The embedded virtual controller, on free ports of this computer's loopback.
class Demo
{
public:
    Demo();
    ~Demo();

    /// Starts it if it does not run yet; the profile says where it listens.
    [[nodiscard]] values::Result<settings::Profile> start();

private:
    std::unique_ptr<virtualcontroller::Server> m_server;
};

} // namespace pendesk
