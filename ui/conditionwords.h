// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "protocol/dialect.h"
#include "robot/arming.h"
#include "robot/conditions.h"
#include "values/error.h"
#include <QString>

namespace ui {

// Conditions, acts and levels in the person's language; the only place where they are put into words.

/// As it should be: "REMOTE is on".
[[nodiscard]] QString title(robot::Condition condition);
/// As it is when not met: "REMOTE is off".
[[nodiscard]] QString complaint(robot::Condition condition);
/// What helps, with the way through the pendant's menus of this model: "turn the pendant key to REMOTE".
[[nodiscard]] QString remedy(robot::Condition condition, protocol::Model model);
/// The reason beside a button: "REMOTE is off: turn the pendant key to REMOTE".
[[nodiscard]] QString reason(robot::Condition condition, protocol::Model model);
/// "met", "not met", "not read yet", "cannot be read over HSES"
[[nodiscard]] QString word(robot::Verdict verdict);

/// After the try of an act: the error in words, the code with its meaning and remedy (protocol::explain), and the
/// conditions that explain it.
[[nodiscard]] QString explain(robot::Act act, const values::Error &error, protocol::Model model);

[[nodiscard]] QString title(robot::Act act); ///< "Start the job"
[[nodiscard]] QString title(robot::Level level); ///< "Operate"
[[nodiscard]] QString reason(robot::Arming::Drop drop); ///< "nobody used key or mouse for a minute"

} // namespace ui
