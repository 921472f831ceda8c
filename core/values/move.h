// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "values/position.h"
#include <QString>

namespace values {

/// What the number of a speed means (reference §6.2). Percent goes with joint moves, the others with straight ones.
enum class SpeedClass : quint32 {
    Percent = 0, ///< 0.01 %
    ToolPoint = 1, ///< V, 0.1 mm/s
    Rotation = 2, ///< VR, 0.1 degree/s
};

/// A speed as it stands on the wire.
struct Speed {
    SpeedClass kind = SpeedClass::Percent;
    quint32 value = 0; ///< In the unit of the class; 0 is refused by the controller.

    /// "10.00 %", "25.0 mm/s", "3.0 °/s"; the number alone for a class that is not known.
    [[nodiscard]] QString toString() const;
    bool operator==(const Speed &) const = default;
};

/// How to get to a cartesian target: the instance of 0x8A.
enum class CartesianMove : quint16 { JointAbsolute = 1, StraightAbsolute = 2, StraightIncremental = 3 };
/// How to get to a pulse target: the instance of 0x8B.
enum class PulseMove : quint16 { JointAbsolute = 1, StraightAbsolute = 2 };

/// The target of a cartesian move (reference §6.2): 26 words.
struct CartesianTarget {
    quint32 robot = 1; ///< 1 is R1; 0 none. Robot and station together are refused.
    quint32 station = 0; ///< 1 is S1; 0 none.
    Speed speed;
    PositionType frame = PositionType::Base; ///< Base, Robot, User or Tool.
    std::array<qint32, 3> xyz {}; ///< 0.001 mm
    std::array<qint32, 4> rotation {}; ///< Rx Ry Rz in 0.0001 degree; the fourth is Re of a 7-axis arm, else 0.
    quint32 reserved = 0;
    quint32 form = 0; ///< Reference §5.2.
    quint32 extendedForm = 0;
    quint32 tool = 0; ///< 0 to 63.
    quint32 userFrame = 0; ///< 1 to 63 with the user frame, else 0.
    std::array<qint32, 3> base {}; ///< 0.001 mm
    std::array<qint32, 6> stationAxes {}; ///< Pulses.

    bool operator==(const CartesianTarget &) const = default;
};

/// The target of a pulse move (reference §6.3): 22 words.
struct PulseTarget {
    quint32 robot = 1;
    quint32 station = 0;
    Speed speed;
    std::array<qint32, 8> axes {}; ///< Pulses.
    quint32 tool = 0; ///< 0 to 63.
    std::array<qint32, 3> base {}; ///< Pulses.
    std::array<qint32, 6> stationAxes {}; ///< Pulses.

    bool operator==(const PulseTarget &) const = default;
};

} // namespace values
