// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "values/error.h"
#include "values/position.h"
#include <array>
#include <optional>

namespace motion {

using Vector = std::array<double, 3>;

/// An orientation. On the wire it is three angles about the fixed axes X, then Y, then Z, in degrees (reference §5.1).
class Rotation
{
public:
    Rotation() = default; ///< None.
    [[nodiscard]] static Rotation fromFixedAngles(const Vector &degrees);
    /// The angles again: Rx and Rz from -180 (not included) to 180, Ry from -90 to 90. Where Ry is 90 or -90 many
    /// triples are the same orientation; Rz is 0 then.
    [[nodiscard]] Vector toFixedAngles() const;

    [[nodiscard]] Rotation inverted() const;
    /// First `other`, then this.
    [[nodiscard]] Rotation operator*(const Rotation &other) const;
    [[nodiscard]] Vector operator*(const Vector &vector) const;
    /// How far it turns, in degrees: 0 to 180.
    [[nodiscard]] double angle() const;

private:
    std::array<Vector, 3> m_rows {Vector {1, 0, 0}, Vector {0, 1, 0}, Vector {0, 0, 1}};
};

/// A place and an orientation in a frame.
struct Pose {
    Vector mm {};
    Vector degrees {};

    bool operator==(const Pose &) const = default;
};

/// BadInput for pulses and for a position without six axes. The seventh, Re, is not part of a pose.
[[nodiscard]] values::Result<Pose> poseOf(const values::Position &position);

/// The length of the straight line between two poses, in mm, and the angle between their orientations, 0 to 180
/// degrees.
[[nodiscard]] double distance(const Pose &from, const Pose &to);
[[nodiscard]] double rotationDistance(const Pose &from, const Pose &to);

/// Where `from` comes to by a way that is told along the tool's own axes.
[[nodiscard]] Pose movedInTool(const Pose &from, const Pose &delta);
/// The reverse: the way from one pose to another, along the axes of the first one's tool.
[[nodiscard]] Pose deltaInTool(const Pose &from, const Pose &to);

/// Where the tool point may be, in the base frame.
struct Box {
    Vector least {};
    Vector most {};

    /// A place that is no number lies outside. A straight line between two places inside stays inside.
    [[nodiscard]] bool contains(const Vector &mm) const;
    bool operator==(const Box &) const = default;
};

} // namespace motion
