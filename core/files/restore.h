// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "files/backup.h"
#include "files/compare.h"
#include "files/preflight.h"
#include "files/task.h"

namespace files {

enum class RestoreStep {
    New, ///< The controller does not have it.
    Changed, ///< The controller has another one.
    Same, ///< Byte for byte: it is left alone.
    NotAllowed, ///< See `reason`.
};

/// What a restore is going to do with one file of the bag.
struct RestoreItem {
    values::FileName name;
    RestoreStep step = RestoreStep::Same;
    QString reason = {}; ///< In a sentence, where it is not allowed.

    [[nodiscard]] bool isSent() const { return step == RestoreStep::New || step == RestoreStep::Changed; }
    bool operator==(const RestoreItem &) const = default;
};

/// What it would take to bring the files of `bag` back to a controller that has the files of `controller`, by name.
/// `names` are wanted; all of them if it is empty. A file that the bag does not have is not allowed.
[[nodiscard]] QList<RestoreItem> planRestore(const FileSet &bag, const FileSet &controller,
    const QList<values::FileName> &names = {}, const QByteArrayList &jobsInUse = {});

/// Carries out a plan that a person has seen: a fresh backup, then the new and the changed files one by one, each read
/// back. It stops at the first error, and before anything is sent if the controller's files are no longer those of the
/// plan. Never while a job runs: `guard` is asked before each file.
class Restore : public Operation
{
    Q_OBJECT

public:
    Restore(session::FileSession &session, FileSet bag, QList<RestoreItem> plan, BackupOrder freshBackup, Guard guard,
        QObject *parent = nullptr);

    [[nodiscard]] const QList<RestoreItem> &plan() const { return m_plan; }
    [[nodiscard]] int filesDone() const { return m_done; }
    [[nodiscard]] int filesTotal() const;
    /// The backup that is made first; its progress while nothing has been sent.
    [[nodiscard]] const Backup &backup() const { return m_backup; }
    /// The file of the plan that is under way, or at which it stopped; empty before and after.
    [[nodiscard]] std::optional<values::FileName> current() const;
    /// Where the file at which it stopped can be put back as it was in the fresh backup.
    [[nodiscard]] bool canPutBack() const;
    /// Sends that file as it was. The task belongs to the caller and is not started.
    [[nodiscard]] std::unique_ptr<Upload> putBack() const;

Q_SIGNALS:
    /// A file was sent, or could not be; for the journal.
    void tried(const files::Upload *upload);

protected:
    void run() override;
    void interrupt() override;

private:
    void onBackedUp();
    [[nodiscard]] bool isStillAsPlanned() const;
    void sendNext();
    void onSent();

    QPointer<session::FileSession> m_files;
    FileSet m_bag;
    QList<RestoreItem> m_plan;
    Guard m_guard;
    Backup m_backup;
    FileSet m_before; ///< From the fresh backup.
    std::unique_ptr<Upload> m_upload;
    int m_next = 0; ///< Index in the plan.
    int m_done = 0;
};

} // namespace files
