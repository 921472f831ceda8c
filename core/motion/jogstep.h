// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "motion/plan.h"

namespace motion {

/// Along what a jog step goes.
enum class JogFrame { Base, Robot, Axes };

/// How the jog buttons are set.
struct JogChoice {
    values::ControlGroup group = values::ControlGroup::robotPulse(1);
    JogFrame frame = JogFrame::Base; ///< Stations and base axes know their axes only.
    double length = 1; ///< mm
    double angle = 1; ///< degrees
    int pulses = 100;
    Speeds speeds;

    bool operator==(const JogChoice &) const = default;
};

/// One of the jog buttons: an axis from 0, forward or backward. In a cartesian frame 0 to 2 are X Y Z, 3 to 5 Rx Ry Rz
/// and 6 is Re of a 7-axis arm.
struct JogDirection {
    int axis = 0;
    bool isForward = true;

    bool operator==(const JogDirection &) const = default;
};

/// One bounded step from where the group stands now. BadInput as plan() gives it, and for a step above its limit or an
/// axis that the group has not.
[[nodiscard]] values::Result<Plan> planStep(
    const JogChoice &choice, JogDirection direction, const Present &present, const Limits &limits);

} // namespace motion
