// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "virtualcontroller/machine.h"

#include "virtualcontroller/execution.h"
#include <algorithm>

using values::Status;

namespace virtualcontroller
{

namespace
{

constexpr Time never = Time::max();

/// The next moment at which something happens by itself.
Time nextEvent(const Memory &memory)
{
    Time next = memory.servoOnAt.value_or(never);
    for (const Group &group : memory.groups)
        next = std::min(next, group.motion ? group.motion->end : never);
    return std::min(next, nextLine(memory));
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

} // namespace

void advance(Memory &memory, Time now)
{
    for (Time next = nextEvent(memory); next <= now; next = nextEvent(memory)) {
        memory.now = std::max(memory.now, next);
        happen(memory);
    }
    memory.now = std::max(memory.now, now);
}

void updateRunning(Memory &memory)
{
    const bool isMoving =
        std::ranges::any_of(memory.groups, [](const Group &group) { return group.motion.has_value(); });
    memory.status.data1.setFlag(Status::Running, memory.isJobRunning || isMoving);
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
    memory.status.data1.setFlag(Status::Teach);
    memory.status.data1.setFlag(Status::Play, false);
    memory.status.data1.setFlag(Status::Remote, false);
}

void setPlayMode(Memory &memory)
{
    memory.status.data1.setFlag(Status::Teach, false);
    memory.status.data1.setFlag(Status::Play);
}

void setRemote(Memory &memory, bool on) { memory.status.data1.setFlag(Status::Remote, on && !memory.status.isTeach()); }

void setCycle(Memory &memory, Status::Data1Flag cycle)
{
    memory.status.data1.setFlag(Status::Step, cycle == Status::Step);
    memory.status.data1.setFlag(Status::OneCycle, cycle == Status::OneCycle);
    memory.status.data1.setFlag(Status::Continuous, cycle == Status::Continuous);
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

} // namespace virtualcontroller
