// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "protocol/dialect.h"
#include "values/error.h"
#include <QHashFunctions>
#include <QString>

namespace names {

/// One I/O signal. Its logical number is the group's number with the bit behind it: #27010 is bit 0 of group 2701
/// (reference §4.1).
struct Signal {
    int group = 1;
    int bit = 0; ///< 0 to 7.

    [[nodiscard]] constexpr int number() const { return group * 10 + bit; }
    auto operator<=>(const Signal &) const = default;
};
inline size_t qHash(const Signal &signal, size_t seed = 0) { return ::qHash(signal.number(), seed); }

constexpr int signalsPerGroup = 8;

/// "#00010": the logical number, which every signal has.
[[nodiscard]] QString toString(const Signal &signal);
/// "IN#(1)" or "OT#(12)", as INFORM counts them: the user inputs and outputs from 1. Empty for the other areas, which
/// have the logical number alone.
[[nodiscard]] QString informName(const Signal &signal, const protocol::Dialect &dialect);

/// Signal `number` (from 1) of an area; nullopt beyond it.
[[nodiscard]] std::optional<Signal> signalOf(protocol::IoArea area, int number, const protocol::Dialect &dialect);

/// Reads "#00010", "10010", "IN#(1)", "OUT#(12)", "OT#(12)"; the parentheses and the "#" may be missing. Numbers are
/// decimal, zeros in front mean nothing. BadInput with a whole, translated sentence for anything else and for signals
/// that the controller does not have.
[[nodiscard]] values::Result<Signal> signalFromText(QStringView text, const protocol::Dialect &dialect);

} // namespace names
