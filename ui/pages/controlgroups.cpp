// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/pages/controlgroups.h"

namespace pages {

using robot::Freshness;
using robot::Kind;
using robot::TopicRange;
using values::ControlGroup;

QList<TopicRange> groupTopics(const protocol::Dialect &dialect)
{
    return {TopicRange(Kind::AxisNames, 1, dialect.robots), TopicRange(Kind::AxisNames, 11, 10 + dialect.bases),
        TopicRange(Kind::AxisNames, 21, 20 + dialect.stations)};
}

ControlGroups controlGroups(const robot::RobotState &state, const protocol::Dialect &dialect)
{
    ControlGroups result;
    for (const TopicRange &range : groupTopics(dialect)) {
        for (quint16 number = range.first; number <= range.last; ++number) {
            const auto freshness = state.freshness({Kind::AxisNames, number});
            if (freshness == Freshness::Live || freshness == Freshness::Stale)
                result.groups << ControlGroup {number};
            result.refused += freshness == Freshness::Refused;
            ++result.all;
        }
    }
    if (result.groups.isEmpty())
        result.groups << ControlGroup::robotPulse(1);
    return result;
}

} // namespace pages
