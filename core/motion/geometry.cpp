// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "motion/geometry.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace motion {

namespace {

constexpr double degree = std::numbers::pi / 180;

double dot(const Vector &a, const Vector &b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Vector difference(const Vector &a, const Vector &b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

double length(const Vector &v) { return std::hypot(v[0], v[1], v[2]); }

} // namespace

/// R = Rz · Ry · Rx: about the fixed X first.
Rotation Rotation::fromFixedAngles(const Vector &degrees)
{
    const double sx = std::sin(degrees[0] * degree), cx = std::cos(degrees[0] * degree);
    const double sy = std::sin(degrees[1] * degree), cy = std::cos(degrees[1] * degree);
    const double sz = std::sin(degrees[2] * degree), cz = std::cos(degrees[2] * degree);
    Rotation result;
    result.m_rows = {Vector {cz * cy, cz * sy * sx - sz * cx, cz * sy * cx + sz * sx},
        Vector {sz * cy, sz * sy * sx + cz * cx, sz * sy * cx - cz * sx}, Vector {-sy, cy * sx, cy * cx}};
    return result;
}

Vector Rotation::toFixedAngles() const
{
    const double cy = std::hypot(m_rows[0][0], m_rows[1][0]);
    const double ry = std::atan2(-m_rows[2][0], cy);
    constexpr double nearly0 = 1e-9;
    const bool isUpright = cy < nearly0;
    const double rx = isUpright ? std::atan2(-m_rows[1][2], m_rows[1][1]) : std::atan2(m_rows[2][1], m_rows[2][2]);
    const double rz = isUpright ? 0 : std::atan2(m_rows[1][0], m_rows[0][0]);
    const auto upper = [](double angle) { return angle <= -180 ? angle + 360 : angle; };
    return {upper(rx / degree), ry / degree, upper(rz / degree)};
}

Rotation Rotation::inverted() const
{
    Rotation result;
    for (std::size_t row = 0; row < 3; ++row) {
        for (std::size_t column = 0; column < 3; ++column)
            result.m_rows[row][column] = m_rows[column][row];
    }
    return result;
}

Vector Rotation::operator*(const Vector &vector) const
{
    return {dot(m_rows[0], vector), dot(m_rows[1], vector), dot(m_rows[2], vector)};
}

Rotation Rotation::operator*(const Rotation &other) const
{
    const Rotation columns = other.inverted();
    Rotation result;
    for (std::size_t row = 0; row < 3; ++row)
        result.m_rows[row] = columns * m_rows[row];
    return result;
}

/// From sine and cosine together, so that small and large angles are as exact as the others.
double Rotation::angle() const
{
    const double cosine = (m_rows[0][0] + m_rows[1][1] + m_rows[2][2] - 1) / 2;
    const Vector axis {m_rows[2][1] - m_rows[1][2], m_rows[0][2] - m_rows[2][0], m_rows[1][0] - m_rows[0][1]};
    return std::atan2(length(axis) / 2, cosine) / degree;
}

values::Result<Pose> poseOf(const values::Position &position)
{
    if (position.type == values::PositionType::Pulse || position.axes.count() < 6)
        return values::badInput(QStringLiteral("not a cartesian position of six axes"));
    const values::AxisWords &axes = position.axes;
    return Pose {{axes[0] / 1e3, axes[1] / 1e3, axes[2] / 1e3}, {axes[3] / 1e4, axes[4] / 1e4, axes[5] / 1e4}};
}

double distance(const Pose &from, const Pose &to) { return length(difference(to.mm, from.mm)); }

double rotationDistance(const Pose &from, const Pose &to)
{
    return (Rotation::fromFixedAngles(from.degrees).inverted() * Rotation::fromFixedAngles(to.degrees)).angle();
}

Pose movedInTool(const Pose &from, const Pose &delta)
{
    const Rotation tool = Rotation::fromFixedAngles(from.degrees);
    const Vector way = tool * delta.mm;
    return {{from.mm[0] + way[0], from.mm[1] + way[1], from.mm[2] + way[2]},
        (tool * Rotation::fromFixedAngles(delta.degrees)).toFixedAngles()};
}

Pose deltaInTool(const Pose &from, const Pose &to)
{
    const Rotation back = Rotation::fromFixedAngles(from.degrees).inverted();
    return {back * difference(to.mm, from.mm), (back * Rotation::fromFixedAngles(to.degrees)).toFixedAngles()};
}

bool Box::contains(const Vector &mm) const
{
    for (std::size_t axis = 0; axis < 3; ++axis) {
        if (!(mm[axis] >= least[axis] && mm[axis] <= most[axis]))
            return false;
    }
    return true;
}

} // namespace motion
