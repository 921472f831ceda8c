// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "values/move.h"
#include "virtualcontroller/time.h"

namespace virtualcontroller {

/// How long a robot takes from one cartesian pose to another at a share of `speed`, 1 being all of it; at least a
/// millisecond. The speed's value is not 0.
[[nodiscard]] Time travelTime(
    const values::AxisWords &from, const values::AxisWords &to, values::Speed speed, double share = 1);
/// The same between pulses, as a base or a station goes; a speed in mm/s is taken at 200 pulses a millimetre.
[[nodiscard]] Time axisTravelTime(
    const values::AxisWords &from, const values::AxisWords &to, values::Speed speed, double share = 1);

} // namespace virtualcontroller
