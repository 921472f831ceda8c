// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "files/restore.h"
#include "station/backupchoices.h"
#include "station/fileorders.h"

namespace station {

/// The backups of one controller, and the one procedure at a time that reads its files for them: a backup, a comparison
/// or a restore. It goes on whatever window looks on.
class Backups : public QObject
{
    Q_OBJECT

public:
    using FilesHandler = std::function<void(const values::Result<files::FileSet> &)>;

    /// `orders` must outlive it.
    Backups(FileOrders &orders, const robot::Controller &controller, settings::Notes notes, QObject *parent = nullptr);
    ~Backups() override;

    [[nodiscard]] const BackupChoices &choices() const { return m_choices; }
    /// From now on and after a restart.
    void setChoices(const BackupChoices &choices);
    /// In the folder that was chosen.
    [[nodiscard]] files::Archive archive() const;

    /// Which controller a backup would be of, as it says of itself now.
    [[nodiscard]] files::BagInfo info() const { return order({}).info; }
    /// Something is being read or sent.
    [[nodiscard]] bool isBusy() const;
    /// Reads every file into a new backup; false without a link and while busy.
    bool backUp();
    /// The present or the last one; nullptr before the first.
    [[nodiscard]] const files::Backup *backup() const { return m_backup.get(); }
    /// Reads every file of the controller into memory; false without a link and while busy, and `handler` is not called
    /// then. It is not called either when `context` is gone by the time.
    bool read(QObject *context, FilesHandler handler);
    /// The reading of read(); nullptr before the first.
    [[nodiscard]] const files::Snapshot *snapshot() const { return m_snapshot.get(); }
    /// Makes the procedure that carries out a plan a person has seen; not started. What it sends is written into the
    /// journal. nullptr without a link and while busy. It goes on when the caller lets go of it.
    [[nodiscard]] std::shared_ptr<files::Restore> restore(
        const files::FileSet &bag, const QList<files::RestoreItem> &plan);

Q_SIGNALS:
    /// Another file, or isBusy() changed.
    void progressed();
    /// A backup came to its end: see backup().
    void backedUp();

private:
    [[nodiscard]] files::BackupOrder order(const files::Retention &retention) const;

    FileOrders &m_orders;
    const robot::Controller &m_controller;
    settings::Notes m_notes;
    BackupChoices m_choices;
    std::unique_ptr<files::Backup> m_backup;
    std::unique_ptr<files::Snapshot> m_snapshot;
    std::shared_ptr<files::Restore> m_restore;
};

} // namespace station
