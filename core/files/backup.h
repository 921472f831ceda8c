// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "files/archive.h"
#include "files/collection.h"
#include <QFutureWatcher>

namespace files {

/// What is to be backed up, and where to.
struct BackupOrder {
    QString root; ///< The folder of all backups.
    BagInfo info; ///< Without time and results.
    Retention retention {}; ///< Applied afterwards.
    bool wantsAllParameters = false; ///< ALL.PRM too, which repeats the other parameter files.
};

/// Reads all files of a controller into a new bag. Done if there is a bag, even if files are missing in it: see info().
class Backup : public Operation
{
    Q_OBJECT

public:
    Backup(session::FileSession &session, BackupOrder order, QObject *parent = nullptr);

    [[nodiscard]] int filesDone() const { return m_collection.filesDone(); }
    [[nodiscard]] int filesTotal() const { return m_collection.filesTotal(); }
    [[nodiscard]] QByteArray current() const { return m_collection.current(); }
    [[nodiscard]] qint64 bytesDone() const { return m_collection.bytesDone(); }
    /// Results and time; complete when it is Done.
    [[nodiscard]] const BagInfo &info() const { return m_order.info; }
    /// Of the bag, when it is Done.
    [[nodiscard]] const QString &path() const { return m_path; }

protected:
    void run() override;
    void interrupt() override { m_collection.cancel(); }

private:
    struct Writing;

    void onCollected();
    void seal();

    BackupOrder m_order;
    Archive m_archive;
    Collection m_collection;
    std::shared_ptr<Writing> m_writing;
    QFutureWatcher<values::Result<QString>> m_sealing;
    QString m_path;
};

} // namespace files
