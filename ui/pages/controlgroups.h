// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "protocol/dialect.h"
#include "robot/robotstate.h"

namespace pages {

constexpr int usualAxes = 6; ///< Rows shown until the controller tells how many.

/// The axis names of every control group that the model may have, by pulse instances (reference §2.1): whoever answers
/// is there.
[[nodiscard]] QList<robot::TopicRange> groupTopics(const protocol::Dialect &dialect);

/// The groups that answered, also those whose names are stale by now; R1 while nobody did. `refused` counts the others.
struct ControlGroups {
    QList<values::ControlGroup> groups;
    int refused = 0;
    int all = 0;
};
[[nodiscard]] ControlGroups controlGroups(const robot::RobotState &state, const protocol::Dialect &dialect);

} // namespace pages
