// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "values/move.h"
#include "virtualcontroller/memory.h"

/// What happens inside the controller: modes, servo power, hold, jobs and motion (reference §10.2, side effects). Time
/// is a parameter; nothing here reads a clock.
namespace virtualcontroller {

/// Lets everything happen that is due until `now`: servo power comes, lines are executed, motions end, counters run. A
/// time that has been passed already changes nothing.
void advanceTo(Memory &memory, Time now);

/// Servo power on comes after Settings::servoDelay; off is at once, and stops what runs.
void switchServo(Memory &memory, bool on);
/// `source` is one of the three Held flags. On stops what runs where it is and keeps servo power.
void setHold(Memory &memory, values::Status::Data2Flag source, bool on);
/// Teach mode clears remote and stops what runs.
void setTeachMode(Memory &memory);
void setPlayMode(Memory &memory);
/// There is no remote in teach mode. A file transfer does not survive a change (reference §7.6).
void setRemote(Memory &memory, bool on);
void setCycle(Memory &memory, values::CycleMode cycle);

/// Makes `job` the executing job of task `task`, at `line` or the last line before it. The job exists.
void selectJob(Memory &memory, int task, const QByteArray &job, int line);
/// Starts or continues the executing job of the master task.
void startJob(Memory &memory);
/// Ends running: motions stop where they are, the job keeps its line.
void stopRunning(Memory &memory);

/// What the words of a target are.
enum class GroupWords { Pulses, Cartesian };

/// Moves a configured group to a target, of which it takes as many words as it has axes; `share` of the speed. A target
/// outside the limits raises an alarm instead: false. All four frames are taken for the base frame.
bool moveGroup(Memory &memory, values::ControlGroup group, values::AxisWords target, GroupWords unit,
    values::Speed speed, double share = 1);

/// Sets or clears Running after what follows from the rest of the memory.
void updateRunning(Memory &memory);

} // namespace virtualcontroller
