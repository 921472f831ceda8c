// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "values/error.h"
#include <QByteArray>
#include <functional>

class QIODevice;

/// Files that are whole: read from regular files alone, written so that a crash, a full disk or a power failure leaves
/// the old file or the new one, never a half. Every error is LocalFile, "path: the system's reason". All of it may
/// block; the window calls it through a Worker.
namespace disk {

/// Who may read a file that is written.
enum class Readers {
    AsUsual, ///< What the user's umask says, or what the replaced file said.
    OwnerOnly, ///< 0600.
};

/// Reads a whole regular file, through a link if it is one. A pipe, device or socket is an error and is not waited for.
[[nodiscard]] values::Result<QByteArray> readFile(const QString &path);
/// Writes a new file, of which there may be a half after an error.
[[nodiscard]] values::Result<void> writeNew(const QString &path, const QByteArray &content);
/// Replaces a file, or leaves the old one as it was.
[[nodiscard]] values::Result<void> replaceFile(
    const QString &path, const QByteArray &content, Readers readers = Readers::AsUsual);
/// The same for what is written piece by piece; an error of `write` leaves the old file.
[[nodiscard]] values::Result<void> replaceFile(const QString &path,
    const std::function<values::Result<void>(QIODevice &)> &write, Readers readers = Readers::AsUsual);
/// Removes what a killed program left beside `path` while it replaced it. Only while nobody else replaces it.
void removeLeftovers(const QString &path);
/// Makes the folder, with those above it, for nobody else to look into (0700).
[[nodiscard]] values::Result<void> makePrivateFolder(const QString &path);

/// Does not come back before the disk has what was written to a file, or into a folder. Where the file system does not
/// know how (some network shares), that is no error.
[[nodiscard]] values::Result<void> sync(const QString &path);
/// The same for a folder with everything in it, at about the cost of one file.
[[nodiscard]] values::Result<void> syncTree(const QString &folder);

} // namespace disk
