// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

namespace protocol {

/// What a request does to the robot. Everything about repeating, order and permission follows from this one word.
enum class Effect {
    Reads, ///< Changes nothing: may be repeated.
    Writes, ///< Changes data or a setting: sent once; without an answer its outcome is unknown.
    Starts, ///< Makes motion possible or begins it (servo on, start): sent once, and only with a permit.
    Moves, ///< Moves the arm: sent once, and only with a permit.
    Stops, ///< HOLD on, servo off: goes ahead of everything and may be repeated.
};

constexpr bool isRepeatable(Effect effect) { return effect == Effect::Reads || effect == Effect::Stops; }
constexpr bool needsPermit(Effect effect) { return effect == Effect::Starts || effect == Effect::Moves; }

} // namespace protocol
