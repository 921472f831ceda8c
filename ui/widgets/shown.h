// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "robot/reading.h"
#include "ui/widgets/lamp.h"

namespace widgets {

/// A state in words, with the shape that goes with it.
struct Word {
    QString text;
    Lamp lamp = Lamp::None;

    bool operator==(const Word &) const = default;
};

/// What a value widget shows: a word or a number, and how far it can be trusted.
struct Shown {
    Word word;
    robot::Freshness freshness = robot::Freshness::Unknown;
    QString note; ///< "Last seen 12:03:04" or why there is no value; empty while live.

    bool operator==(const Shown &) const = default;
};

/// "—"
[[nodiscard]] QString dash();
/// Of a position variable that was never set.
[[nodiscard]] QString notTaught();
[[nodiscard]] Shown unknown();
[[nodiscard]] Shown refused(const values::Error &refusal);
/// "Last seen 12:03:04"
[[nodiscard]] QString lastSeen(const QDateTime &clock);

/// The look of a reading; `toWord` puts its value into words and is not called when there is none.
template <typename Value, typename ToWord>
Shown shown(const robot::Reading<Value> &reading, robot::Freshness freshness, ToWord toWord)
{
    if (freshness == robot::Freshness::Refused && reading.refusal)
        return refused(*reading.refusal);
    if (freshness == robot::Freshness::Unknown || !reading.value)
        return unknown();
    const bool isStale = freshness == robot::Freshness::Stale;
    return {toWord(*reading.value), freshness, isStale ? lastSeen(reading.clock) : QString()};
}

} // namespace widgets
