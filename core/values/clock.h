// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include <chrono>

namespace values {

/// What ages and time-outs are counted by: the time that really passed, also while the computer slept or this program
/// was stopped. It never jumps, whatever is done to the wall clock.
struct Clock {
    using duration = std::chrono::nanoseconds;
    using rep = duration::rep;
    using period = duration::period;
    using time_point = std::chrono::time_point<Clock>;
    static constexpr bool is_steady = true;

    [[nodiscard]] static time_point now() noexcept;
};

using Time = Clock::time_point;

[[nodiscard]] inline Time now() { return Clock::now(); }

/// Three clocks at one moment. Where they went apart, the computer slept or somebody set its clock.
struct Clocks {
    Time passed {};
    std::chrono::steady_clock::time_point awake {}; ///< Stands still while the computer sleeps.
    std::chrono::system_clock::time_point wall {};

    [[nodiscard]] static Clocks read();
};

/// Whether more than `longest` passed from `before` to `after`, or two clocks went apart by more than `tolerance`.
[[nodiscard]] bool hasGap(
    const Clocks &before, const Clocks &after, std::chrono::milliseconds longest, std::chrono::milliseconds tolerance);

} // namespace values
