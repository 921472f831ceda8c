// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "virtualcontroller/kinematics.h"

#include <cmath>

using values::AxisWords;

namespace virtualcontroller::kinematics {

namespace {

struct AxisMap {
    qint32 offset; ///< The cartesian word at 0 pulses.
    qint32 ratio; ///< Cartesian units for a pulse.
};

// 200 000 pulses are 1 m, or 200 degrees.
constexpr std::array<AxisMap, values::maxAxes> maps {
    {{1'085'000, 5}, {0, 5}, {620'000, 5}, {1'800'000, 10}, {0, 10}, {0, 10}, {0, 10}, {0, 10}}};

} // namespace

AxisWords toCartesian(const AxisWords &pulses)
{
    AxisWords cartesian = pulses;
    for (int axis = 0; axis < pulses.count(); ++axis) {
        const auto [offset, ratio] = maps[std::size_t(axis)];
        cartesian[axis] = qint32(std::clamp<qint64>(offset + qint64(ratio) * pulses[axis], INT32_MIN, INT32_MAX));
    }
    return cartesian;
}

AxisWords toPulses(const AxisWords &cartesian)
{
    AxisWords pulses = cartesian;
    for (int axis = 0; axis < cartesian.count(); ++axis) {
        const auto [offset, ratio] = maps[std::size_t(axis)];
        pulses[axis] = qint32(std::lround(double(qint64(cartesian[axis]) - offset) / ratio));
    }
    return pulses;
}

} // namespace virtualcontroller::kinematics
