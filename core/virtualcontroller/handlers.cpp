// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "virtualcontroller/handlers.h"

#include "protocol/payloads.h"
#include "virtualcontroller/machine.h"

using protocol::Request;
using values::ControlGroup;
using values::Status;

namespace virtualcontroller
{

namespace
{

template <typename Value>
Answer show(const Value &value, const Request &request)
{
    return protocol::encode(value, request.attribute);
}

quint16 checkEmpty(const Request &request, const Memory &) { return request.payload.isEmpty() ? 0 : SizeFault; }

Answer readStatus(const Request &request, Memory &memory) { return show(memory.status, request); }

Answer readJob(const Request &request, Memory &memory)
{
    if (request.instance > memory.tasks.size())
        return refused(InstanceFault);
    return show(memory.executingJob(memory.tasks[request.instance - 1U]), request);
}

Answer readAxisNames(const Request &request, Memory &memory)
{
    const ControlGroup instance {request.instance};
    const Group *group = memory.findGroup(instance);
    if (!group)
        return refused(InstanceFault);
    return show(instance.isCartesian() ? group->cartesianNames() : group->pulseNames(), request);
}

Answer readPosition(const Request &request, Memory &memory)
{
    const ControlGroup instance {request.instance};
    const Group *group = memory.findGroup(instance);
    if (!group)
        return refused(InstanceFault);
    values::Position position;
    position.type = instance.isCartesian() ? values::PositionType::Base : values::PositionType::Pulse;
    position.axes = instance.isCartesian() ? group->cartesianAt(memory.now) : group->pulsesAt(memory.now);
    return show(position, request);
}

Answer readSystemInformation(const Request &request, Memory &memory)
{
    const auto found = memory.systemInformation.find(request.instance);
    if (found == memory.systemInformation.end())
        return refused(InstanceFault);
    return show(found->second, request);
}

constexpr quint32 on = 1;
constexpr quint32 off = 2;

quint32 wordOf(const Request &request) { return qFromLittleEndian<quint32>(request.payload.data()); }

quint16 checkSwitch(const Request &request, const Memory &)
{
    if (request.payload.size() != 4)
        return SizeFault;
    return wordOf(request) == on || wordOf(request) == off ? 0 : RangeFault;
}

Answer switchPower(const Request &request, Memory &memory)
{
    const bool isOn = wordOf(request) == on;
    if (request.instance == 1)
        setHold(memory, Status::HeldByCommand, isOn);
    else if (request.instance == 2)
        switchServo(memory, isOn);
    else
        memory.interlocks.isPendantLocked = isOn;
    return QByteArray {};
}

constexpr std::array handlers {
    Handler {0x72, checkEmpty, readStatus},
    Handler {0x73, checkEmpty, readJob},
    Handler {0x74, checkEmpty, readAxisNames},
    Handler {0x75, checkEmpty, readPosition},
    Handler {0x83, checkSwitch, switchPower},
    Handler {0x89, checkEmpty, readSystemInformation},
};

} // namespace

const Handler *findHandler(quint16 command)
{
    const auto found = std::ranges::find(handlers, command, &Handler::command);
    return found == handlers.end() ? nullptr : &*found;
}

} // namespace virtualcontroller
