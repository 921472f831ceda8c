// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "session/policy.h"
#include "session/statistics.h"
#include <deque>

namespace session {

/// Keeps the last minute of a link, second by second. Time is a parameter.
class LinkMeter
{
public:
    void sent(Time now) { ++second(now).sent; }
    void miss(Time now) { ++second(now).missed; }
    void roundTrip(Time now, std::chrono::microseconds roundTrip);
    /// An answer of any kind arrived.
    void answer(Time now) { m_lastAnswer = now; }

    /// Everything but the counters.
    [[nodiscard]] LinkStatistics statistics(Time now) const;

private:
    struct Second {
        Time begin;
        int sent = 0;
        int missed = 0;
        std::vector<std::chrono::microseconds> roundTrips; ///< At most 100: a busy second needs no more for a median.
    };

    Second &second(Time now);

    std::deque<Second> m_seconds; ///< Only seconds in which something happened.
    std::optional<Time> m_lastAnswer;
};

} // namespace session
