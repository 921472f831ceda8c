// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "protocol/text.h"
#include "robot/robotstate.h"
#include <QJsonObject>
#include <QStringList>

namespace robot {

/// "X 1133.926 mm" for each axis; a number in place of a name that is not known.
[[nodiscard]] QStringList axisWords(const values::Position &position, const values::AxisNames &names);
/// What was read from a controller, in words for a terminal: "name: value" lines, untranslated; what was not read is
/// not there.
[[nodiscard]] QStringList toLines(const RobotState &state, const protocol::TextCodec &codec);
/// The same as JSON, with the names and the units of `pendeskctl decode`.
[[nodiscard]] QJsonObject toJson(const RobotState &state, const protocol::TextCodec &codec);

} // namespace robot
