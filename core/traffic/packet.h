// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "protocol/packet.h"
#include <QList>
#include <chrono>

namespace traffic {

/// When a datagram passed the socket, by this computer's clock: microseconds since 1970, UTC.
using WallTime = std::chrono::sys_time<std::chrono::microseconds>;

/// An IPv4 address and a UDP port.
struct Endpoint {
    quint32 address = 0; ///< In host order: 0x7F000001 is 127.0.0.1.
    quint16 port = 0;

    bool operator==(const Endpoint &) const = default;
};

enum class Passage : quint8 { Sent, Received };

/// What the session did with a datagram.
enum class Fate : quint8 {
    Used, ///< It left, or it answered what was asked.
    Repeat, ///< It left once more, byte for byte.
    NotLeft, ///< This computer could not send it.
    Stranger, ///< It came from another address or port than the controller's, and was not looked at.
    Malformed, ///< It is no packet (reference §1.7).
    Mismatched, ///< Its id was that of an open request, its service was not.
    Duplicate, ///< Its request was answered before.
    Late, ///< Nobody waited for it any more.
};

/// Whether it was thrown away.
constexpr bool isDropped(Fate fate) { return fate >= Fate::Stranger; }

/// One datagram as it passed the socket of one port, in either direction.
struct Packet {
    quint64 number = 0; ///< Counted from 1, also past those that the ring has lost.
    WallTime at {};
    Passage passage = Passage::Sent;
    protocol::Division division = protocol::Division::Robot; ///< Of the socket, whatever the bytes say.
    Fate fate = Fate::Used;
    Endpoint own; ///< This computer; zeros where nobody knows.
    Endpoint other; ///< The controller, or the stranger.
    quint64 partner = 0; ///< Number of the packet that this one answers or repeats; 0 if there is none.
    QByteArray bytes; ///< From "YERC" on.

    bool operator==(const Packet &) const = default;
};

} // namespace traffic
