// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "journal/alarmstatistics.h"
#include "protocol/text.h"
#include <QAbstractTableModel>

namespace models {

/// The alarm codes that came most often. Rows change in place.
class CodeStatisticsModel : public QAbstractTableModel
{
    Q_OBJECT

public:
    enum Column { Code, Name, Count, MeanBetween, Last, columns };

    explicit CodeStatisticsModel(const protocol::TextCodec &codec, QObject *parent = nullptr);

    void show(const QList<journal::CodeStatistics> &statistics);
    [[nodiscard]] const journal::CodeStatistics &at(int row) const { return m_rows[row]; }

    [[nodiscard]] int rowCount(const QModelIndex &parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex &parent = {}) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
    [[nodiscard]] QVariant data(const QModelIndex &index, int role) const override;

private:
    protocol::TextCodec m_codec;
    QList<journal::CodeStatistics> m_rows;
};

/// "3 d 4 h", "2 h 5 min", "12 min"; "under a minute" for 0.
[[nodiscard]] QString durationText(std::chrono::minutes duration);

} // namespace models
