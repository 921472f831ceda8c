// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/models/codestatisticsmodel.h"

#include "ui/widgets/shown.h"
#include "ui/widgets/table.h"
#include <QCoreApplication>
#include <QLocale>

using namespace std::chrono_literals;

namespace models {

namespace {

constexpr const char *statisticsTitles[] {
    QT_TRANSLATE_NOOP("models::CodeStatisticsModel", "Code"),
    QT_TRANSLATE_NOOP("models::CodeStatisticsModel", "Name"),
    QT_TRANSLATE_NOOP("models::CodeStatisticsModel", "Times"),
    QT_TRANSLATE_NOOP("models::CodeStatisticsModel", "Mean time between"),
    QT_TRANSLATE_NOOP("models::CodeStatisticsModel", "Last, controller time"),
};
static_assert(std::size(statisticsTitles) == CodeStatisticsModel::columns);

int statisticsAlignment(int column)
{
    const bool isText = column == CodeStatisticsModel::Name || column == CodeStatisticsModel::Last;
    return int((isText ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
}

} // namespace

QString durationText(std::chrono::minutes duration)
{
    using Days = std::chrono::duration<qint64, std::ratio<86400>>;
    const auto days = std::chrono::duration_cast<Days>(duration);
    const auto hours = std::chrono::duration_cast<std::chrono::hours>(duration - days);
    const auto minutes = duration - days - hours;
    if (days.count() > 0)
        return CodeStatisticsModel::tr("%1 d %2 h").arg(days.count()).arg(hours.count());
    if (hours.count() > 0)
        return CodeStatisticsModel::tr("%1 h %2 min").arg(hours.count()).arg(minutes.count());
    return duration == 0min ? CodeStatisticsModel::tr("under a minute")
                            : CodeStatisticsModel::tr("%1 min").arg(minutes.count());
}

CodeStatisticsModel::CodeStatisticsModel(const protocol::TextCodec &codec, QObject *parent)
    : QAbstractTableModel(parent), m_codec {codec}
{
}

void CodeStatisticsModel::show(const QList<journal::CodeStatistics> &statistics)
{
    const int before = int(m_rows.size());
    const int now = int(statistics.size());
    if (now < before) {
        beginRemoveRows({}, now, before - 1);
        m_rows = m_rows.first(now);
        endRemoveRows();
    } else if (now > before) {
        beginInsertRows({}, before, now - 1);
        m_rows = statistics;
        endInsertRows();
    }
    m_rows = statistics;
    if (now > 0)
        Q_EMIT dataChanged(index(0, 0), index(now - 1, columns - 1));
}

int CodeStatisticsModel::rowCount(const QModelIndex &parent) const { return parent.isValid() ? 0 : int(m_rows.size()); }

int CodeStatisticsModel::columnCount(const QModelIndex &parent) const { return parent.isValid() ? 0 : int(columns); }

QVariant CodeStatisticsModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal)
        return {};
    if (role == Qt::DisplayRole)
        return tr(statisticsTitles[section]);
    return role == Qt::TextAlignmentRole ? QVariant(statisticsAlignment(section)) : QVariant();
}

QVariant CodeStatisticsModel::data(const QModelIndex &index, int role) const
{
    const journal::CodeStatistics &row = m_rows[index.row()];
    if (role == Qt::TextAlignmentRole)
        return statisticsAlignment(index.column());
    if (role == widgets::BoldRole)
        return index.column() == Code;
    if (role != Qt::DisplayRole && role != Qt::ToolTipRole)
        return {};
    switch (index.column()) {
    case Code: return QString::number(row.code);
    case Name: return m_codec.decode(row.name.bytes());
    case Count: return QLocale().toString(row.count);
    case MeanBetween: return row.meanBetween ? durationText(*row.meanBetween) : widgets::dash();
    default: return row.last.isValid() ? row.last.toString(QStringLiteral("yyyy/MM/dd HH:mm")) : widgets::dash();
    }
}

} // namespace models
