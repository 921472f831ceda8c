// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "journal/record.h"
#include "ui/theme.h"

namespace ui {

// Records of orders in the person's language.

/// With the shape that says the same: "✗ refused".
[[nodiscard]] QString word(journal::Outcome outcome);
[[nodiscard]] Role roleOf(journal::Outcome outcome);
/// The title of the act with this key; the key itself if there is none, as in a journal of a newer program.
[[nodiscard]] QString actionTitle(const QString &key);
/// "5 → 100", or the one value there is.
[[nodiscard]] QString changeText(const journal::OrderRecord &order);
/// The code and what it means, or why nothing was sent.
[[nodiscard]] QString replyText(const journal::OrderRecord &order);

} // namespace ui
