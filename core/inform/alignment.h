// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "inform/canonical.h"
#include "inform/linediff.h"

namespace inform {

/// A line of the older job and what became of it, by the controller's line numbers. -1: it was added, or removed.
struct LinePair {
    int older = -1;
    int newer = -1;
    bool isSame = false; ///< They say the same (lineKey).

    [[nodiscard]] bool isBoth() const { return older >= 0 && newer >= 0; }
};

/// A smallest edit over the lines of two jobs: lines that say the same first, then those that are alike: the same
/// instruction with other operands, a step that goes elsewhere. In the order of the newer job, removed lines where they
/// were.
[[nodiscard]] QList<LinePair> alignLines(const Job &older, const Job &newer, const Clean &clean);

} // namespace inform
