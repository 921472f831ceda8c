// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "files/bagtext.h"
#include <functional>
#include <set>

namespace files {

/// The files of a controller at some moment: from a bag, or as they were just read.
struct FileSet {
    std::map<values::FileName, QByteArray> hashes; ///< SHA-256 in lower-case hex of what is there.
    std::set<values::FileName> unread; ///< Was there and could not be read: nothing can be said about it.
    std::set<QByteArray>
        unlisted; ///< Extensions of which no list could be had, so that nothing is known to be missing.
    /// The bytes of one of them. LocalFile if they are no longer what `hashes` says.
    std::function<values::Result<QByteArray>(const values::FileName &)> content;
};

/// What was read, kept in memory.
[[nodiscard]] FileSet fileSetOf(std::map<values::FileName, QByteArray> contents);

/// Marks in `set` what `results` say could not be read or listed.
void markUnread(FileSet &set, const QList<FileResult> &results);

} // namespace files
