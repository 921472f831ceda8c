// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/models/incidentmodel.h"

#include "trend/moment.h"
#include <QLocale>

namespace models {

void IncidentModel::add(const trend::IncidentEntry &entry)
{
    beginInsertRows({}, 0, 0);
    m_entries.prepend(entry);
    endInsertRows();
}

void IncidentModel::addOlder(const QList<trend::IncidentEntry> &entries)
{
    QList<trend::IncidentEntry> older = entries;
    older.removeIf([this](const trend::IncidentEntry &entry) { return m_entries.contains(entry); });
    if (older.isEmpty())
        return;
    beginInsertRows({}, int(m_entries.size()), int(m_entries.size() + older.size()) - 1);
    m_entries += older;
    endInsertRows();
}

int IncidentModel::rowCount(const QModelIndex &parent) const { return parent.isValid() ? 0 : int(m_entries.size()); }

QVariant IncidentModel::data(const QModelIndex &index, int role) const
{
    if (!checkIndex(index, CheckIndexOption::IndexIsValid))
        return {};
    const trend::IncidentEntry &entry = m_entries[index.row()];
    if (role == Qt::DisplayRole)
        return tr("%1  %2").arg(
            QLocale().toString(trend::toLocalTime(entry.at), QStringLiteral("yyyy-MM-dd HH:mm:ss")), entry.title);
    return role == Qt::ToolTipRole ? QVariant(entry.title) : QVariant();
}

} // namespace models
