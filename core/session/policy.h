// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "protocol/effect.h"
#include "values/clock.h"

namespace session {

using values::now;
using values::Time;
using Milliseconds = std::chrono::milliseconds;

/// Who goes first. A stop waits for nothing, not even for the window or the ceiling. The background gets what the
/// others leave, and one request in 50 ms at least.
enum class Priority { Stop, Control, Page, Background };
constexpr int priorityCount = 4;

/// How long and how often a session asks. Effect decides which of these applies, and nothing else does.
struct Policy {
    Milliseconds timeout {300}; ///< The longest wait for one try of a read.
    bool isAdaptive = true; ///< Repeat sooner than `timeout` where the round trips seen so far allow it.
    int repeats =
        2; ///< After so many further time-outs a read is given up. Until then it is repeated, with the same id.
    Milliseconds controlTimeout {1000}; ///< For the single try of a write, a start or a move.
    Milliseconds servoTimeout {8000}; ///< The answer to a start may come only when power is on (reference §11).
    Milliseconds stopPeriod {2000}; ///< What goes with Priority::Stop is repeated until it is answered, or so long.
    Milliseconds stopRepeat {40}; ///< How often: always the same, whatever the link has done so far.
    /// How long an answer, or a second copy of one, may still come. An id rests for that long, so no more than about
    /// 120 requests a second leave for one controller, whatever the ceiling: there are 256 ids (reference §1.1, §11).
    Milliseconds idLinger {2000};
    Milliseconds busyLeast {50}; ///< A read answered "busy" is asked again after a random wait between these two.
    Milliseconds busyMost {200};
    int busyRepeats = 5; ///< How often at the most.
    int window = 1; ///< Requests outstanding at once, 1 to 8.
    int requestsPerSecond = 100; ///< Ceiling of everything but stops; 0 for none.

    /// From the first try to giving up.
    [[nodiscard]] Milliseconds patience(protocol::Effect effect, Priority priority) const
    {
        using protocol::Effect;
        if (priority == Priority::Stop)
            return stopPeriod;
        switch (effect) {
        case Effect::Reads: return timeout * (1 + repeats);
        case Effect::Stops: return stopPeriod;
        case Effect::Starts: return servoTimeout;
        case Effect::Writes:
        case Effect::Moves: break;
        }
        return controlTimeout;
    }
};

} // namespace session
