// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "values/error.h"
#include <QByteArray>
#include <QByteArrayView>

namespace protocol {

constexpr qsizetype headerSize = 32;
constexpr qsizetype maxPayloadSize = 479;
constexpr qsizetype maxPacketSize = headerSize + maxPayloadSize;
constexpr quint16 robotPort = 10040;
constexpr quint16 filePort = 10041;

/// Set in a block number: this block is the last one, or the only reply (reference §1.4).
constexpr quint32 lastBlock = 0x80000000U;

enum class Division : quint8 { Robot = 1, File = 2 };

/// Service codes (reference §1.3). A reply carries the request's code plus 0x80.
enum class Service : quint8 {
    GetSingle = 0x0E,
    GetAll = 0x01,
    SetSingle = 0x10,
    SetAll = 0x02,
    ReadPlural = 0x33,
    WritePlural = 0x34,
    DeleteFile = 0x09,
    LoadFile = 0x15, ///< Computer to controller.
    SaveFile = 0x16, ///< Controller to computer.
    ListFiles = 0x32,
};

constexpr quint8 replyService(Service service) { return quint8(quint8(service) + 0x80); }

/// What a request asks for, without the framing that the session adds.
struct Request {
    quint16 command = 0; ///< 0 for every file service.
    quint16 instance = 0;
    quint8 attribute = 0; ///< 0 means all elements.
    Service service = Service::GetAll;
    QByteArray payload = {};

    bool operator==(const Request &) const = default;
};

/// Framing fields that both directions share (reference §1.1).
struct Framing {
    Division division = Division::Robot;
    bool ack = false;
    quint8 id = 0;
    quint32 block = 0;

    bool operator==(const Framing &) const = default;
};

/// A client packet as it stands on the wire: request, block acknowledgement or upload block. Views the datagram.
struct ClientPacket {
    Framing framing;
    quint16 command = 0;
    quint16 instance = 0;
    quint8 attribute = 0;
    Service service = Service::GetAll; ///< Not checked against the table: it may hold any byte.
    QByteArrayView payload;

    [[nodiscard]] Request request() const { return {command, instance, attribute, service, payload.toByteArray()}; }
};

/// A controller packet as it stands on the wire. Views the datagram.
struct Reply {
    Framing framing;
    quint8 service = 0; ///< The request's service plus 0x80.
    quint8 status = 0; ///< 0 is done (reference §1.6).
    quint8 addedStatusSize = 0; ///< In 16-bit words; never needed to find the code.
    quint16 addedStatus = 0;
    QByteArrayView payload;

    [[nodiscard]] bool isRefusal() const { return status != 0; }
    [[nodiscard]] values::Error refusal() const { return {values::ErrorKind::Refused, status, addedStatus, {}}; }
};

/// Why a datagram is not a packet. The virtual controller answers each as reference §1.7 says.
enum class FrameFault {
    None,
    TooShort, ///< Under 32 bytes.
    Identifier, ///< Does not start with YERC.
    HeaderSize, ///< Not 32.
    PayloadSize, ///< The size announced and the bytes received differ.
    TooLarge, ///< Over 511 bytes.
    Division, ///< Neither 1 nor 2.
    Ack, ///< Neither 0 nor 1, or 0 in a reply.
};

[[nodiscard]] FrameFault checkFrame(QByteArrayView datagram);
/// A sentence for a frame fault, untranslated, for logs and decoders.
[[nodiscard]] QString toString(FrameFault fault);

/// The packet in `datagram`, which must outlive it; Malformed with the reason otherwise.
[[nodiscard]] values::Result<ClientPacket> parseClientPacket(QByteArrayView datagram);
[[nodiscard]] values::Result<Reply> parseReply(QByteArrayView datagram);

/// The header fields alone, without any check but the size: for a responder that must answer a faulty frame.
/// `datagram` holds at least 32 bytes.
[[nodiscard]] ClientPacket peekClientPacket(QByteArrayView datagram);

[[nodiscard]] QByteArray encode(const Request &request, const Framing &framing);
[[nodiscard]] QByteArray encode(const Reply &reply);

} // namespace protocol
