// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "virtualcontroller/responder.h"

#include "protocol/catalog.h"
#include "protocol/payloads.h"
#include "virtualcontroller/access.h"
#include "virtualcontroller/frames.h"
#include "virtualcontroller/handlers.h"
#include "virtualcontroller/machine.h"

using protocol::ClientPacket;
using protocol::Request;
using protocol::Service;

namespace virtualcontroller {

namespace {

/// The request without what real controllers let pass: a whole word for an I/O group, and an S variable that is not
/// padded (reference §12, conflicts 21 and 22).
Request tidied(Request request)
{
    const bool isWrite = protocol::requestPayload(request.service) == protocol::PayloadKind::Value;
    const auto *command = protocol::findCommand(request.command);
    const qsizetype size = request.payload.size();
    if (isWrite && request.command == 0x78 && size == 4)
        request.payload.truncate(1);
    if (isWrite && (request.command == 0x7E || request.command == 0x8C) && size > 0 && size < command->size)
        request.payload.append(command->size - size, '\0');
    return request;
}

bool isRefusedElementOfP(const Request &request, const Memory &memory)
{
    return memory.settings.refusesElementsOfP && request.command == 0x7F
        && (request.service == Service::GetSingle || request.service == Service::SetSingle);
}

/// Reference §1.7: address, size, values, state.
Answer answer(const Request &request, Memory &memory)
{
    if (const quint16 fault = protocol::addressFault(request, memory.dialect))
        return refused(fault);
    if (isRefusedElementOfP(request, memory))
        return refused(AttributeFault);
    const Handler *handler = findHandler(request.command);
    if (!handler)
        return refused(CommandFault);
    if (const quint16 fault = handler->check ? handler->check(request, memory) : 0)
        return refused(fault);
    if (const quint16 refusal = accessRefusal(request, memory))
        return refused(refusal);
    return handler->execute(request, memory);
}

} // namespace

bool isWaitingForPower(QByteArrayView datagram, const Memory &memory)
{
    constexpr quint16 servo = 2;
    const auto packet = protocol::parseClientPacket(datagram);
    const auto word = packet ? protocol::decode<values::ControlWord>(packet->payload) : values::badInput({});
    const bool isServoOn = word && word->value == 1 && packet->command == 0x83 && packet->instance == servo
        && packet->service == Service::SetSingle;
    return isServoOn && memory.servoOnAt;
}

QByteArray servoOnReply(QByteArrayView datagram, const Memory &memory)
{
    constexpr quint16 cannotBeSwitchedOn = 0x3450;
    const ClientPacket packet = protocol::peekClientPacket(datagram);
    return memory.status.isServoOn() ? successReply(packet, protocol::lastBlock, {})
                                     : refusalReply(packet, cannotBeSwitchedOn, memory.settings.usesBareStatuses);
}

std::optional<QByteArray> respond(QByteArrayView datagram, Memory &memory, Time now)
{
    advanceTo(memory, now);
    const FrameVerdict verdict =
        judgeFrame(datagram, protocol::Division::Robot, memory.settings.answersWrongIdentifier);
    if (verdict.isDropped)
        return std::nullopt;
    ClientPacket packet = protocol::peekClientPacket(datagram);
    packet.framing.division = protocol::Division::Robot; // a refusal of a wrong one is a good frame
    if (const quint16 fault = verdict.code ? verdict.code : requestFramingFault(packet.framing))
        return refusalReply(packet, fault);
    const Answer result = answer(tidied(packet.request()), memory);
    if (!result)
        return refusalReply(packet, result.error(), memory.settings.usesBareStatuses);
    return successReply(packet, protocol::lastBlock, *result);
}

} // namespace virtualcontroller
