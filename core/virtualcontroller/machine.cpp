// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "virtualcontroller/machine.h"

#include "virtualcontroller/alarms.h"
#include "virtualcontroller/execution.h"
#include "virtualcontroller/kinematics.h"
#include "virtualcontroller/speed.h"
#include <algorithm>

using values::ControlGroup;
using values::CycleMode;
using values::Status;

namespace virtualcontroller {

namespace {

constexpr Time never = Time::max();

/// The next moment at which something happens by itself.
Time nextEvent(const Memory &memory)
{
    Time next = memory.servoOnAt.value_or(never);
    for (const Group &group : memory.groups)
        next = std::min(next, group.motion ? group.motion->end : never);
    return std::min(next, nextLine(memory));
}

bool isMoving(const Memory &memory)
{
    return std::ranges::any_of(memory.groups, [](const Group &group) { return group.motion.has_value(); });
}

/// Whether a counter runs at present, by its instance (reference §3.9).
bool isCounting(const Memory &memory, quint16 instance)
{
    using Kind = values::ManagementTimeKind;
    if (instance == quint16(Kind::ControlPower))
        return true;
    if (instance < quint16(Kind::Playback))
        return memory.status.isServoOn();
    if (instance < quint16(Kind::Motion))
        return memory.isJobRunning;
    return instance < quint16(Kind::Operation) ? isMoving(memory) : memory.isJobRunning;
}

void passTime(Memory &memory, Time now)
{
    const Time passed = now - memory.now;
    if (passed <= 0ms)
        return;
    for (auto &[instance, counter] : memory.times)
        counter.elapsed += isCounting(memory, instance) ? passed : 0ms;
    memory.now = now;
}

void happen(Memory &memory)
{
    if (memory.servoOnAt && *memory.servoOnAt <= memory.now) {
        memory.servoOnAt.reset();
        memory.status.data2.setFlag(Status::ServoOn);
    }
    for (Group &group : memory.groups)
        group.settle(memory.now);
    executeDueLines(memory);
    updateRunning(memory);
}

bool isWithinLimits(const values::AxisWords &pulses)
{
    return std::ranges::all_of(pulses, [](qint32 pulse) { return std::abs(qint64(pulse)) <= kinematics::pulseLimit; });
}

/// The axes that are outside the limits, as alarm data.
values::AlarmData axesOutside(const values::AxisWords &pulses)
{
    quint32 axes = 0;
    for (int axis = 0; axis < pulses.count(); ++axis)
        axes |= std::abs(qint64(pulses[axis])) > kinematics::pulseLimit ? 1U << axis : 0;
    return {axes, values::AlarmDataType::AxesSlurbt};
}

} // namespace

void advanceTo(Memory &memory, Time now)
{
    for (Time next = nextEvent(memory); next <= now; next = nextEvent(memory)) {
        passTime(memory, next);
        happen(memory);
    }
    passTime(memory, now);
}

void updateRunning(Memory &memory)
{
    memory.status.data1.setFlag(Status::Running, memory.isJobRunning || isMoving(memory));
}

void stopRunning(Memory &memory)
{
    memory.isJobRunning = false;
    for (Group &group : memory.groups)
        group.stop(memory.now);
    for (Task &task : memory.tasks)
        task.isExecuting = false;
    updateRunning(memory);
}

void switchServo(Memory &memory, bool on)
{
    if (on && memory.status.isServoOn())
        return;
    memory.servoOnAt.reset();
    if (on) {
        memory.servoOnAt = memory.now + memory.settings.servoDelay;
    } else {
        memory.status.data2.setFlag(Status::ServoOn, false);
        stopRunning(memory);
    }
}

void setHold(Memory &memory, Status::Data2Flag source, bool on)
{
    memory.status.data2.setFlag(source, on);
    if (on)
        stopRunning(memory);
}

void setTeachMode(Memory &memory)
{
    stopRunning(memory);
    setRemote(memory, false);
    memory.status.data1.setFlag(Status::Teach);
    memory.status.data1.setFlag(Status::Play, false);
}

void setPlayMode(Memory &memory)
{
    memory.status.data1.setFlag(Status::Teach, false);
    memory.status.data1.setFlag(Status::Play);
}

void setRemote(Memory &memory, bool on)
{
    const bool isRemote = on && !memory.status.isTeach();
    if (isRemote != memory.status.isRemote() && memory.transfer)
        memory.transfer->isCutOff = true;
    memory.status.data1.setFlag(Status::Remote, isRemote);
}

void setCycle(Memory &memory, CycleMode cycle)
{
    memory.status.data1.setFlag(Status::Step, cycle == CycleMode::Step);
    memory.status.data1.setFlag(Status::OneCycle, cycle == CycleMode::OneCycle);
    memory.status.data1.setFlag(Status::Continuous, cycle == CycleMode::Continuous);
}

void selectJob(Memory &memory, int task, const QByteArray &job, int line)
{
    const auto program = memory.program(job);
    const int last = int(program->lines.size()) - 1;
    Task &chosen = memory.tasks[std::size_t(task)];
    chosen.stack = {{program, std::min(line, last)}};
    chosen.isExecuting = false;
}

void startJob(Memory &memory)
{
    memory.isJobRunning = true;
    memory.tasks.front().due = memory.now;
    updateRunning(memory);
}

bool moveGroup(
    Memory &memory, ControlGroup which, values::AxisWords target, GroupWords unit, values::Speed speed, double share)
{
    Group &group = *memory.findGroup(which);
    target.resize(group.pose.count());
    const auto pulses = unit == GroupWords::Pulses ? target : kinematics::toPulses(target);
    if (!isWithinLimits(pulses)) {
        raiseAlarm(memory, 4416, "PULSE LIMIT(MIN/MAX)", axesOutside(pulses));
        return false;
    }
    const auto pose = !group.isRobot() ? pulses : unit == GroupWords::Pulses ? kinematics::toCartesian(pulses) : target;
    const Time takes =
        group.isRobot() ? travelTime(group.pose, pose, speed, share) : axisTravelTime(group.pose, pose, speed, share);
    group.motion = Motion {group.pose, pose, memory.now, memory.now + takes};
    updateRunning(memory);
    return true;
}

} // namespace virtualcontroller
