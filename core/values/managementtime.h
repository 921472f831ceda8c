// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "values/fixedtext.h"
#include <chrono>
#include <optional>

namespace values {

/// A running-time counter of the controller (reference §3.9).
struct ManagementTime {
    FixedText<16> start; ///< "YYYY/MM/DD hh:mm", by the controller's clock.
    FixedText<12> elapsed; ///< "18:19'02": hours, minutes, seconds; the hours have any number of digits.

    /// `elapsed` as a duration; nullopt if the text has another form.
    [[nodiscard]] std::optional<std::chrono::seconds> duration() const;
    bool operator==(const ManagementTime &) const = default;
};

/// Which counter: the value is the instance of the total, or the one before application 1.
enum class ManagementTimeKind : quint16 {
    ControlPower = 1, ///< Has a total alone.
    ServoPower = 10,
    Playback = 110,
    Motion = 210,
    Operation = 300, ///< By application; has no total.
};

/// A counter as instance of 0x88.
struct ManagementTimeCounter {
    quint16 instance = 1;

    static constexpr ManagementTimeCounter controlPower() { return {quint16(ManagementTimeKind::ControlPower)}; }
    /// `kind` is ServoPower, Playback or Motion.
    static constexpr ManagementTimeCounter total(ManagementTimeKind kind) { return {quint16(kind)}; }
    static constexpr ManagementTimeCounter robot(ManagementTimeKind kind, int robot)
    {
        return {quint16(int(kind) + robot)};
    }
    static constexpr ManagementTimeCounter station(ManagementTimeKind kind, int station)
    {
        return {quint16(int(kind) + 10 + station)};
    }
    static constexpr ManagementTimeCounter application(int application)
    {
        return {quint16(int(ManagementTimeKind::Operation) + application)};
    }
    bool operator==(const ManagementTimeCounter &) const = default;
};

} // namespace values
