// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "motion/geometry.h"

namespace motion {

/// What no setting can raise.
namespace ceiling {
inline constexpr double toolSpeed = 250; ///< mm/s
inline constexpr double rotationSpeed = 30; ///< °/s
inline constexpr double jointSpeed = 5; ///< %, of what HSES does not tell how fast it is.
inline constexpr double stepLength = 10; ///< mm
inline constexpr double stepAngle = 5; ///< degrees
inline constexpr double stepPulses = 1000;
} // namespace ceiling

/// What a profile asks for. What is absent is at its ceiling.
struct Wishes {
    std::optional<double> toolSpeed {};
    std::optional<double> rotationSpeed {};
    std::optional<double> jointSpeed {};
    std::optional<double> stepLength {};
    std::optional<double> stepAngle {};
    std::optional<double> stepPulses {};
    std::optional<Box> box {};
    bool areFramesChecked = false; ///< What codes 18 and 19 mean was tried on this robot (reference §12, conflict 27).

    bool operator==(const Wishes &) const = default;
};

/// What holds: everything above 0 and at its ceiling or below.
struct Limits {
    double toolSpeed = ceiling::toolSpeed;
    double rotationSpeed = ceiling::rotationSpeed;
    double jointSpeed = ceiling::jointSpeed;
    double stepLength = ceiling::stepLength;
    double stepAngle = ceiling::stepAngle;
    double stepPulses = ceiling::stepPulses;
    std::optional<Box> box; ///< None: anywhere.
    bool areFramesChecked = false; ///< Else there are no user and tool frames.

    bool operator==(const Limits &) const = default;
};

/// Wishes above a ceiling are lowered to it. A wish that is 0, negative or no number, or a box without inside, was
/// meant to forbid something and cannot be understood: BadInput names it, and nothing may be moved.
[[nodiscard]] values::Result<Limits> limits(const Wishes &wishes);

} // namespace motion
