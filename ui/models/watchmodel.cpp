// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/models/watchmodel.h"

#include "ui/widgets/shown.h"
#include "ui/widgets/table.h"
#include <QLocale>

namespace models {

using robot::Freshness;

WatchModel::WatchModel(const robot::RobotState &state, robot::SignalWatch &watch, const robot::NameBook &book,
    const protocol::Dialect &dialect, QObject *parent)
    : QAbstractTableModel(parent), m_state {state}, m_watch {watch}, m_book {book}, m_dialect {dialect}
{
    const auto refresh = [this] {
        if (!m_signals.isEmpty())
            Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, columns - 1));
    };
    connect(&watch, &robot::SignalWatch::traced, this, refresh);
    connect(&watch, &robot::SignalWatch::listChanged, this, &WatchModel::onListChanged);
    connect(&book, &robot::NameBook::changed, this, refresh);
    onListChanged();
}

/// One came at the end, or one went.
void WatchModel::onListChanged()
{
    const auto &traces = m_watch.traces();
    for (int row = int(m_signals.size()) - 1; row >= 0; --row) {
        if (!m_watch.isWatched(m_signals[row])) {
            beginRemoveRows({}, row, row);
            m_signals.removeAt(row);
            endRemoveRows();
        }
    }
    if (const int count = int(m_signals.size()); count < traces.size()) {
        beginInsertRows({}, count, int(traces.size()) - 1);
        for (qsizetype row = count; row < traces.size(); ++row)
            m_signals += traces[row].signal;
        endInsertRows();
    }
}

int WatchModel::rowCount(const QModelIndex &parent) const { return parent.isValid() ? 0 : int(m_signals.size()); }

int WatchModel::columnCount(const QModelIndex &parent) const { return parent.isValid() ? 0 : columns; }

QVariant WatchModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal || role != Qt::DisplayRole)
        return {};
    switch (section) {
    case Address: return tr("Signal");
    case Inform: return tr("In jobs");
    case Name: return tr("Name");
    case Value: return tr("Value");
    case Rises: return tr("Rising edges");
    case Falls: return tr("Falling edges");
    case Changed: return tr("Changed");
    default: return {};
    }
}

QString WatchModel::text(const QModelIndex &index) const
{
    const auto *found = m_watch.trace(m_signals[index.row()]);
    if (!found)
        return {}; // it is about to go
    const robot::SignalTrace &trace = *found;
    const auto &reading = m_state.reading<robot::Kind::IoGroup>(trace.signal.group);
    switch (index.column()) {
    case Address: return toString(trace.signal);
    case Inform: return informName(trace.signal, m_dialect);
    case Name: return m_book.names().of(trace.signal).text;
    case Value:
        if (!reading.value)
            return widgets::dash();
        return reading.value->isOn(trace.signal.bit) ? QStringLiteral("■ 1") : QStringLiteral("□ 0");
    case Rises: return QLocale().toString(trace.rises);
    case Falls: return QLocale().toString(trace.falls);
    case Changed: return trace.changed.isValid() ? trace.changed.toString(QStringLiteral("HH:mm:ss")) : widgets::dash();
    default: return {};
    }
}

QVariant WatchModel::data(const QModelIndex &index, int role) const
{
    if (!index.isValid())
        return {};
    const auto group = quint16(m_signals[index.row()].group);
    const bool isValue = index.column() == Value;
    const Freshness freshness = m_state.freshness({robot::Kind::IoGroup, group});
    switch (role) {
    case Qt::DisplayRole: return text(index);
    case Qt::ToolTipRole:
        return freshness == Freshness::Stale ? widgets::lastSeen(m_state.reading<robot::Kind::IoGroup>(group).clock)
                                             : QString();
    case widgets::BoldRole: return isValue;
    case widgets::HatchedRole: return isValue && freshness == Freshness::Stale;
    case widgets::InkRole: return isValue && freshness != Freshness::Live ? QVariant(int(ui::Role::Text3)) : QVariant();
    default: return {};
    }
}

} // namespace models
