// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "inform/canonical.h"
#include "inform/pointdiff.h"
#include <QString>

namespace inform {

enum class EditKind {
    // The header (reference §2); `subject` says which.
    NameChanged,
    FolderChanged,
    CommentChanged,
    AttributeAdded, ///< `subject`: "RJ"
    AttributeRemoved,
    FrameChanged, ///< Of a relative job; empty if it has none.
    GroupChanged, ///< `subject`: "1", "2"; empty if there is none.
    LocalsChanged, ///< `subject`: "LB"
    AliasChanged, ///< `subject`: the variable; empty if it has no alias.
    ArgumentChanged, ///< `subject`: "1" to "8"; type and comment.
    // A position; `subject` is its name, and `line` the line that owns it, or -1.
    PointAdded, ///< Without a new line; `newer` are its values.
    PointRemoved,
    PointChanged, ///< See `point`.
    // The lines.
    LineAdded, ///< With its points, which `newer` lists.
    LineRemoved,
    LinesMoved, ///< `count` lines from `oldLine` to `line`.
    LineChanged, ///< As a whole: `older` → `newer`.
    OperandChanged, ///< `subject` is its tag, "V", or empty; empty `older` or `newer`: it was added or removed.
    CommentedOut, ///< COMM
    CommentedIn,
    Locked, ///< EDTLCK
    Unlocked,
    RemarkChanged, ///< The trailing comment.
};

/// One difference between two versions of a job. Bytes are in the pendant's encoding.
struct JobEdit {
    EditKind kind = EditKind::LineChanged;
    int line = -1; ///< The controller's line number in the newer job; in the older one if the line was removed.
    QByteArray instruction = {}; ///< Of OperandChanged: "MOVL", "SET B005", "+MOVJ".
    QByteArray group = {}; ///< The groups that a further part moves: "RB2".
    QByteArray subject = {};
    QByteArray older = {};
    QByteArray newer = {};
    int oldLine = -1; ///< LinesMoved: where they stood.
    int count = 1;
    PointChange point = {};

    bool operator==(const JobEdit &) const = default;
};

/// What was done to make `newer` of `older`: header, then lines with the points that they own, then the position
/// variables that the job names. C, BC and EC points are the same if the lines that own them are (reference §10.4), for
/// the controller numbers them anew with every insertion. Not compared: ///DATE and ///NPOS, indentation, how numbers
/// are written.
[[nodiscard]] QList<JobEdit> diffJobs(const Job &older, const Job &newer, const Clean &clean = {});

/// How bytes of the pendant become text.
using Decode = std::function<QString(QByteArrayView)>;

/// In a sentence: "Line 14 MOVL: V 100.0 → 150.0". Numbers have a decimal point in every language, as in the file.
[[nodiscard]] QString explain(const JobEdit &edit, const Decode &decode);

} // namespace inform
