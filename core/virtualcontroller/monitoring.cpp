// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
// What can be read of the controller's state: reference §3.
#include "protocol/payloads.h"
#include "virtualcontroller/handlers.h"

using protocol::Request;
using values::ControlGroup;
using values::Status;

namespace virtualcontroller {

namespace {

/// An empty slot is all zeros, not a refusal (reference §3.1).
values::AlarmWithTexts activeAlarm(const Request &request, const Memory &memory)
{
    const std::size_t slot = request.instance - 1U;
    return slot < memory.alarms.size() ? memory.alarms[slot].alarm : values::AlarmWithTexts {};
}

values::AlarmWithTexts pastAlarm(const Request &request, const Memory &memory)
{
    const auto history = memory.histories.find(values::AlarmHistoryClass(request.instance / 1000 * 1000));
    const std::size_t entry = request.instance % 1000 - 1U;
    if (history == memory.histories.end() || entry >= history->second.size())
        return {};
    return history->second[entry];
}

Answer readAlarm(const Request &request, Memory &memory) { return show(activeAlarm(request, memory).alarm, request); }
Answer readAlarmTexts(const Request &request, Memory &memory) { return show(activeAlarm(request, memory), request); }
Answer readPastAlarm(const Request &request, Memory &memory) { return show(pastAlarm(request, memory).alarm, request); }
Answer readPastAlarmTexts(const Request &request, Memory &memory) { return show(pastAlarm(request, memory), request); }

Answer readStatus(const Request &request, Memory &memory) { return show(memory.status, request); }

Answer readJob(const Request &request, Memory &memory)
{
    if (request.instance > memory.tasks.size())
        return refused(InstanceFault);
    return show(memory.executingJob(memory.tasks[request.instance - 1U]), request);
}

/// What `function(group)` tells of the addressed group; a group that is not configured is an instance fault.
template <typename Function> Answer ofGroup(const Request &request, const Memory &memory, Function function)
{
    const Group *group = memory.findGroup({request.instance});
    return group ? show(function(*group), request) : Answer {refused(InstanceFault)};
}

Answer readAxisNames(const Request &request, Memory &memory)
{
    const bool isCartesian = ControlGroup {request.instance}.isCartesian();
    return ofGroup(
        request, memory, [&](const Group &group) { return isCartesian ? group.cartesianNames() : group.pulseNames(); });
}

Answer readPosition(const Request &request, Memory &memory)
{
    const bool isCartesian = ControlGroup {request.instance}.isCartesian();
    return ofGroup(request, memory, [&](const Group &group) {
        values::Position position;
        position.type = isCartesian ? values::PositionType::Base : values::PositionType::Pulse;
        position.axes = isCartesian ? group.cartesianAt(memory.now) : group.pulsesAt(memory.now);
        return position;
    });
}

Answer readFollowingError(const Request &request, Memory &memory)
{
    return ofGroup(request, memory,
        [&](const Group &group) { return values::FollowingError {group.followingErrorAt(memory.now)}; });
}

Answer readTorque(const Request &request, Memory &memory)
{
    return ofGroup(request, memory,
        [&](const Group &group) { return values::Torque {group.torqueAt(memory.now, memory.status.isServoOn())}; });
}

/// The value of a map by instance; what is not entered does not exist on this controller.
template <auto map> Answer readEntry(const Request &request, Memory &memory)
{
    const auto found = (memory.*map).find(request.instance);
    return found == (memory.*map).end() ? Answer {refused(InstanceFault)} : show(found->second, request);
}

/// "18:19'02", hours without padding (reference §3.9).
QByteArray elapsedText(Time elapsed)
{
    const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(elapsed).count();
    return QStringLiteral("%1:%2'%3")
        .arg(seconds / 3600)
        .arg(seconds / 60 % 60, 2, 10, QLatin1Char('0'))
        .arg(seconds % 60, 2, 10, QLatin1Char('0'))
        .toLatin1();
}

Answer readTime(const Request &request, Memory &memory)
{
    const auto found = memory.times.find(request.instance);
    if (found == memory.times.end())
        return refused(InstanceFault);
    const auto &[start, elapsed] = found->second;
    const QByteArray startText = start.toString(QStringLiteral("yyyy/MM/dd HH:mm")).toLatin1();
    return show(
        values::ManagementTime {values::FixedText<16> {startText}, values::FixedText<12> {elapsedText(elapsed)}},
        request);
}

} // namespace

std::span<const Handler> monitoringHandlers()
{
    static constexpr std::array rows {
        Handler {0x70, nullptr, readAlarm},
        Handler {0x71, nullptr, readPastAlarm},
        Handler {0x72, nullptr, readStatus},
        Handler {0x73, nullptr, readJob},
        Handler {0x74, nullptr, readAxisNames},
        Handler {0x75, nullptr, readPosition},
        Handler {0x76, nullptr, readFollowingError},
        Handler {0x77, nullptr, readTorque},
        Handler {0x88, nullptr, readTime},
        Handler {0x89, nullptr, readEntry<&Memory::systemInformation>},
        Handler {0x30A, nullptr, readAlarmTexts},
        Handler {0x30B, nullptr, readPastAlarmTexts},
        Handler {0x411, nullptr, readEntry<&Memory::encoderTemperatures>},
        Handler {0x413, nullptr, readEntry<&Memory::converterTemperatures>},
    };
    return rows;
}

} // namespace virtualcontroller
