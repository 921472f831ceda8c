// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "cellfiles/arm.h"

#include <cmath>
#include <numbers>

using motion::Pose;
using motion::Rotation;
using motion::Vector;

namespace cellfiles {

namespace {

/// Where the values of a group stand in RCnG and SVnG: in blocks of ten on the YRC1000, of eight before.
struct ArmLayout {
    int upperLimit;
    int lowerLimit;
    int topSpeed;
    int denominator;
    int numerator;
    int encoder; ///< In SVnG.
};
constexpr ArmLayout blocksOfTen {1030, 1040, 1070, 1090, 1100, 30};
constexpr ArmLayout blocksOfEight {924, 932, 956, 972, 980, 24};
constexpr std::size_t valuesOfTen = 3000; ///< RCnG has 300 rows on the YRC1000, 170 before.
constexpr std::array linkPlaces {1, 3, 5, 8, 12};

/// Where the soft limits of a user stand in S1CnG: upper ones, then lower ones.
constexpr int softLimitsOfTen = 800;
constexpr int softLimitsOfEight = 400;
constexpr std::size_t softValuesOfTen = 2800; ///< 280 rows on the YRC1000, at most 120 before.

/// "RC1G" or "S1C1G": the robot's number behind `prefix`.
std::optional<int> robotOf(const QByteArray &section, QByteArrayView prefix)
{
    if (!section.startsWith(prefix) || !section.endsWith('G'))
        return std::nullopt;
    return wordFrom(QByteArrayView {section}.sliced(prefix.size()).chopped(1));
}

/// A place and an orientation, the one after the other.
struct Placement {
    Rotation rotation;
    Vector mm {};

    [[nodiscard]] Placement then(const Placement &next) const
    {
        Vector place = rotation * next.mm;
        for (std::size_t axis = 0; axis < place.size(); ++axis)
            place[axis] += mm[axis];
        return {rotation * next.rotation, place};
    }
};

Placement turned(double x, double y, double z) { return {Rotation::fromFixedAngles({x, y, z}), {}}; }
Placement moved(double x, double y, double z) { return {{}, {x, y, z}}; }

Placement placementOf(const Pose &pose) { return {Rotation::fromFixedAngles(pose.degrees), pose.mm}; }

Vector difference(const Vector &a, const Vector &b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
double dot(const Vector &a, const Vector &b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Vector cross(const Vector &a, const Vector &b)
{
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
std::optional<Vector> unit(const Vector &a)
{
    constexpr double shortest = 1e-6; // mm
    const double length = std::sqrt(dot(a, a));
    if (length < shortest)
        return std::nullopt;
    return Vector {a[0] / length, a[1] / length, a[2] / length};
}

double degreesFrom(double radians) { return radians * 180 / std::numbers::pi; }

/// The fixed angles of the orientation with these axes.
Vector anglesOf(const Vector &x, const Vector &y, const Vector &z)
{
    return {degreesFrom(std::atan2(y[2], z[2])), degreesFrom(std::atan2(-x[2], std::hypot(y[2], z[2]))),
        degreesFrom(std::atan2(x[1], x[0]))};
}

} // namespace

double Axis::degrees(double pulses) const
{
    return pulses * 360 * double(std::abs(denominator)) / (double(encoderPulses) * double(numerator));
}

double Axis::pulsesPerDegree() const
{
    return double(encoderPulses) * double(numerator) / (360 * double(std::abs(denominator)));
}

bool Arm::isStandard() const
{
    const auto hasAxis = [](const Axis &axis) { return axis.exists(); };
    return std::all_of(axes.begin(), axes.begin() + 6, hasAxis) && !axes[6].exists() && links[1] > 0 && links[3] > 0;
}

std::optional<Pose> Arm::toolPoint(const QList<qint64> &pulses, const Frame &tool) const
{
    if (!isStandard() || pulses.size() < 6)
        return std::nullopt;
    std::array<double, 6> angle {};
    for (std::size_t axis = 0; axis < angle.size(); ++axis)
        angle[axis] = axes[axis].degrees(double(pulses[qsizetype(axis)]));
    const auto [a1, a2, a3, d4, d6] = links;
    const Placement flange = turned(180, -90, 0); // x of the tool points up, z ahead
    const Placement end = turned(0, 0, angle[0])
                              .then(moved(a1, 0, 0))
                              .then(turned(0, angle[1], 0))
                              .then(moved(0, 0, a2))
                              .then(turned(0, -angle[2], 0))
                              .then(moved(d4, 0, a3))
                              .then(turned(-angle[3], 0, 0))
                              .then(turned(0, -angle[4], 0))
                              .then(turned(-angle[5], 0, 0))
                              .then(moved(d6, 0, 0))
                              .then(flange)
                              .then(placementOf(poseOf(tool)));
    return Pose {end.mm, end.rotation.toFixedAngles()};
}

Arm armOf(const Parameters &parameters, int number)
{
    const QByteArray group = QByteArray::number(number) + 'G';
    const auto section = parameters.sections.find("RC" + group);
    Arm arm;
    if (section == parameters.sections.end())
        return arm;
    const ArmLayout &layout = section->values.size() >= valuesOfTen ? blocksOfTen : blocksOfEight;
    const auto at = [&](int place) { return qint64 {section->at(place).value_or(0)}; };
    for (int axis = 0; axis < Arm::axisCount; ++axis) {
        const auto encoder = parameters.value("SV" + group, layout.encoder + axis);
        arm.axes[std::size_t(axis)] = {at(layout.numerator + axis), at(layout.denominator + axis),
            encoder.value_or(0) > 0 ? *encoder : 4096, at(layout.upperLimit + axis), at(layout.lowerLimit + axis),
            at(layout.topSpeed + axis)};
    }
    for (std::size_t link = 0; link < arm.links.size(); ++link)
        arm.links[link] = double(at(linkPlaces[link])) / 1000;
    return arm;
}

std::optional<LimitPlace> limitPlace(const QByteArray &section, int number, std::size_t size)
{
    const auto arm = robotOf(section, "RC");
    const auto robot = arm ? arm : robotOf(section, "S1C");
    const bool isOfTen = size >= (arm ? valuesOfTen : softValuesOfTen);
    const int width = isOfTen ? 10 : 8;
    const int first =
        arm ? (isOfTen ? blocksOfTen : blocksOfEight).upperLimit : (isOfTen ? softLimitsOfTen : softLimitsOfEight);
    const int place = number - first;
    if (!robot || place < 0 || place >= 2 * width || place % width >= Arm::axisCount)
        return std::nullopt;
    return LimitPlace {*robot, place % width, place < width};
}

QString axisName(int axis) { return axis >= 0 && axis < 7 ? QString {u"SLURBTE"[axis]} : QString::number(axis + 1); }

Pose poseOf(const Frame &frame)
{
    Pose pose;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        pose.mm[axis] = double(frame[axis]) / 1000;
        pose.degrees[axis] = double(frame[axis + 3]) / 10000;
    }
    return pose;
}

std::optional<Pose> frameThrough(const Vector &origin, const Vector &alongX, const Vector &towardsY)
{
    const auto x = unit(difference(alongX, origin));
    const auto z = x ? unit(cross(*x, difference(towardsY, origin))) : std::nullopt;
    if (!z)
        return std::nullopt;
    return Pose {origin, anglesOf(*x, cross(*z, *x), *z)};
}

} // namespace cellfiles
