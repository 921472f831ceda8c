// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "cell/hints.h"

/// Where things are used, in translated words.
namespace cell {

/// "written", "read", "waited for", "called", "jumped to", "started", "named"; with "may be" before it for a use that
/// is known only when the line runs.
[[nodiscard]] QString useText(const Use &use);
/// "CLAMP line 7", "CIOPRG.LST line 30"; the file alone where the line is not known.
[[nodiscard]] QString placeText(const Place &place, const Cell &cell);
/// The line itself: the instruction of a job, or of the ladder; empty for names.
[[nodiscard]] QString lineText(const Place &place, const Cell &cell);
/// "B012 LANE": the thing and what people call it.
[[nodiscard]] QString subjectText(const Subject &subject, const Cell &cell);
/// A whole sentence.
[[nodiscard]] QString sentence(const Hint &hint, const Cell &cell);

} // namespace cell
