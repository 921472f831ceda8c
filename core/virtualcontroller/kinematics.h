// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "values/position.h"

/// Where the tool point is for given pulses. This is NOT an arm: every axis word is mapped by itself, S to X, L to Y, U
/// to Z, R to Rx, B to Ry, T to Rz, E to Re, by a fixed offset and a fixed ratio. That keeps pulses and cartesian words
/// consistent and invertible, which is all that a client can see; reach, joint limits and singularities are not
/// modelled.
namespace virtualcontroller::kinematics {

/// The cartesian words (micrometre, 0.0001 degree) that belong to a robot's pulses.
[[nodiscard]] values::AxisWords toCartesian(const values::AxisWords &pulses);
/// The pulses nearest to cartesian words.
[[nodiscard]] values::AxisWords toPulses(const values::AxisWords &cartesian);

/// A move that ends outside this many pulses, on any axis and either side, raises an alarm instead.
constexpr qint32 pulseLimit = 200'000;
/// What an axis does at 100 %.
constexpr double fullSpeedPulses = 60'000; ///< In pulses per second.

} // namespace virtualcontroller::kinematics
