// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "protocol/catalog.h"
#include "virtualcontroller/memory.h"

namespace virtualcontroller {

/// The payload of a reply, or the added status of a refusal (reference §9).
using Answer = tl::expected<QByteArray, quint16>;

/// Added statuses that a request earns by itself, whatever the controller does (reference §9).
enum Fault : quint16 {
    CommandFault = 0xA000,
    InstanceFault = 0xA001,
    AttributeFault = 0xA002,
    Undefined = 0xB001,
    NotAccessible = 0xB002,
    RangeFault = 0xB004,
    GroupFault = 0xB008,
    SpeedFault = 0xB009,
    NoSpeed = 0xB00A,
    CoordinateFault = 0xB00B,
    TypeFault = 0xB00C,
    ToolFault = 0xB00D,
    UserFrameFault = 0xB00E,
};

inline tl::unexpected<quint16> refused(quint16 code) { return tl::unexpected(code); }

/// What the virtual controller does with one command. Address and size of the request have been checked.
struct Handler {
    quint16 command;
    /// Looks at the values of a request that fits: an added status or 0. May be missing.
    quint16 (*check)(const protocol::Request &, const Memory &);
    /// Called when nothing stands against the request.
    Answer (*execute)(const protocol::Request &, Memory &);
};

/// The row of a command; nullptr where the virtual controller has none.
[[nodiscard]] const Handler *findHandler(quint16 command);

// The rows, by chapter of the reference.
[[nodiscard]] std::span<const Handler> monitoringHandlers(); ///< §3
[[nodiscard]] std::span<const Handler> dataHandlers(); ///< §4
[[nodiscard]] std::span<const Handler> controlHandlers(); ///< §6
[[nodiscard]] std::span<const Handler> moveHandlers(); ///< §6.2, §6.3

/// The elements of a value that the request asks for.
template <typename Value> Answer show(const Value &value, const protocol::Request &request)
{
    return protocol::encode(value, request.service == protocol::Service::GetSingle ? request.attribute : 0);
}

} // namespace virtualcontroller
