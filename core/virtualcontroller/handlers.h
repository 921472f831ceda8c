// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "protocol/catalog.h"
#include "protocol/layout.h"
#include "virtualcontroller/memory.h"

namespace virtualcontroller {

/// The payload of a reply, or the added status of a refusal (reference §9).
using Answer = tl::expected<QByteArray, quint16>;

/// Added statuses that a request earns by itself, whatever the controller does (reference §9).
enum Fault : quint16 {
    CommandFault = 0xA000,
    InstanceFault = 0xA001,
    AttributeFault = 0xA002,
    /// The command does not know the service. The reference has no code for it; "command faulty" comes nearest.
    ServiceFault = 0x1010,
    ReplyTooLarge = 0xA101,
    Undefined = 0xB001,
    NotAccessible = 0xB002,
    SizeFault = 0xB003,
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

/// What the virtual controller does with one command, whose address has been checked.
struct Handler {
    quint16 command;
    /// Looks at the request alone: an added status or 0.
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

/// A request that reads carries nothing.
inline quint16 checkEmpty(const protocol::Request &request, const Memory &)
{
    return request.payload.isEmpty() ? 0 : SizeFault;
}

/// The elements that the request asks for; a single element and "all" are the same thing.
template <typename Value> Answer show(const Value &value, const protocol::Request &request)
{
    return protocol::encode(value, protocol::measure<Value>().elements == 1 ? 0 : request.attribute);
}

} // namespace virtualcontroller
