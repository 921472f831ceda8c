// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "values/error.h"
#include <QByteArray>

namespace files {

/// Reads a whole local file. LocalFile with the system's reason.
[[nodiscard]] values::Result<QByteArray> readFile(const QString &path);
/// Writes a new file, of which there may be a half after an error. LocalFile with the system's reason.
[[nodiscard]] values::Result<void> writeNew(const QString &path, const QByteArray &content);
/// Writes a file or leaves the old one as it was, even when the power fails.
[[nodiscard]] values::Result<void> replaceFile(const QString &path, const QByteArray &content);
/// Does not come back before the disk has what was written to a file, or into a folder.
[[nodiscard]] values::Result<void> sync(const QString &path);
/// The same for a folder with everything in it, at about the cost of one file.
[[nodiscard]] values::Result<void> syncTree(const QString &folder);

} // namespace files
