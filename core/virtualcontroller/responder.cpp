// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "virtualcontroller/responder.h"

#include "virtualcontroller/access.h"
#include "virtualcontroller/frames.h"
#include "virtualcontroller/handlers.h"
#include "virtualcontroller/machine.h"

using protocol::ClientPacket;
using protocol::Command;
using protocol::Request;
using protocol::Service;

namespace virtualcontroller {

namespace {

bool isSingle(Service service) { return service == Service::GetSingle || service == Service::SetSingle; }

/// Element numbers with the single services, 0 with all others; a command of one element takes 0 or 1 there
/// (reference §1.3, §4.3).
bool hasAttribute(const Command &command, const Request &request)
{
    if (isSingle(request.service))
        return request.attribute >= 1 && request.attribute <= command.elements;
    return request.attribute == 0 || (request.attribute == 1 && command.elements == 1);
}

/// What is wrong with the address of a request, in the order of reference §1.7; 0 if nothing.
quint16 addressFault(const Request &request, const Memory &memory)
{
    const Command *command = protocol::findCommand(request.command);
    if (!command || !findHandler(request.command) || command->instances(memory.dialect()).isEmpty())
        return CommandFault;
    if (!command->hasInstance(request.instance, memory.dialect()))
        return InstanceFault;
    if (!hasAttribute(*command, request))
        return AttributeFault;
    return command->hasService(request.service) ? 0 : ServiceFault;
}

Answer answer(const Request &request, Memory &memory)
{
    if (const quint16 fault = addressFault(request, memory))
        return refused(fault);
    const Handler &handler = *findHandler(request.command);
    if (const quint16 fault = handler.check(request, memory))
        return refused(fault);
    if (const quint16 refusal = accessRefusal(request, memory))
        return refused(refusal);
    return handler.execute(request, memory);
}

} // namespace

std::optional<QByteArray> respond(QByteArrayView datagram, Memory &memory, Time now)
{
    advance(memory, now);
    const FrameVerdict verdict = judgeFrame(datagram, protocol::Division::Robot);
    if (verdict.isDropped)
        return std::nullopt;
    const ClientPacket packet = protocol::peekClientPacket(datagram);
    if (const quint16 fault = verdict.code ? verdict.code : robotFramingFault(packet.framing))
        return refusalReply(packet, fault, false);
    const Answer result = answer(packet.request(), memory);
    if (!result)
        return refusalReply(packet, result.error(), memory.settings.usesBareStatuses);
    return successReply(packet, protocol::lastBlock, *result);
}

} // namespace virtualcontroller
