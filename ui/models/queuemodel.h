// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "files/queue.h"
#include "protocol/text.h"
#include <QAbstractTableModel>

namespace models {

/// The transfer queue as a table: file, direction, state, bytes, rate, remaining.
class QueueModel : public QAbstractTableModel
{
    Q_OBJECT

public:
    enum Column { Name, Direction, State, Bytes, Rate, Remaining, ColumnCount };

    /// `queue` must outlive the model.
    QueueModel(files::TransferQueue &queue, const protocol::TextCodec &codec, QObject *parent = nullptr);

    [[nodiscard]] int rowCount(const QModelIndex &parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex &parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex &index, int role) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    [[nodiscard]] QString text(const files::Task &task, int column) const;
    [[nodiscard]] QString stateText(const files::Task &task) const;

    files::TransferQueue &m_queue;
    protocol::TextCodec m_codec;
};

} // namespace models
