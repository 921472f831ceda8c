// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include <QByteArrayList>
#include <span>

namespace inform {

/// A run of lines that differs: `oldCount` lines from `oldFrom` on became `newCount` lines from `newFrom` on. One of
/// the counts may be 0.
struct Hunk {
    int oldFrom = 0;
    int oldCount = 0;
    int newFrom = 0;
    int newCount = 0;

    bool operator==(const Hunk &) const = default;
};

/// The fewest edits that make `newer` of `older` (Myers), in order; equal numbers are equal lines. Beyond some 1,500
/// edits the differing middle is one block: nobody reads such a comparison line by line, and it must not take minutes.
[[nodiscard]] QList<Hunk> diffSequences(std::span<const int> older, std::span<const int> newer);
/// The same for texts.
[[nodiscard]] QList<Hunk> diffLines(const QByteArrayList &older, const QByteArrayList &newer);

} // namespace inform
