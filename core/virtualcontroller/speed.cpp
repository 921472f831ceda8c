// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "virtualcontroller/speed.h"

#include "virtualcontroller/kinematics.h"
#include <cmath>

using values::AxisWords;
using values::Speed;
using values::SpeedClass;

namespace virtualcontroller {

namespace {

/// The length of the way over axes first..last, in the words' unit.
double distance(const AxisWords &from, const AxisWords &to, int first, int last)
{
    double square = 0;
    for (int axis = first; axis < std::min(last + 1, from.count()); ++axis)
        square += std::pow(double(to[axis]) - from[axis], 2);
    return std::sqrt(square);
}

double longestAxis(const AxisWords &from, const AxisWords &to)
{
    double longest = 0;
    for (int axis = 0; axis < from.count(); ++axis)
        longest = std::max(longest, std::abs(double(to[axis]) - from[axis]));
    return longest;
}

Time milliseconds(double seconds) { return std::max(1ms, Time {std::llround(std::min(seconds, 1e6) * 1000)}); }

} // namespace

Time axisTravelTime(const AxisWords &from, const AxisWords &to, Speed speed, double share)
{
    const double pulses = longestAxis(from, to);
    const double perSecond =
        speed.kind == SpeedClass::Percent ? kinematics::fullSpeedPulses * speed.value / 1e4 : speed.value * 20.0;
    return milliseconds(pulses / (perSecond * share));
}

Time travelTime(const AxisWords &from, const AxisWords &to, Speed speed, double share)
{
    const double millimetres = distance(from, to, 0, 2) / 1e3;
    const double degrees = distance(from, to, 3, 6) / 1e4;
    const double tenths = speed.value / 10.0 * share; // mm/s or degree/s
    if (speed.kind == SpeedClass::Percent)
        return axisTravelTime(kinematics::toPulses(from), kinematics::toPulses(to), speed, share);
    if (speed.kind == SpeedClass::Rotation)
        return milliseconds(degrees / tenths);
    // A straight move that only turns has no length to divide by its speed: it turns at 90 degree/s.
    return milliseconds(millimetres > 0 ? millimetres / tenths : degrees / 90);
}

} // namespace virtualcontroller
