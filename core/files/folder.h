// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "files/fileset.h"

namespace files {

/// The plain files of a folder, as another program or a USB stick left them: kept in memory, not looked at below it.
/// Hidden files and those that desktops leave behind (Thumbs.db, desktop.ini) are left out. A path to one file is that
/// file alone. LocalFile if nothing can be read there, or it is more than `mostFolderBytes`.
[[nodiscard]] values::Result<FileSet> folderFiles(const QString &path);
constexpr qint64 mostFolderBytes = 256LL * 1024 * 1024;

} // namespace files
