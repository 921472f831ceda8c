// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "journal/record.h"
#include "protocol/text.h"
#include "ui/theme.h"

namespace ui {

// Alarms in the person's language.

/// "Major", "User, system"
[[nodiscard]] QString title(values::AlarmHistoryClass list);
/// With the shape that says the same: "◆ unacknowledged".
[[nodiscard]] QString word(journal::AlarmState state);
/// The colour of that word.
[[nodiscard]] Role roleOf(journal::AlarmState state);

/// Name, servo board and sub-code text as the pendant shows them, unreadable bytes as ⟨8A⟩: "PULSE LIMIT · [SV#1] · S".
[[nodiscard]] QString alarmText(const values::AlarmWithTexts &alarm, const protocol::TextCodec &codec);
/// What the sub code is, and how it was sent: "Axes: S L. As sent: 3, type 3."
[[nodiscard]] QString dataSentence(const values::AlarmData &data);

/// A time of this computer as tables have it, in local time: "2026-01-12 09:30:05".
[[nodiscard]] QString tableTime(const QDateTime &utc);

} // namespace ui
