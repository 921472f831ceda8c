// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "virtualcontroller/frames.h"

using protocol::ClientPacket;
using protocol::FrameFault;

namespace virtualcontroller {

namespace {

quint16 codeOf(FrameFault fault)
{
    switch (fault) {
    case FrameFault::HeaderSize: return WrongHeaderSize;
    case FrameFault::PayloadSize: return WrongPayloadSize;
    case FrameFault::TooLarge: return TooLarge;
    case FrameFault::Division: return WrongDivision;
    case FrameFault::Ack: return WrongAck;
    case FrameFault::None:
    case FrameFault::TooShort:
    case FrameFault::Identifier: break;
    }
    return 0;
}

quint8 bareStatus(quint16 code)
{
    switch (code) {
    case 0xA000: return 0x08;
    case 0xA001: return 0x28;
    case 0xA002: return 0x09;
    default: return 0;
    }
}

protocol::Reply replyTo(const ClientPacket &packet, quint32 block)
{
    protocol::Reply reply;
    reply.framing = {packet.framing.division, true, packet.framing.id, block};
    reply.service = protocol::replyService(packet.service);
    return reply;
}

} // namespace

FrameVerdict judgeFrame(QByteArrayView datagram, protocol::Division division, bool answersWrongIdentifier)
{
    const FrameFault fault = protocol::checkFrame(datagram);
    if (fault == FrameFault::Identifier && answersWrongIdentifier)
        return {false, WrongIdentifier};
    if (fault == FrameFault::TooShort || fault == FrameFault::Identifier)
        return {true, 0};
    if (fault == FrameFault::None && protocol::peekClientPacket(datagram).framing.division != division)
        return {false, WrongDivision};
    return {false, codeOf(fault)};
}

quint16 requestFramingFault(const protocol::Framing &framing)
{
    if (framing.ack)
        return WrongAck;
    return framing.block == 0 ? 0 : WrongBlock;
}

QByteArray refusalReply(const ClientPacket &packet, quint16 code, bool bare)
{
    protocol::Reply reply = replyTo(packet, protocol::lastBlock);
    const quint8 bareCode = bare ? bareStatus(code) : 0;
    reply.status = bareCode ? bareCode : 0x1F;
    reply.addedStatusSize = bareCode ? 0 : 1;
    reply.addedStatus = bareCode ? 0 : code;
    return protocol::encode(reply);
}

QByteArray successReply(const ClientPacket &packet, quint32 block, QByteArrayView payload)
{
    protocol::Reply reply = replyTo(packet, block);
    reply.payload = payload;
    return protocol::encode(reply);
}

} // namespace virtualcontroller
