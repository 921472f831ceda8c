// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "virtualcontroller/motion.h"

namespace virtualcontroller
{

/// How fast a move shall be.
struct Speed {
    enum class Kind {
        Percent, ///< Of an axis's full speed.
        Linear, ///< Of the tool point, in mm/s.
        Rotation, ///< Of the tool's orientation, in degree/s.
    };
    Kind kind = Kind::Percent;
    double value = 0; ///< Over 0.
};

/// How long a robot takes from one cartesian pose to another; at least a millisecond.
[[nodiscard]] Time travelTime(const values::AxisWords &from, const values::AxisWords &to, Speed speed);
/// How long a base or station takes between pulses.
[[nodiscard]] Time axisTravelTime(const values::AxisWords &from, const values::AxisWords &to, double percent);

} // namespace virtualcontroller
