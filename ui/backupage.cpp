// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/backupage.h"

#include "station/backupchoices.h"

namespace ui {

using namespace std::chrono_literals;
using widgets::Lamp;
using widgets::Word;

Word backupWord(const QDateTime &taken, const QDateTime &now)
{
    constexpr qint64 week = 7;
    if (!taken.isValid())
        return {BackupAge::tr("No backup"), Lamp::Warning};
    const qint64 hours = std::max<qint64>(0, taken.secsTo(now) / 3600);
    if (hours < 24)
        return {BackupAge::tr("Backup %n hour(s) old", nullptr, int(hours)), Lamp::None};
    const qint64 days = hours / 24;
    if (taken.addDays(week) >= now)
        return {BackupAge::tr("Backup %n day(s) old", nullptr, int(days)), Lamp::None};
    return {BackupAge::tr("Old backup: %n day(s)", nullptr, int(days)), Lamp::Warning};
}

BackupAge::BackupAge(const QString &controller, const settings::Notes &notes, QObject *parent)
    : QObject(parent), m_controller {controller}, m_notes {notes}
{
    connect(&m_timer, &QTimer::timeout, this, &BackupAge::look);
    m_timer.start(5s);
    QTimer::singleShot(0, this, &BackupAge::look);
}

void BackupAge::look()
{
    if (m_controller.isEmpty() || m_isLooking)
        return;
    const files::Archive archive {station::readBackupChoices(m_notes).folder, m_controller};
    m_isLooking = true;
    m_disk.run(
        this, [archive] { return archive.newestComplete(); },
        [this](const QDateTime &taken) {
            m_isLooking = false;
            Q_EMIT told(backupWord(taken, QDateTime::currentDateTimeUtc()));
        });
}

} // namespace ui
