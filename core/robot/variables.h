// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "robot/poller.h"
#include "settings/profile.h"
#include "variables/text.h"

namespace robot {

/// What was read of one variable or register, whatever its kind.
struct VariableReading {
    std::optional<variables::Value> value;
    QDateTime clock; ///< When it was read, local time.
    std::optional<values::Error> refusal;
    Freshness freshness = Freshness::Unknown;
};

/// The topic of a variable or register, and back; nullopt for topics of other kinds.
[[nodiscard]] Topic topicOf(const variables::Reference &variable);
[[nodiscard]] std::optional<variables::Kind> variableKindOf(Kind kind);

[[nodiscard]] VariableReading readingOf(const RobotState &state, const variables::Reference &variable);

/// How the values of a controller are written for its people.
[[nodiscard]] variables::Format formatOf(const settings::Profile &profile);

/// Tells the state what was read of a variable in another way, such as the read back after a write.
void note(Poller &poller, const variables::Reference &variable, const variables::Value &value);

} // namespace robot
