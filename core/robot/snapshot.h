// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "robot/robotstate.h"
#include <QJsonObject>
#include <QStringList>

namespace robot {

/// What was read from a controller, in words for a terminal: "name: value" lines, untranslated, only what is live.
[[nodiscard]] QStringList toLines(const RobotState &state);
/// The same as JSON: numbers in the units of the wire, named by their unit.
[[nodiscard]] QJsonObject toJson(const RobotState &state);

} // namespace robot
