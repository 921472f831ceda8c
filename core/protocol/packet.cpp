// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "protocol/packet.h"

#include <QtEndian>

using values::ErrorKind;
using values::Result;

namespace protocol {

namespace {

constexpr QByteArrayView identifier = "YERC";
constexpr QByteArrayView reserve2 = "99999999";
constexpr quint8 reserve1 = 3;

// Offsets of the header, reference §1.1, §1.2 and §1.5. They are written nowhere else.
enum Offset {
    HeaderSizeAt = 4,
    PayloadSizeAt = 6,
    Reserve1At = 8,
    DivisionAt = 9,
    AckAt = 10,
    IdAt = 11,
    BlockAt = 12,
    Reserve2At = 16,
    CommandAt = 24,
    InstanceAt = 26,
    AttributeAt = 28,
    ServiceAt = 29,
    ReplyServiceAt = 24,
    StatusAt = 25,
    AddedStatusSizeAt = 26,
    AddedStatusAt = 28,
};

quint8 byteAt(QByteArrayView bytes, Offset at) { return quint8(bytes[at]); }
template <typename Number> Number numberAt(QByteArrayView bytes, Offset at)
{
    return qFromLittleEndian<Number>(bytes.data() + at);
}

Framing framingOf(QByteArrayView datagram)
{
    return {Division(byteAt(datagram, DivisionAt)), byteAt(datagram, AckAt) != 0, byteAt(datagram, IdAt),
        numberAt<quint32>(datagram, BlockAt)};
}

/// A packet with everything but the sub-header filled in.
QByteArray frame(const Framing &framing, QByteArrayView payload)
{
    Q_ASSERT(payload.size() <= maxPayloadSize);
    QByteArray packet(headerSize + payload.size(), Qt::Uninitialized);
    char *out = packet.data();
    memset(out, 0, headerSize);
    memcpy(out, identifier.data(), size_t(identifier.size()));
    qToLittleEndian(quint16(headerSize), out + HeaderSizeAt);
    qToLittleEndian(quint16(payload.size()), out + PayloadSizeAt);
    out[Reserve1At] = char(reserve1);
    out[DivisionAt] = char(framing.division);
    out[AckAt] = char(framing.ack ? 1 : 0);
    out[IdAt] = char(framing.id);
    qToLittleEndian(framing.block, out + BlockAt);
    memcpy(out + Reserve2At, reserve2.data(), size_t(reserve2.size()));
    if (!payload.isEmpty())
        memcpy(out + headerSize, payload.data(), size_t(payload.size()));
    return packet;
}

} // namespace

FrameFault checkFrame(QByteArrayView datagram)
{
    if (datagram.size() < headerSize)
        return FrameFault::TooShort;
    if (!datagram.startsWith(identifier))
        return FrameFault::Identifier;
    if (numberAt<quint16>(datagram, HeaderSizeAt) != headerSize)
        return FrameFault::HeaderSize;
    if (numberAt<quint16>(datagram, PayloadSizeAt) != datagram.size() - headerSize)
        return FrameFault::PayloadSize;
    if (datagram.size() > maxPacketSize)
        return FrameFault::TooLarge;
    if (const quint8 division = byteAt(datagram, DivisionAt); division != 1 && division != 2)
        return FrameFault::Division;
    if (byteAt(datagram, AckAt) > 1)
        return FrameFault::Ack;
    return FrameFault::None;
}

QString toString(FrameFault fault)
{
    switch (fault) {
    case FrameFault::None: return {};
    case FrameFault::TooShort: return QStringLiteral("shorter than the 32-byte header");
    case FrameFault::Identifier: return QStringLiteral("does not start with YERC");
    case FrameFault::HeaderSize: return QStringLiteral("header size is not 32");
    case FrameFault::PayloadSize: return QStringLiteral("announced and received payload sizes differ");
    case FrameFault::TooLarge: return QStringLiteral("larger than 511 bytes");
    case FrameFault::Division: return QStringLiteral("division is neither 1 nor 2");
    case FrameFault::Ack: return QStringLiteral("wrong ACK byte");
    }
    return {};
}

ClientPacket peekClientPacket(QByteArrayView datagram)
{
    Q_ASSERT(datagram.size() >= headerSize);
    return {framingOf(datagram), numberAt<quint16>(datagram, CommandAt), numberAt<quint16>(datagram, InstanceAt),
        byteAt(datagram, AttributeAt), Service(byteAt(datagram, ServiceAt)), datagram.sliced(headerSize)};
}

Result<ClientPacket> parseClientPacket(QByteArrayView datagram)
{
    if (const auto fault = checkFrame(datagram); fault != FrameFault::None)
        return values::failure(ErrorKind::Malformed, toString(fault));
    return peekClientPacket(datagram);
}

Result<Reply> parseReply(QByteArrayView datagram)
{
    auto fault = checkFrame(datagram);
    if (fault == FrameFault::None && byteAt(datagram, AckAt) != 1)
        fault = FrameFault::Ack;
    if (fault != FrameFault::None)
        return values::failure(ErrorKind::Malformed, toString(fault));
    return Reply {framingOf(datagram), byteAt(datagram, ReplyServiceAt), byteAt(datagram, StatusAt),
        byteAt(datagram, AddedStatusSizeAt), numberAt<quint16>(datagram, AddedStatusAt), datagram.sliced(headerSize)};
}

QByteArray encode(const Request &request, const Framing &framing)
{
    QByteArray packet = frame(framing, request.payload);
    char *out = packet.data();
    qToLittleEndian(request.command, out + CommandAt);
    qToLittleEndian(request.instance, out + InstanceAt);
    out[AttributeAt] = char(request.attribute);
    out[ServiceAt] = char(request.service);
    return packet;
}

QByteArray encode(const Reply &reply)
{
    QByteArray packet = frame(reply.framing, reply.payload);
    char *out = packet.data();
    out[ReplyServiceAt] = char(reply.service);
    out[StatusAt] = char(reply.status);
    out[AddedStatusSizeAt] = char(reply.addedStatusSize);
    qToLittleEndian(reply.addedStatus, out + AddedStatusAt);
    return packet;
}

} // namespace protocol
