// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "robot/robotstate.h"
#include "trend/series.h"
#include "trend/signal.h"

namespace trend {

/// A number and when it was read.
struct Measured {
    Moment at;
    Quantity quantity;
};

/// What `state` holds of a signal; nullopt unless it is live. Nothing else is ever recorded or plotted.
[[nodiscard]] std::optional<Measured> measured(const robot::RobotState &state, const Signal &signal);
/// What the controller calls the axis of a signal; empty if it has none or was not asked.
[[nodiscard]] QString axisName(const robot::RobotState &state, const Signal &signal);
/// label() with the controller's own axis names.
[[nodiscard]] QString label(const robot::RobotState &state, const Signal &signal);

} // namespace trend
