// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/models/alarmhistorymodel.h"

#include "ui/alarmwords.h"

namespace models {

using journal::AlarmRecord;

namespace {

constexpr const char *historyTitles[] {
    QT_TRANSLATE_NOOP("models::AlarmHistoryModel", "Controller time"),
    QT_TRANSLATE_NOOP("models::AlarmHistoryModel", "List"),
    QT_TRANSLATE_NOOP("models::AlarmHistoryModel", "Code"),
    QT_TRANSLATE_NOOP("models::AlarmHistoryModel", "Sub code"),
    QT_TRANSLATE_NOOP("models::AlarmHistoryModel", "Text"),
    QT_TRANSLATE_NOOP("models::AlarmHistoryModel", "Read here"),
};
static_assert(std::size(historyTitles) == AlarmHistoryModel::columns);

} // namespace

AlarmHistoryModel::AlarmHistoryModel(
    journal::Store &store, const QString &controller, const protocol::TextCodec &codec, QObject *parent)
    : RecordModel(parent), m_codec {codec}
{
    load([&store, controller](qint64 newerThan, const journal::Cursor &from, int count, QObject *context,
             journal::Store::Handler<journal::Page<AlarmRecord>> handler) {
        store.alarms({controller, {}, newerThan}, from, count, context, std::move(handler));
    });
}

int AlarmHistoryModel::columnCount(const QModelIndex &parent) const { return parent.isValid() ? 0 : int(columns); }

QVariant AlarmHistoryModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation == Qt::Horizontal && role == Qt::DisplayRole)
        return tr(historyTitles[section]);
    if (orientation == Qt::Horizontal && role == Qt::TextAlignmentRole && section == Code)
        return int(Qt::AlignRight | Qt::AlignVCenter);
    return {};
}

QVariant AlarmHistoryModel::data(const QModelIndex &index, int role) const
{
    const AlarmRecord &record = at(index.row());
    switch (role) {
    case Qt::DisplayRole: return text(record, index.column());
    case Qt::ToolTipRole:
        return index.column() == Data ? ui::dataSentence(record.alarm.alarm.data) : text(record, index.column());
    case Qt::TextAlignmentRole:
        return int((index.column() == Code ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
    case SortRole: return sortKey(record, index.column());
    case ListRole: return int(record.list);
    default: return {};
    }
}

QString AlarmHistoryModel::text(const AlarmRecord &record, int column) const
{
    switch (column) {
    case Time: return m_codec.decode(record.alarm.alarm.time.bytes());
    case List: return ui::title(record.list);
    case Code: return QString::number(record.alarm.alarm.code);
    case Data: return record.alarm.alarm.data.toString();
    case Text: return ui::alarmText(record.alarm, m_codec);
    default: return ui::tableTime(record.seen);
    }
}

QVariant AlarmHistoryModel::sortKey(const AlarmRecord &record, int column) const
{
    switch (column) {
    case Code: return record.alarm.alarm.code;
    case List: return int(record.list);
    case Seen: return record.seen;
    default: return text(record, column);
    }
}

AlarmHistoryFilter::AlarmHistoryFilter(QObject *parent) : QSortFilterProxyModel(parent)
{
    setSortRole(RecordModelBase::SortRole);
}

void AlarmHistoryFilter::setList(std::optional<values::AlarmHistoryClass> list)
{
    m_list = list;
    invalidateFilter();
}

void AlarmHistoryFilter::setSearch(const QString &search)
{
    m_search = search.trimmed();
    invalidateFilter();
}

bool AlarmHistoryFilter::filterAcceptsRow(int row, const QModelIndex &parent) const
{
    const auto cell = [&](int column) { return sourceModel()->index(row, column, parent); };
    if (m_list && cell(0).data(RecordModelBase::ListRole).toInt() != int(*m_list))
        return false;
    for (int column = 0; column < sourceModel()->columnCount(); ++column) {
        if (cell(column).data().toString().contains(m_search, Qt::CaseInsensitive))
            return true;
    }
    return false;
}

} // namespace models
