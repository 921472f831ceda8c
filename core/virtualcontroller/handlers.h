// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "protocol/catalog.h"
#include "virtualcontroller/memory.h"

namespace virtualcontroller
{

/// The payload of a reply, or the added status of a refusal (reference §9).
using Answer = tl::expected<QByteArray, quint16>;

/// Added statuses that a request earns by itself, whatever the controller does.
enum Fault : quint16 {
    CommandFault = 0xA000,
    InstanceFault = 0xA001,
    AttributeFault = 0xA002,
    ServiceFault = 0x1010,
    NotAccessible = 0xB002,
    SizeFault = 0xB003,
    RangeFault = 0xB004,
};

inline tl::unexpected<quint16> refused(quint16 code) { return tl::unexpected(code); }

/// What the virtual controller does with one command. `check` looks at the request's payload alone and returns its
/// added status or 0; `execute` is called when nothing stands against the request.
struct Handler {
    quint16 command;
    quint16 (*check)(const protocol::Request &, const Memory &);
    Answer (*execute)(const protocol::Request &, Memory &);
};

/// The row of a command; nullptr where the virtual controller has none.
[[nodiscard]] const Handler *findHandler(quint16 command);

} // namespace virtualcontroller
