// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "protocol/dialect.h"
#include "robot/robotstate.h"
#include "trend/signal.h"

namespace trend {

/// Every number of a controller that may be plotted, in the order of a menu: what `dialect` has, of the control groups
/// that answered (R1 until one did). Several thousand.
[[nodiscard]] QList<Signal> allSignals(const protocol::Dialect &dialect, const robot::RobotState &state);

} // namespace trend
