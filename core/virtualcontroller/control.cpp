// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
// Orders without data to speak of: reference §6 and §6.1.
#include "protocol/payloads.h"
#include "virtualcontroller/alarms.h"
#include "virtualcontroller/handlers.h"
#include "virtualcontroller/machine.h"

using protocol::Request;
using values::ControlWord;
using values::CycleMode;
using values::Status;

namespace virtualcontroller {

namespace {

constexpr quint32 onWord = 1;
constexpr quint32 offWord = 2;

quint32 wordOf(const Request &request) { return protocol::decode<ControlWord>(request.payload)->value; }

/// The word lies in first..last.
template <quint32 first, quint32 last> quint16 checkWord(const Request &request, const Memory &)
{
    const quint32 word = wordOf(request);
    return word >= first && word <= last ? 0 : RangeFault;
}

Answer reset(const Request &request, Memory &memory)
{
    request.instance == 1 ? resetAlarms(memory) : cancelError(memory);
    return QByteArray {};
}

Answer switchPower(const Request &request, Memory &memory)
{
    const bool isOn = wordOf(request) == onWord;
    if (request.instance == 1)
        setHold(memory, Status::HeldByCommand, isOn);
    else if (request.instance == 2)
        switchServo(memory, isOn);
    else
        memory.interlocks.isPendantLocked = isOn;
    return QByteArray {};
}

Answer selectCycle(const Request &request, Memory &memory)
{
    setCycle(memory, CycleMode(wordOf(request)));
    return QByteArray {};
}

/// 30 characters, padded or not (reference §6).
quint16 checkText(const Request &request, const Memory &)
{
    const auto message = *protocol::decode<values::PendantText>(request.payload);
    return message.text.bytes().size() <= values::PendantText::maxBytes ? 0 : RangeFault;
}

Answer showText(const Request &request, Memory &memory)
{
    memory.pendantText = *protocol::decode<values::PendantText>(request.payload);
    return QByteArray {};
}

Answer start(const Request &, Memory &memory)
{
    startJob(memory);
    return QByteArray {};
}

quint16 checkSelection(const Request &request, const Memory &)
{
    constexpr quint32 lastLine = 9999;
    const auto selection = *protocol::decode<values::JobSelection>(request.payload);
    return selection.line <= lastLine && !selection.job.isEmpty() ? 0 : RangeFault;
}

Answer select(const Request &request, Memory &memory)
{
    const auto selection = protocol::decode<values::JobSelection>(request.payload);
    const QByteArray job = selection->job.bytes().toByteArray();
    if (request.instance == values::JobTarget::toExecute().instance) {
        selectJob(memory, 0, job, int(selection->line));
        return QByteArray {};
    }
    const std::size_t task = request.instance - values::JobTarget::masterOf(0).instance;
    if (task >= memory.tasks.size())
        return refused(InstanceFault);
    memory.tasks[task].master = job;
    return QByteArray {};
}

} // namespace

std::span<const Handler> controlHandlers()
{
    static constexpr std::array rows {
        Handler {0x82, checkWord<onWord, onWord>, reset},
        Handler {0x83, checkWord<onWord, offWord>, switchPower},
        Handler {0x84, checkWord<quint32(CycleMode::Step), quint32(CycleMode::Continuous)>, selectCycle},
        Handler {0x85, checkText, showText},
        Handler {0x86, checkWord<onWord, onWord>, start},
        Handler {0x87, checkSelection, select},
    };
    return rows;
}

} // namespace virtualcontroller
