// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "trend/archive.h"
#include <QAbstractListModel>

namespace models {

/// The kept incidents, the newest first.
class IncidentModel : public QAbstractListModel
{
    Q_OBJECT

public:
    using QAbstractListModel::QAbstractListModel;

    /// Puts a new one on top.
    void add(const trend::IncidentEntry &entry);
    /// Puts those that are not there yet at the end.
    void addOlder(const QList<trend::IncidentEntry> &entries);
    [[nodiscard]] const trend::IncidentEntry &entry(int row) const { return m_entries[row]; }

    [[nodiscard]] int rowCount(const QModelIndex &parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex &index, int role) const override;

private:
    QList<trend::IncidentEntry> m_entries;
};

} // namespace models
