// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "robot/readiness.h"
#include "ui/widgets/shown.h"

namespace ui {

// The readiness of a controller in the person's language; conditions are put into words by ui/conditionwords.

[[nodiscard]] QString title(robot::Subject subject); ///< "Selecting a job"
/// "allowed", "not allowed", "not known", each with its shape.
[[nodiscard]] widgets::Word word(robot::Allowance allowance);
[[nodiscard]] QString word(robot::Evidence evidence); ///< "measured", "assumed", "cannot be read", "not read yet"

/// What it means and, where it applies, what stands in the way or cannot be known; whole sentences.
[[nodiscard]] QString sentence(const robot::ReadinessRow &row, const robot::ReadinessFacts &facts);
/// What a person can do about it, with the way through the pendant's menus; empty if nothing.
[[nodiscard]] QString remedy(const robot::ReadinessRow &row, const robot::ReadinessFacts &facts);

/// All of it as plain text, for support.
[[nodiscard]] QString toText(const QList<robot::ReadinessRow> &rows, const robot::ReadinessFacts &facts);

} // namespace ui
