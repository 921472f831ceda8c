// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "disk/worker.h"
#include "values/error.h"
#include <QString>

namespace files {

/// Packs a folder with everything in it into one .zip file, in the order of the names and under the name of the folder.
/// What stood at `target` is replaced by the whole file or stays as it was. LocalFile says which file and why.
/// Links are left out. Cancelled as soon as `isWanted` says no, which is asked between two files.
[[nodiscard]] values::Result<void> writeZip(
    const QString &folder, const QString &target, const disk::IsWanted &isWanted = {});

} // namespace files
