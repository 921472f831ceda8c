// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "disk/worker.h"
#include "files/archive.h"
#include <QTreeWidget>

namespace pages {

/// The backups of a controller, newest first, and in how many files each differs from the one before.
class Timeline : public QTreeWidget
{
    Q_OBJECT

public:
    explicit Timeline(QWidget *parent = nullptr);

    /// Rows are changed in place, so that the chosen one stays. What changed is counted in the background.
    void showEntries(const QList<files::ArchiveEntry> &entries);
    [[nodiscard]] const QList<files::ArchiveEntry> &entries() const { return m_entries; }
    /// -1 if none is chosen.
    [[nodiscard]] int chosenRow() const;
    [[nodiscard]] std::optional<files::ArchiveEntry> chosen() const;

private:
    void showRows();

    QList<files::ArchiveEntry> m_entries; ///< As the rows.
    QHash<QString, int> m_changes; ///< By id: files that differ from the backup before.
    std::unique_ptr<QObject> m_count; ///< Wants the count that is under way.
    disk::Worker m_counting; // a folder in the network can keep one waiting
};

} // namespace pages
