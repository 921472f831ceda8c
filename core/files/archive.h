// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "files/bag.h"
#include <QFileInfo>
#include <QLockFile>

namespace files {

/// One backup of the timeline.
struct ArchiveEntry {
    QString id; ///< Name of its folder: the time in UTC.
    QString path;
    QDateTime taken; ///< UTC.
    int files = 0; ///< That are in it.
    int failures = 0; ///< What should be in it and is not.
    bool isReadable = true; ///< False for a folder that is no bag any more.
    bool isPinned = false;

    [[nodiscard]] bool isComplete() const { return isReadable && failures == 0; }
    bool operator==(const ArchiveEntry &) const = default;
};

/// How many backups are kept.
struct Retention {
    int count = 0; ///< The newest ones; 0 for any number.
    int days = 0; ///< Those that are not older; 0 for any age.
};

/// The ids that may go, of `newestFirst`: beyond the count or the age, not pinned, and not `lastGood`.
[[nodiscard]] QStringList expired(
    const QList<ArchiveEntry> &newestFirst, const Retention &retention, const QDateTime &now, const QString &lastGood);

/// The backups of one controller: `<root>/<controller>/<UTC time>/`.
class Archive
{
public:
    Archive(const QString &root, const QString &controller);

    [[nodiscard]] const QString &folder() const { return m_folder; }
    /// Whole ones alone, the newest first.
    [[nodiscard]] QList<ArchiveEntry> entries() const;
    /// When the newest one was taken that lacks nothing; invalid if there is none. May run in another thread.
    [[nodiscard]] QDateTime newestComplete() const;

    /// Nobody else writes here while the lock is held. LocalFile if somebody does, or the folder cannot be written. The
    /// lock of a program that was killed does not count.
    [[nodiscard]] values::Result<std::unique_ptr<QLockFile>> lock() const;
    /// Takes away what killed programs have left half done; only while locked.
    void clearPartials() const;

    /// A pinned backup never expires.
    [[nodiscard]] values::Result<void> setPinned(const QString &id, bool isPinned) const;
    /// Deletes what has expired, never the last one that verifies; only while locked. The ids of what is gone. Reads
    /// whole bags and may run in another thread.
    [[nodiscard]] values::Result<QStringList> prune(const Retention &retention, const QDateTime &now) const;

private:
    [[nodiscard]] QFileInfoList folders() const;
    [[nodiscard]] QStringList pinned() const;
    [[nodiscard]] QString lastGood(const QList<ArchiveEntry> &newestFirst) const;

    QString m_folder;
};

/// The names of the controllers that have a folder in `root`, as folders.
[[nodiscard]] QStringList archivedControllers(const QString &root);

} // namespace files
