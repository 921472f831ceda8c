// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "virtualcontroller/alarms.h"

#include "virtualcontroller/machine.h"
#include <algorithm>

using values::AlarmHistoryClass;
using values::Status;

namespace virtualcontroller {

AlarmHistoryClass historyClass(quint32 code)
{
    if (code < 4000)
        return AlarmHistoryClass::Major;
    if (code < 8000)
        return AlarmHistoryClass::Minor;
    return code < 9000 ? AlarmHistoryClass::UserSystem : AlarmHistoryClass::User;
}

void raiseAlarm(Memory &memory, values::AlarmWithTexts alarm, bool hasCause)
{
    if (alarm.alarm.time.isEmpty())
        alarm.alarm.time = memory.clockText();
    const AlarmHistoryClass kind = historyClass(alarm.alarm.code);
    memory.alarms.push_front({alarm, hasCause});
    auto &history = memory.histories[kind];
    history.push_front(alarm);
    history.resize(std::min<std::size_t>(history.size(), values::alarmHistoryLength));
    memory.status.data2.setFlag(Status::Alarm);
    stopRunning(memory);
    if (kind == AlarmHistoryClass::Major)
        switchServo(memory, false);
}

void raiseAlarm(Memory &memory, quint32 code, QByteArrayView name, values::AlarmData data)
{
    values::AlarmWithTexts alarm;
    alarm.alarm.code = code;
    alarm.alarm.data = data;
    alarm.alarm.name = values::FixedText<32> {name};
    raiseAlarm(memory, alarm);
}

void removeCause(Memory &memory, quint32 code)
{
    for (ActiveAlarm &active : memory.alarms)
        active.hasCause &= active.alarm.alarm.code != code;
}

void resetAlarms(Memory &memory)
{
    std::erase_if(memory.alarms, [](const ActiveAlarm &active) { return !active.hasCause; });
    memory.status.data2.setFlag(Status::Alarm, !memory.alarms.empty());
    cancelError(memory);
}

void raiseError(Memory &memory)
{
    memory.status.data2.setFlag(Status::Error);
    stopRunning(memory);
}

void cancelError(Memory &memory) { memory.status.data2.setFlag(Status::Error, false); }

} // namespace virtualcontroller
