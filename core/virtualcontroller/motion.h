// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "values/position.h"
#include "virtualcontroller/time.h"
#include <optional>

namespace virtualcontroller {

/// A way from one pose to another in a given time. Speed rises and falls smoothly, so both ends are at rest.
struct Motion {
    values::AxisWords from;
    values::AxisWords to;
    Time begin {};
    Time end {};

    /// The pose at `now`: `from` before the beginning, exactly `to` from the end on.
    [[nodiscard]] values::AxisWords poseAt(Time now) const;
    /// Units per second, signed, for each axis.
    [[nodiscard]] std::array<double, values::maxAxes> velocityAt(Time now) const;
    /// Units per square second, signed, for each axis.
    [[nodiscard]] std::array<double, values::maxAxes> accelerationAt(Time now) const;
};

/// A control group: a robot, a base or a station. A robot's pose is kept in cartesian words, the others' in pulses.
struct Group {
    values::ControlGroup group; ///< The pulse instance: R1 is 1, B1 11, S1 21.
    values::AxisWords pose; ///< Where it stands while nothing moves it.
    std::optional<Motion> motion;

    [[nodiscard]] bool isRobot() const { return group.instance <= 8; }
    [[nodiscard]] values::AxisWords poseAt(Time now) const { return motion ? motion->poseAt(now) : pose; }
    [[nodiscard]] values::AxisWords pulsesAt(Time now) const;
    [[nodiscard]] values::AxisWords cartesianAt(Time now) const;
    [[nodiscard]] values::AxisNames pulseNames() const;
    [[nodiscard]] values::AxisNames cartesianNames() const;

    /// Following error in pulses: it lags in proportion to the speed (reference §3.8).
    [[nodiscard]] values::AxisWords followingErrorAt(Time now) const;
    /// Torque, raw: a standing load on L and U, more while accelerating; 0 with servo power off.
    [[nodiscard]] values::AxisWords torqueAt(Time now, bool servoOn) const;

    /// Ends a motion where it is at `now`.
    void stop(Time now);
    /// Takes over the end pose of a motion that is over at `now`; true if it was.
    bool settle(Time now);
};

} // namespace virtualcontroller
