// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "desk.h"
#include "files/backup.h"

/// What the verbs about backups share.
namespace pendeskctl {

/// A path as it was typed, without the slash that a shell completes.
[[nodiscard]] QString bagAt(const QString &path);

/// The backup at that path, if every byte of it is as it was written. Else it was complained about, and the
/// program is to end with that code.
[[nodiscard]] tl::expected<files::Bag, ExitCode> goodBag(const QString &path);

/// The same for a folder of controller files that is no backup, or for one file.
[[nodiscard]] tl::expected<files::FileSet, ExitCode> goodFiles(const QString &path);

/// What a backup into `root` is to be. What the controller says of itself goes into it; without an answer it is made
/// all the same.
void withOrder(Desk &desk, const QString &root, const std::function<void(const files::BackupOrder &)> &handler);

/// Reads the controller into memory, then goes on. Ends the program if it cannot.
void snapshot(
    Desk &desk, const std::function<void(const files::FileSet &)> &handler, files::Collection::Filter filter = {});

} // namespace pendeskctl
