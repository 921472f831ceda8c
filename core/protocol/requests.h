// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "protocol/datarequests.h"
#include "protocol/requestkinds.h"

namespace protocol {

// Monitoring, reference §3.

struct ReadAlarm : ReadAll<0x70, values::Alarm> {
    /// `slot` is 1 to values::activeAlarmCount, 1 the newest.
    explicit ReadAlarm(int slot = 1) { instance = quint16(slot); }
};

struct ReadAlarmWithTexts : ReadAll<0x30A, values::AlarmWithTexts> {
    explicit ReadAlarmWithTexts(int slot = 1) { instance = quint16(slot); }
};

struct ReadAlarmHistory : ReadAll<0x71, values::Alarm> {
    /// `entry` is 1 to values::alarmHistoryLength, 1 the newest.
    ReadAlarmHistory(values::AlarmHistoryClass list, int entry) { instance = quint16(int(list) + entry); }
};

struct ReadAlarmHistoryWithTexts : ReadAll<0x30B, values::AlarmWithTexts> {
    ReadAlarmHistoryWithTexts(values::AlarmHistoryClass list, int entry) { instance = quint16(int(list) + entry); }
};

struct ReadStatus : ReadAll<0x72, values::Status> {
};

struct ReadExecutingJob : ReadAll<0x73, values::ExecutingJob> {
    /// `task` 0 is the master task, 1.. the sub tasks.
    explicit ReadExecutingJob(int task = 0) { instance = quint16(1 + task); }
};

/// Reads something of a control group.
template <quint16 command, typename Value, quint8 attribute = 0> struct ReadGroup : ReadAll<command, Value, attribute> {
    explicit ReadGroup(values::ControlGroup group) { this->instance = group.instance; }
};

struct ReadAxisNames : ReadGroup<0x74, values::AxisNames> {
    using ReadGroup::ReadGroup;
};

struct ReadPosition : ReadGroup<0x75, values::Position> {
    using ReadGroup::ReadGroup;
};

struct ReadFollowingError : ReadGroup<0x76, values::FollowingError> {
    using ReadGroup::ReadGroup;
};

struct ReadTorque : ReadGroup<0x77, values::Torque> {
    using ReadGroup::ReadGroup;
};

struct ReadEncoderTemperatures : ReadGroup<0x411, values::EncoderTemperatures, 1> {
    using ReadGroup::ReadGroup;
};

struct ReadConverterTemperature : ReadAll<0x413, values::ConverterTemperature, 1> {
    /// `board` is the servo board, 1 or 2.
    explicit ReadConverterTemperature(int board = 1) { instance = quint16(board); }
};

struct ReadManagementTime : ReadAll<0x88, values::ManagementTime> {
    explicit ReadManagementTime(values::ManagementTimeCounter counter) { instance = counter.instance; }
};

struct ReadSystemInformation : ReadAll<0x89, values::SystemInformation> {
    static ReadSystemInformation robot(int robot) { return {{quint16(10 + robot)}}; }
    static ReadSystemInformation station(int station) { return {{quint16(20 + station)}}; }
    static ReadSystemInformation application(int application) { return {{quint16(100 + application)}}; }
};

// Control, reference §6.

struct ResetAlarm : Control<0x82, 1, 1, Effect::Writes> {
};
struct CancelError : Control<0x82, 2, 1, Effect::Writes> {
};
struct HoldOn : Control<0x83, 1, 1, Effect::Stops> {
};
struct HoldOff : Control<0x83, 1, 2, Effect::Writes> {
};
struct ServoOn : Control<0x83, 2, 1, Effect::Starts> {
};
struct ServoOff : Control<0x83, 2, 2, Effect::Stops> {
};
struct HlockOn : Control<0x83, 3, 1, Effect::Writes> {
};
struct HlockOff : Control<0x83, 3, 2, Effect::Writes> {
};
struct StartJob : Control<0x86, 1, 1, Effect::Starts> {
};

struct SelectCycle : WriteElement<0x84, values::CycleSelection> {
    explicit SelectCycle(values::CycleMode mode) : WriteElement {2, {mode}} { }
};

struct ShowPendantText : WriteElement<0x85, values::PendantText> {
    explicit ShowPendantText(values::PendantText text) : WriteElement {1, text} { }
};

struct SelectJob : WriteAll<0x87, values::JobSelection> {
    explicit SelectJob(values::JobSelection selection, values::JobTarget target = values::JobTarget::toExecute())
        : WriteAll {target.instance, selection}
    {
    }
};

struct MoveCartesian : WriteAll<0x8A, values::CartesianTarget, 1, Effect::Moves> {
    MoveCartesian(values::CartesianMove type, const values::CartesianTarget &target) : WriteAll {quint16(type), target}
    {
    }
};

struct MovePulse : WriteAll<0x8B, values::PulseTarget, 1, Effect::Moves> {
    MovePulse(values::PulseMove type, const values::PulseTarget &target) : WriteAll {quint16(type), target} { }
};

} // namespace protocol
