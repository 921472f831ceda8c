// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "motion/limits.h"
#include "values/move.h"
#include <chrono>
#include <variant>

namespace motion {

/// A move order as it stands on the wire (reference §6.2, §6.3), but for who sends it.
struct CartesianOrder {
    values::CartesianMove how = values::CartesianMove::StraightAbsolute;
    values::CartesianTarget target;

    bool operator==(const CartesianOrder &) const = default;
};
struct PulseOrder {
    values::PulseMove how = values::PulseMove::JointAbsolute;
    values::PulseTarget target;

    bool operator==(const PulseOrder &) const = default;
};
using MoveOrder = std::variant<CartesianOrder, PulseOrder>;

/// How fast. Which of them goes out depends on the move; all of them hold.
struct Speeds {
    double tool = 10; ///< mm/s
    double rotation = 3; ///< °/s
    double joint = 1; ///< %

    bool operator==(const Speeds &) const = default;
};

/// The group moves the robot's base: B1 to B8, by its pulse instance.
[[nodiscard]] constexpr bool isTrack(values::ControlGroup group) { return group.instance > 10 && group.instance <= 20; }

/// Where a group stands, as read at rest. What is not there was not read.
struct Present {
    std::optional<values::Position> base; ///< Base frame; robots only.
    std::optional<values::Position> pulse; ///< Of the robot, or of the station.
    std::optional<values::Position> track; ///< The base axes under the robot, in pulses.
    bool hasTrack = false; ///< The robot has base axes, so that its own frame is another one than the base frame.

    /// The one that an instance of the position command tells (reference §2.1), base cartesian excepted.
    [[nodiscard]] std::optional<values::Position> &at(values::ControlGroup group);
    [[nodiscard]] const std::optional<values::Position> &at(values::ControlGroup group) const;
};

/// What a person asks for.
struct Wish {
    enum class How { Joint, Straight, Increment };

    values::ControlGroup group =
        values::ControlGroup::robotPulse(1); ///< A robot, base or station, by its pulse instance.
    How how = How::Straight;
    values::PositionType frame = values::PositionType::Base; ///< Pulse for a target in pulses.
    values::AxisWords axes; ///< In the units of the frame: the target, or the way with How::Increment.
    quint32 form = 0; ///< Reference §5.2; not for pulses.
    quint32 extendedForm = 0;
    quint32 tool = 0; ///< 0 to 63.
    quint32 userFrame = 0; ///< 1 to 63 with the user frame, else 0.
    /// Where the base axes shall be: pulses for a target in pulses, else 0.001 mm. Absolute moves of a robot that has
    /// them need it.
    std::optional<std::array<qint32, 3>> track;
    Speeds speeds;

    bool operator==(const Wish &) const = default;
};

/// How far a box was looked at.
enum class BoxCheck {
    NoBox, ///< None is set for this controller.
    WholeWay, ///< A straight line between two places inside.
    BothEnds, ///< A joint move: nobody here can tell its way.
};

/// A move that may be sent, and what can be told about it beforehand.
struct Plan {
    MoveOrder order;
    values::ControlGroup watched; ///< The instance whose position tells where it comes to rest.
    std::optional<values::Position> target; ///< As `watched` will be read; nullopt where that cannot be foretold.
    std::optional<double> length; ///< Of the straight line, in mm; nullopt for pulses.
    std::optional<double> angle; ///< In degrees, 0 to 180; nullopt for pulses.
    std::optional<std::chrono::milliseconds> time; ///< Without the ramps; nullopt for joint moves.
    BoxCheck box = BoxCheck::NoBox;

    /// More than 100 mm or 30 degrees, or nobody can tell: it wants a second thought.
    [[nodiscard]] bool isLong() const;
};
inline constexpr double longLength = 100; ///< mm
inline constexpr double longAngle = 30; ///< degrees

/// Turns a wish into an order. BadInput with a whole, translated sentence for what must not be sent: above a limit,
/// outside the box, no number, a place that cannot be known, a combination that does not exist (reference §6.3). A
/// straight move in pulses is none of ours: how far the tool point goes is not known, so neither is its speed.
[[nodiscard]] values::Result<Plan> plan(const Wish &wish, const Present &present, const Limits &limits);

} // namespace motion
