// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "session/policy.h"
#include "session/statistics.h"
#include <array>
#include <deque>
#include <map>

namespace session {

/// Keeps the last minute of a link, second by second. Time is a parameter.
class LinkMeter
{
public:
    void sent(Time now, quint16 command);
    void miss(Time now, quint16 command);
    void roundTrip(Time now, quint16 command, std::chrono::microseconds roundTrip);
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

    /// What is known of one command.
    struct CommandRecord {
        quint64 sent = 0;
        quint64 missed = 0;
        std::array<std::chrono::microseconds, 64> roundTrips {};
        quint64 answers = 0; ///< The newest round trip stands at (answers - 1) modulo 64.
        Time lastAnswer {};
    };

    Second &second(Time now);
    static CommandStatistics summary(quint16 command, const CommandRecord &record, Time now);

    std::deque<Second> m_seconds; ///< Only seconds in which something happened.
    std::map<quint16, CommandRecord> m_commands;
    std::optional<Time> m_lastAnswer;
};

} // namespace session
