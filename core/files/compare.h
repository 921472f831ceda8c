// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "files/fileset.h"
#include "files/noise.h"
#include "protocol/text.h"
#include <QList>

namespace files {

enum class Change {
    Same,
    OnlyNoise, ///< Other bytes, and no difference that a rule in force does not explain away.
    Changed,
    New, ///< In the newer set alone.
    Gone, ///< In the older set alone.
    Unread, ///< Could not be read in one of them, so nobody knows.
};

struct FileChange {
    values::FileName name;
    Change change = Change::Same;

    bool operator==(const FileChange &) const = default;
};

/// Each file of both sets, by name. The bytes of a file are only asked for where the hashes differ and noise counts.
[[nodiscard]] QList<FileChange> compare(const FileSet &older, const FileSet &newer, const NoiseFilter &noise);

/// How many of them are neither Same nor OnlyNoise.
[[nodiscard]] int differences(const QList<FileChange> &changes);

/// How the lines of two versions of a file lie beside each other.
struct ComparedLine {
    int oldLine = -1; ///< From 0; -1: not in the older text.
    int newLine = -1;
    QByteArray older; ///< Without line ending.
    QByteArray newer;
    bool isSame = true;

    bool operator==(const ComparedLine &) const = default;
};
[[nodiscard]] QList<ComparedLine> compareText(
    const QByteArray &older, const QByteArray &newer, const NoiseFilter &noise);

/// What was done to a job, one sentence an edit (inform::diffJobs); empty unless both are jobs.
[[nodiscard]] QStringList jobEdits(
    const QByteArray &older, const QByteArray &newer, const NoiseFilter &noise, const protocol::TextCodec &codec);

} // namespace files
