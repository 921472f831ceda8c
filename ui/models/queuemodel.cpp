// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/models/queuemodel.h"

#include "protocol/codes.h"
#include "ui/words.h"
#include <QLocale>

using files::OperationState;
using files::ReadBack;
using files::Task;

namespace models {

QueueModel::QueueModel(files::TransferQueue &queue, const protocol::TextCodec &codec, QObject *parent)
    : QAbstractTableModel(parent), m_queue {queue}, m_codec {codec}
{
    using files::TransferQueue;
    connect(&queue, &TransferQueue::aboutToAdd, this, [this](int row) { beginInsertRows({}, row, row); });
    connect(&queue, &TransferQueue::added, this, [this] { endInsertRows(); });
    connect(&queue, &TransferQueue::aboutToRemove, this, [this](int row) { beginRemoveRows({}, row, row); });
    connect(&queue, &TransferQueue::removed, this, [this] { endRemoveRows(); });
    connect(&queue, &TransferQueue::changed, this,
        [this](int row) { Q_EMIT dataChanged(index(row, 0), index(row, ColumnCount - 1)); });
}

int QueueModel::rowCount(const QModelIndex &parent) const { return parent.isValid() ? 0 : m_queue.size(); }

int QueueModel::columnCount(const QModelIndex &parent) const { return parent.isValid() ? 0 : ColumnCount; }

QVariant QueueModel::data(const QModelIndex &index, int role) const
{
    if (!index.isValid())
        return {};
    const Task &task = m_queue.at(index.row());
    if (role == Qt::DisplayRole)
        return text(task, index.column());
    if (role == Qt::ToolTipRole && task.error())
        return protocol::explain(*task.error());
    if (role == Qt::TextAlignmentRole && index.column() >= Bytes)
        return int(Qt::AlignRight | Qt::AlignVCenter);
    return {};
}

QString QueueModel::stateText(const Task &task) const
{
    switch (task.state()) {
    case OperationState::Waiting: return tr("waiting");
    case OperationState::Running: return tr("under way");
    case OperationState::Cancelled: return tr("cancelled");
    case OperationState::Failed: return tr("▲ %1").arg(protocol::explain(*task.error()));
    case OperationState::Done: break;
    }
    const auto *upload = qobject_cast<const files::Upload *>(&task);
    switch (upload ? upload->readBack() : ReadBack::NotYet) {
    case ReadBack::NotYet: return tr("done");
    case ReadBack::Identical: return tr("done, read back identical");
    case ReadBack::Reformatted:
        return tr("done, the controller reformatted %n line(s)", nullptr, upload->reformattedLines());
    case ReadBack::Different: return tr("▲ read back different");
    case ReadBack::Unreadable: return tr("▲ sent, but it could not be read back");
    }
    return {};
}

QString QueueModel::text(const Task &task, int column) const
{
    const QLocale locale;
    switch (column) {
    case Name: return m_codec.decode(task.name().bytes());
    case Direction:
        return task.direction() == files::Direction::Download ? tr("← to the computer")
            : task.direction() == files::Direction::Upload    ? tr("→ to the controller")
                                                              : tr("✕ delete");
    case State: return stateText(task);
    case Bytes:
        return task.bytesTotal() > 0
            ? tr("%1 of %2").arg(locale.toString(task.bytesDone()), locale.toString(task.bytesTotal()))
            : locale.toString(task.bytesDone());
    case Rate: {
        const auto rate = qint64(task.bytesPerSecond());
        return rate > 0 ? tr("%1/s").arg(locale.formattedDataSize(rate)) : QStringLiteral("—");
    }
    case Remaining: return task.isOver() ? QString() : ui::ageText(task.remaining());
    default: return {};
    }
}

QVariant QueueModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal || role != Qt::DisplayRole)
        return {};
    const QString titles[] {tr("File"), tr("Direction"), tr("State"), tr("Bytes"), tr("Rate"), tr("Remaining")};
    return titles[section];
}

} // namespace models
