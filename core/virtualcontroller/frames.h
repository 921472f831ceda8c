// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "protocol/packet.h"

/// Frames as the controller judges and makes them (reference §1.4, §1.5, §1.7).
namespace virtualcontroller {

/// Why a packet is refused before its service is looked at (reference §1.7).
enum FrameCode : quint16 {
    TooLarge = 0xE49E,
    WrongBlock = 0xE4A1,
    WrongAck = 0xE4A2,
    WrongDivision = 0xE4A3,
    WrongHeaderSize = 0xE4A5,
    WrongIdentifier = 0xE4A6,
    WrongPayloadSize = 0xE4A7,
};

/// What becomes of a datagram before anybody looks at what it asks for.
struct FrameVerdict {
    bool isDropped = false; ///< Nothing is answered.
    quint16 code = 0; ///< The added status to refuse it with, 0 for a good frame.
};

/// Frame faults of a datagram that came to the port of `division`. A wrong identifier is dropped or answered 0xE4A6.
[[nodiscard]] FrameVerdict judgeFrame(
    QByteArrayView datagram, protocol::Division division, bool answersWrongIdentifier = false);
/// A request has ACK 0 and block 0. An added status or 0.
[[nodiscard]] quint16 requestFramingFault(const protocol::Framing &framing);

/// A reply without payload. `bare`: 0xA000, 0xA001 and 0xA002 become the statuses 0x08, 0x28 and 0x09 (reference §1.6).
[[nodiscard]] QByteArray refusalReply(const protocol::ClientPacket &packet, quint16 code, bool bare = false);
[[nodiscard]] QByteArray successReply(const protocol::ClientPacket &packet, quint32 block, QByteArrayView payload);

} // namespace virtualcontroller
