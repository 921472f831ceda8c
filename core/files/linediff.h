// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include <QByteArrayList>

namespace files {

/// A run of lines that differs: `oldCount` lines from `oldFrom` on became `newCount` lines from `newFrom` on. One of
/// the counts may be 0.
struct Block {
    int oldFrom = 0;
    int oldCount = 0;
    int newFrom = 0;
    int newCount = 0;

    bool operator==(const Block &) const = default;
};

/// The fewest line edits that make `newer` of `older` (Myers), in order. Beyond some 1,500 edits the differing middle
/// is one block: nobody reads such a comparison line by line, and it must not take minutes.
[[nodiscard]] QList<Block> diffLines(const QByteArrayList &older, const QByteArrayList &newer);

} // namespace files
