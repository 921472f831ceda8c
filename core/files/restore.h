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
    QString reason = {}; ///< In a sentence, where it is not allowed or needs care.
    bool needsCare = false; ///< It changes how the robot moves: only sent where a person chose it (reference §13).

    [[nodiscard]] bool isSent() const { return step == RestoreStep::New || step == RestoreStep::Changed; }
    bool operator==(const RestoreItem &) const = default;
};

/// What is wanted of a restore.
struct RestoreWish {
    QList<values::FileName> names = {}; ///< All of the bag's if it is empty. What is named needs no more care.
    QByteArrayList jobsInUse = {};
    bool isAnotherRobot = false; ///< Then nothing but jobs and names may be sent, and only what is named.
};

/// What it would take to bring the files of `bag` back to a controller that has the files of `controller`, in the order
/// in which they are sent: what others refer to first, called jobs before their callers, variables last (controller
/// files reference §13). Calibration, parameters, ladder, safety files, addresses, logs and counters never go back.
/// What a controller has reformatted (dates, blanks, line ends) is the same.
[[nodiscard]] QList<RestoreItem> planRestore(
    const FileSet &bag, const FileSet &controller, const RestoreWish &wish = {});

/// Carries out a plan that a person has seen: a fresh backup, then the new and the changed files one by one, each read
/// back. A file that the controller refuses is noted and the others are sent; it stops at any other error, and before
/// anything is sent if the controller's files are no longer those of the plan. Never while a job runs: `guard` is asked
/// before each file.
class Restore : public Operation
{
    Q_OBJECT

public:
    Restore(session::FileSession &session, FileSet bag, QList<RestoreItem> plan, BackupOrder freshBackup, Guard guard,
        QObject *parent = nullptr);

    [[nodiscard]] const QList<RestoreItem> &plan() const { return m_plan; }
    [[nodiscard]] int filesDone() const { return m_done; }
    [[nodiscard]] int filesTotal() const;
    /// The files that the controller refused; then it has failed in the end, with the first refusal.
    [[nodiscard]] const QList<FileResult> &refusals() const { return m_refusals; }
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
    void goOn();

    QPointer<session::FileSession> m_files;
    FileSet m_bag;
    QList<RestoreItem> m_plan;
    Guard m_guard;
    Backup m_backup;
    FileSet m_before; ///< From the fresh backup.
    std::unique_ptr<Upload> m_upload;
    int m_next = 0; ///< Index in the plan.
    int m_done = 0;
    QList<FileResult> m_refusals;
};

} // namespace files
