// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "station/backupchoices.h"

#include <QStandardPaths>

namespace station {

namespace {

const QString choicesSubject = QStringLiteral("backup");

QString usualFolder()
{
    return QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation) + QStringLiteral("/Pendesk backups");
}

} // namespace

BackupChoices readBackupChoices(const settings::Notes &notes)
{
    const QJsonObject json = notes.read(choicesSubject);
    const QString folder = json.value(u"folder").toString();
    return {folder.isEmpty() ? usualFolder() : folder,
        {std::max(0, json.value(u"keep").toInt()), std::max(0, json.value(u"keepDays").toInt())}};
}

void writeBackupChoices(settings::Notes notes, const BackupChoices &choices)
{
    notes.write(choicesSubject,
        {{QStringLiteral("folder"), choices.folder}, {QStringLiteral("keep"), choices.retention.count},
            {QStringLiteral("keepDays"), choices.retention.days}});
}

} // namespace station
