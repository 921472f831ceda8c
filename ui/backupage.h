// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "disk/worker.h"
#include "settings/notes.h"
#include "ui/widgets/shown.h"
#include <QDateTime>
#include <QTimer>

namespace ui {

/// How old a backup is in words; older than a week, or none at all, is marked as abnormal. Invalid: there is none.
[[nodiscard]] widgets::Word backupWord(const QDateTime &taken, const QDateTime &now);

/// Follows the age of the last complete backup of a controller, whoever writes it: this window, or pendeskctl at night.
class BackupAge : public QObject
{
    Q_OBJECT

public:
    BackupAge(const QString &controller, const settings::Notes &notes, QObject *parent = nullptr);

Q_SIGNALS:
    /// The folder was looked into: soon after the start, then every five seconds.
    void told(const widgets::Word &word);

private:
    void look();

    QString m_controller;
    settings::Notes m_notes;
    QTimer m_timer;
    bool m_isLooking = false;
    disk::Worker m_disk; ///< A folder in the network can keep one waiting.
};

} // namespace ui
