// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "cell/comparison.h"
#include "cellfiles/filetypes.h"
#include "files/compare.h"

/// Two backups of a controller, compared by what their files mean.
namespace station {

/// What became of one file.
struct FileDifference {
    values::FileName name;
    files::Change change = files::Change::Same; ///< OnlyNoise: a person need not look at it.
    cellfiles::FileClass fileClass = cellfiles::FileClass::Configuration;
    cell::Statements statements {}; ///< What is different in it; of jobs the edits.

    /// Worth a person's attention, and an exit code.
    [[nodiscard]] bool counts() const { return change != files::Change::Same && change != files::Change::OnlyNoise; }
    [[nodiscard]] bool isSafety() const;
};

/// Every file that is not byte for byte the same, the safety relevant first. Counters, logs, check lines and hours are
/// noise; new or missing ones too. Reads both sets: belongs into a worker.
[[nodiscard]] QList<FileDifference> differencesOf(const files::FileSet &older, const files::FileSet &newer,
    const files::NoiseFilter &noise, const protocol::TextCodec &codec);

/// How many of a class are noise: "2 logs changed".
[[nodiscard]] int foldedCount(const QList<FileDifference> &differences, cellfiles::FileClass fileClass);

/// What the files of a set say of each other.
[[nodiscard]] cell::Knowledge knowledgeOf(const files::FileSet &set, const protocol::TextCodec &codec);

} // namespace station
