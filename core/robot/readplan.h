// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "protocol/dialect.h"
#include "robot/topic.h"
#include <set>

namespace robot {

/// One request of a plan.
struct PlannedRead {
    TopicRange range; ///< What it is sent for.
    int count = 1; ///< How many items the packet asks for: one more than the range has where the rule wants it even.

    auto operator<=>(const PlannedRead &) const = default;
};

/// The fewest requests that read everything in `wanted`, in the order of the topics. I/O groups, registers and
/// variables that stand near each other share a plural packet (reference §4.5), also across numbers that nobody wants;
/// a packet never leaves an area of the model and never spans a topic in `refused`. Those are asked for one by one,
/// since a packet with one refused item is refused as a whole.
[[nodiscard]] QList<PlannedRead> planReads(
    const QList<TopicRange> &wanted, const std::set<Topic> &refused, const protocol::Dialect &dialect);

/// Two halves of a read that was refused, to find the item that is meant. It must be more than one.
[[nodiscard]] QList<PlannedRead> halves(const TopicRange &range, const protocol::Dialect &dialect);

} // namespace robot
