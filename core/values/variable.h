// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "values/fixedtext.h"
#include "values/position.h"

namespace values {

/// Eight signals that travel together; bit 0 is the signal whose number ends in 0 (reference §4.1).
struct IoGroup {
    quint8 bits = 0;

    /// `signal` is 0 to 7.
    [[nodiscard]] constexpr bool isOn(int signal) const { return bits >> signal & 1; }
    [[nodiscard]] constexpr IoGroup with(int signal, bool on) const
    {
        return {quint8(on ? bits | 1 << signal : bits & ~(1 << signal))};
    }
    bool operator==(const IoGroup &) const = default;
};

/// A register: a raw 16-bit quantity, shown unsigned (reference §4.2; §12, conflict 23).
struct Register {
    quint16 value = 0;

    bool operator==(const Register &) const = default;
};

// The variables, each by the letter of the pendant (reference §4.3).

struct ByteVariable { ///< B
    quint8 value = 0;

    bool operator==(const ByteVariable &) const = default;
};

struct IntegerVariable { ///< I
    qint16 value = 0;

    bool operator==(const IntegerVariable &) const = default;
};

struct DoubleVariable { ///< D: a double-precision integer
    qint32 value = 0;

    bool operator==(const DoubleVariable &) const = default;
};

struct RealVariable { ///< R
    float value = 0;

    bool operator==(const RealVariable &) const = default;
};

/// S, in the pendant's encoding: 16 bytes on older controllers and with 0x7E, 32 with 0x8C.
template <qsizetype Size> struct StringVariable {
    FixedText<Size> value;

    bool operator==(const StringVariable &) const = default;
};
using StringVariable16 = StringVariable<16>;
using StringVariable32 = StringVariable<32>;

/// P: a robot position. All eight axis words stand on the wire, unused ones as 0 (reference §4.4).
struct PositionVariable {
    Position position;

    bool operator==(const PositionVariable &) const = default;
};

/// BP: a base position, in pulses or base frame (reference §4.4).
struct BasePosition {
    PositionType type = PositionType::Pulse;
    AxisWords axes;

    bool operator==(const BasePosition &) const = default;
};

/// EX: an external axis position, in pulses (reference §4.4).
struct ExternalPosition {
    PositionType type = PositionType::Pulse;
    AxisWords axes;

    bool operator==(const ExternalPosition &) const = default;
};

} // namespace values
