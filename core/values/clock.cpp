// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "values/clock.h"

#include <ctime>

namespace values {

Clock::time_point Clock::now() noexcept
{
#ifdef CLOCK_BOOTTIME
    timespec at {};
    if (clock_gettime(CLOCK_BOOTTIME, &at) == 0)
        return time_point {std::chrono::seconds {at.tv_sec} + std::chrono::nanoseconds {at.tv_nsec}};
#endif
    return time_point {std::chrono::steady_clock::now().time_since_epoch()};
}

Clocks Clocks::read() { return {Clock::now(), std::chrono::steady_clock::now(), std::chrono::system_clock::now()}; }

bool hasGap(
    const Clocks &before, const Clocks &after, std::chrono::milliseconds longest, std::chrono::milliseconds tolerance)
{
    const auto passed = after.passed - before.passed;
    const auto slept = passed - (after.awake - before.awake);
    const auto set = std::chrono::abs(after.wall - before.wall - passed);
    return passed > longest || slept > tolerance || set > tolerance;
}

} // namespace values
