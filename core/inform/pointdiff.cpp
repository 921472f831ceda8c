// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "inform/pointdiff.h"

#include "inform/canonical.h"
#include <algorithm>
#include <cmath>
#include <numbers>

namespace inform {

namespace {

using Matrix = std::array<std::array<double, 3>, 3>;

double rounded(double value) { return std::round(value * 1e4) / 1e4; }

/// A turn about the fixed axes X, then Y, then Z (reference §9.1).
Matrix rotation(double rx, double ry, double rz)
{
    constexpr double degree = std::numbers::pi / 180;
    const double a = std::cos(rx * degree);
    const double b = std::sin(rx * degree);
    const double c = std::cos(ry * degree);
    const double d = std::sin(ry * degree);
    const double e = std::cos(rz * degree);
    const double f = std::sin(rz * degree);
    return {{{e * c, e * d * b - f * a, e * d * a + f * b}, {f * c, f * d * b + e * a, f * d * a - e * b},
        {-d, c * b, c * a}}};
}

/// Degrees of the turn from one posture to the other.
double turn(const QList<double> &older, const QList<double> &newer)
{
    const Matrix a = rotation(older[3], older[4], older[5]);
    const Matrix b = rotation(newer[3], newer[4], newer[5]);
    double trace = 0;
    for (std::size_t row = 0; row < 3; ++row) {
        for (std::size_t column = 0; column < 3; ++column)
            trace += a[row][column] * b[row][column];
    }
    return std::acos(std::clamp((trace - 1) / 2, -1.0, 1.0)) * 180 / std::numbers::pi;
}

AxisUnit unitOf(const Point &point, int axis)
{
    if (point.isPulse())
        return AxisUnit::Pulse;
    if (point.isAngle())
        return AxisUnit::Degree;
    return point.isOfRobot() && axis >= 3 ? AxisUnit::Degree : AxisUnit::Millimetre;
}

/// Cartesian angles end at 180 degrees and begin again at -180.
double amountOf(const Point &point, int axis, double difference)
{
    const bool isAngle = point.isCartesian() && unitOf(point, axis) == AxisUnit::Degree;
    return rounded(isAngle ? std::remainder(difference, 360) : difference);
}

void addShifts(PointChange &change, const Point &point, const QList<double> &older, const QList<double> &newer)
{
    for (int axis = 0; axis < older.size(); ++axis) {
        const double amount = amountOf(point, axis, newer[axis] - older[axis]);
        if (amount != 0)
            change.shifts << Shift {axis, amount, unitOf(point, axis)};
    }
    if (!point.isCartesian() || !point.isOfRobot() || older.size() < 6)
        return;
    change.distance = rounded(std::hypot(newer[0] - older[0], newer[1] - older[1], newer[2] - older[2]));
    change.angle = rounded(turn(older, newer));
}

bool isSameFrame(const PointChange &change) { return !change.type.isChanged() && !change.user.isChanged(); }

void addValues(PointChange &change, const Point &older, const Point &newer)
{
    const auto before = older.numbers();
    const auto after = newer.numbers();
    if (isSameFrame(change) && before && after && before->size() == after->size())
        return addShifts(change, newer, *before, *after);
    if (before != after || !before)
        change.values = {older.values.toByteArray(), newer.values.toByteArray()};
}

int fieldAt(const std::vector<QByteArrayView> &form, std::size_t index)
{
    return index < form.size() ? form[index].toInt() : 0;
}

QList<int> diffForms(QByteArrayView older, QByteArrayView newer)
{
    QList<int> fields;
    const auto before = splitAt(older, ',');
    const auto after = splitAt(newer, ',');
    for (std::size_t index = 0; index < std::max(before.size(), after.size()); ++index) {
        if (fieldAt(before, index) != fieldAt(after, index))
            fields << (fieldAt(after, index) != 0 ? int(index) + 1 : -int(index) - 1);
    }
    return fields;
}

Versions limits(bool older, bool newer) { return {older ? "ON" : "OFF", newer ? "ON" : "OFF"}; }

} // namespace

bool PointChange::isEmpty() const
{
    return !type.isChanged() && !tool.isChanged() && !user.isChanged() && form.isEmpty() && !limit.isChanged()
        && !values.isChanged() && shifts.isEmpty();
}

std::optional<PointChange> diffPoints(const Point &older, const Point &newer)
{
    if (pointKey(older) == pointKey(newer))
        return std::nullopt;
    PointChange change;
    change.isOfRobot = newer.isOfRobot();
    change.type = {older.type.toByteArray(), newer.type.toByteArray()};
    if (change.isOfRobot)
        change.tool = {canonicalNumber(older.tool), canonicalNumber(newer.tool)};
    change.user = {canonicalNumber(older.user), canonicalNumber(newer.user)};
    if (older.isCartesian() && newer.isCartesian())
        change.form = diffForms(older.form, newer.form);
    change.limit = limits(older.isBeyondLimit, newer.isBeyondLimit);
    addValues(change, older, newer);
    return change.isEmpty() ? std::nullopt : std::optional {change};
}

} // namespace inform
