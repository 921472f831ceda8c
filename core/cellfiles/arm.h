// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "cellfiles/conditions.h"
#include "cellfiles/parameters.h"
#include "motion/geometry.h"

/// Degrees and the way from pulses to the tool point, from the controller's own parameters (controller files reference
/// §4). What they do not say is not known: nothing is guessed.
namespace cellfiles {

/// One rotary axis: degrees = pulses * 360 * |denominator| / (encoder * numerator), exact.
struct Axis {
    qint64 numerator = 0;
    qint64 denominator = 0; ///< Its sign is the motor's direction.
    qint64 encoderPulses = 4096;
    qint64 upperLimit = 0; ///< Pulses.
    qint64 lowerLimit = 0;
    qint64 topSpeed = 0; ///< Pulses a second.

    [[nodiscard]] bool exists() const { return numerator != 0 && denominator != 0 && encoderPulses != 0; }
    /// Only for an axis that exists.
    [[nodiscard]] double degrees(double pulses) const;
    [[nodiscard]] double pulsesPerDegree() const;
};

struct Arm {
    static constexpr int axisCount = 8;

    std::array<Axis, axisCount> axes; ///< S L U R B T E in the order of the file.
    std::array<double, 5> links {}; ///< a1 a2 a3 d4 d6 in mm.

    [[nodiscard]] bool exists() const { return axes[0].exists(); }
    /// Six axes and link lengths: what the chain below holds for.
    [[nodiscard]] bool isStandard() const;
    /// Where the tool point is in base coordinates; nullopt for an arm that is not of the standard kind, or without six
    /// axis values.
    [[nodiscard]] std::optional<motion::Pose> toolPoint(const QList<qint64> &pulses, const Frame &tool) const;
};

/// The arm of robot `number` (from 1) by RC.PRM and SV.PRM; one without axes where they do not say it.
[[nodiscard]] Arm armOf(const Parameters &parameters, int number);
/// Which limit a parameter is: those of the arm in RCnG, or the narrower ones that a user may set in S1CnG.
struct LimitPlace {
    int robot = 1;
    int axis = 0;
    bool isUpper = true;
};
/// nullopt if parameter `number` of `section`, which has `size` values, is no limit.
[[nodiscard]] std::optional<LimitPlace> limitPlace(const QByteArray &section, int number, std::size_t size);
/// "S", "L" …; the seventh is E.
[[nodiscard]] QString axisName(int axis);
/// A frame of a file in mm and degrees.
[[nodiscard]] motion::Pose poseOf(const Frame &frame);
/// The frame of ORG, a point on the x axis and one on the side of +y; nullopt if they lie on one line.
[[nodiscard]] std::optional<motion::Pose> frameThrough(
    const motion::Vector &origin, const motion::Vector &alongX, const motion::Vector &towardsY);

} // namespace cellfiles
