// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "virtualcontroller/memory.h"

/// The executing job of the master task, line by line, while Memory::isJobRunning. Understood are the moves, CALL, RET,
/// END, JUMP with labels and conditions, TIMER, WAIT, PAUSE, DOUT, DIN, SET, INC, DEC, ADD, SUB, MUL and CLEAR
/// of B, I and D; every other instruction takes its time and does nothing.
namespace virtualcontroller {

/// When the line being executed is due; Time::max() while no job runs.
[[nodiscard]] Time nextLine(const Memory &memory);
/// Ends the line that is due at Memory::now and begins the next one.
void executeDueLines(Memory &memory);

} // namespace virtualcontroller
