// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "protocol/text.h"
#include "ui/models/recordmodel.h"
#include <QSortFilterProxyModel>

namespace models {

/// Past alarms of one controller, as the journal has them.
class AlarmHistoryModel : public RecordModel<journal::AlarmRecord>
{
    Q_OBJECT

public:
    enum Column { Time, List, Code, Data, Text, Seen, columns };

    /// `store` must outlive the model.
    AlarmHistoryModel(
        journal::Store &store, const QString &controller, const protocol::TextCodec &codec, QObject *parent = nullptr);

    [[nodiscard]] int columnCount(const QModelIndex &parent = {}) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
    [[nodiscard]] QVariant data(const QModelIndex &index, int role) const override;

private:
    [[nodiscard]] QString text(const journal::AlarmRecord &record, int column) const;
    [[nodiscard]] QVariant sortKey(const journal::AlarmRecord &record, int column) const;

    protocol::TextCodec m_codec;
};

/// The rows of one list whose texts contain what was searched for. Words are searched in every column.
class AlarmHistoryFilter : public QSortFilterProxyModel
{
    Q_OBJECT

public:
    explicit AlarmHistoryFilter(QObject *parent = nullptr);

    void setList(std::optional<values::AlarmHistoryClass> list);
    void setSearch(const QString &search);

protected:
    [[nodiscard]] bool filterAcceptsRow(int row, const QModelIndex &parent) const override;

private:
    std::optional<values::AlarmHistoryClass> m_list;
    QString m_search;
};

} // namespace models
