// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "virtualcontroller/memory.h"

/// What happens inside the controller: modes, servo power, hold, jobs and motion (reference §10.2, side effects). Time
/// is a parameter; nothing here reads a clock.
namespace virtualcontroller
{

/// Lets everything happen that is due until `now`: servo power comes, lines are executed, motions end. A time that has
/// been passed already changes nothing.
void advance(Memory &memory, Time now);

/// Servo power on comes after Settings::servoDelay; off is at once, and stops what runs.
void switchServo(Memory &memory, bool on);
/// `source` is one of the three Held flags. On stops what runs where it is and keeps servo power.
void setHold(Memory &memory, values::Status::Data2Flag source, bool on);
/// Teach mode clears remote and stops what runs.
void setTeachMode(Memory &memory);
void setPlayMode(Memory &memory);
void setRemote(Memory &memory, bool on);
/// Sets exactly one of the three cycle modes.
void setCycle(Memory &memory, values::Status::Data1Flag cycle);

/// Makes `job` the executing job of task `task`, at `line`. It exists.
void selectJob(Memory &memory, int task, const QByteArray &job, int line);
/// Starts or continues the executing job of the master task.
void startJob(Memory &memory);
/// Ends running: motions stop where they are, the job keeps its line.
void stopRunning(Memory &memory);

/// Sets or clears Running after what follows from the rest of the memory.
void updateRunning(Memory &memory);

} // namespace virtualcontroller
