// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/models/trackmodel.h"

#include "trend/decimate.h"
#include "trend/moment.h"
#include "ui/widgets/plot.h"
#include "ui/widgets/plottable.h"
#include "ui/widgets/shown.h"
#include "ui/words.h"
#include <algorithm>

namespace models {

using trend::Track;

void TrackModel::setTracks(const std::vector<const Track *> &tracks)
{
    const auto trackOf = [&](const trend::Signal &signal) {
        const auto found = std::ranges::find(tracks, signal, [](const Track *track) { return track->signal; });
        return found == tracks.end() ? nullptr : *found;
    };
    for (int row = int(m_rows.size()) - 1; row >= 0; --row) {
        if (const Track *track = trackOf(m_rows[row].signal)) {
            m_rows[row].track = track;
            continue;
        }
        beginRemoveRows({}, row, row);
        m_rows.removeAt(row);
        endRemoveRows();
    }
    for (const Track *track : tracks) {
        if (std::ranges::find(m_rows, track->signal, &Row::signal) != m_rows.end())
            continue;
        const int row = int(m_rows.size());
        beginInsertRows({}, row, row);
        m_rows << Row {track->signal, track, shownCount() < widgets::Plot::mostTracks, {}, {}, {}, {}, {}};
        endInsertRows();
    }
    assignLetters();
}

int TrackModel::shownCount() const { return int(std::ranges::count_if(m_rows, &Row::isShown)); }

/// After rows came, went or changed their check mark.
void TrackModel::assignLetters()
{
    int next = 0;
    for (Row &row : m_rows)
        row.letter = row.isShown ? QString(widgets::Plot::letter(next++)) : QString();
    if (!m_rows.isEmpty())
        Q_EMIT dataChanged(index(0, 0), index(int(m_rows.size()) - 1, Highest));
    Q_EMIT shownChanged();
}

std::vector<const Track *> TrackModel::shown() const
{
    std::vector<const Track *> result;
    for (const Row &row : m_rows) {
        if (row.isShown)
            result.push_back(row.track);
    }
    return result;
}

void TrackModel::refresh(const trend::Range &range, std::optional<trend::Moment> cursor)
{
    for (Row &row : m_rows)
        refreshRow(row, range, cursor);
    if (!m_rows.isEmpty())
        Q_EMIT dataChanged(index(0, Value), index(int(m_rows.size()) - 1, Highest));
}

void TrackModel::refreshRow(Row &row, const trend::Range &range, std::optional<trend::Moment> cursor) const
{
    const trend::Series &series = row.track->series;
    const auto text = [&](double value) { return ui::quantityText({value, row.track->unit}); };
    const trend::Sample *sample = series.valueAt(std::min(cursor.value_or(range.to), range.to));
    row.value = sample ? text(sample->value) : widgets::dash();
    row.note = sample ? QString() : tr("Not read at that time.");
    trend::Extent extent;
    for (const trend::Sample &in : series.within(range))
        extent.include(in.value);
    row.lowest = extent.isEmpty() ? widgets::dash() : text(extent.lowest);
    row.highest = extent.isEmpty() ? widgets::dash() : text(extent.highest);
}

int TrackModel::rowCount(const QModelIndex &parent) const { return parent.isValid() ? 0 : int(m_rows.size()); }

int TrackModel::columnCount(const QModelIndex &parent) const { return parent.isValid() ? 0 : Highest + 1; }

QVariant TrackModel::data(const QModelIndex &index, int role) const
{
    if (!checkIndex(index, CheckIndexOption::IndexIsValid))
        return {};
    const Row &row = m_rows[index.row()];
    switch (role) {
    case Qt::DisplayRole: return text(row, index.column());
    case Qt::CheckStateRole:
        return index.column() == Letter ? QVariant(row.isShown ? Qt::Checked : Qt::Unchecked) : QVariant();
    case Qt::TextAlignmentRole:
        return index.column() == Label || index.column() == Unit || index.column() == Letter
            ? int(Qt::AlignLeft | Qt::AlignVCenter)
            : int(Qt::AlignRight | Qt::AlignVCenter);
    case Qt::ToolTipRole: return index.column() == Value ? row.note : QString();
    case Qt::AccessibleTextRole: return tr("%1: %2").arg(row.track->label, text(row, index.column()).toString());
    case widgets::signalRole: return trend::key(row.signal);
    default: return {};
    }
}

QVariant TrackModel::text(const Row &row, int column) const
{
    switch (column) {
    case Letter: return row.letter;
    case Label: return row.track->label;
    case Value: return row.value;
    case Unit: return trend::toString(row.track->unit);
    case Lowest: return row.lowest;
    case Highest: return row.highest;
    default: return {};
    }
}

QVariant TrackModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal || role != Qt::DisplayRole)
        return {};
    switch (section) {
    case Letter: return tr("Plot");
    case Label: return tr("Signal");
    case Value: return tr("Value");
    case Unit: return tr("Unit");
    case Lowest: return tr("Min in view");
    case Highest: return tr("Max in view");
    default: return {};
    }
}

Qt::ItemFlags TrackModel::flags(const QModelIndex &index) const
{
    const auto flags = QAbstractTableModel::flags(index);
    return index.column() == Letter ? flags | Qt::ItemIsUserCheckable : flags;
}

bool TrackModel::setData(const QModelIndex &index, const QVariant &value, int role)
{
    if (role != Qt::CheckStateRole || index.column() != Letter)
        return false;
    const bool isShown = value.toInt() == Qt::Checked;
    if (isShown && shownCount() >= widgets::Plot::mostTracks)
        return false;
    m_rows[index.row()].isShown = isShown;
    assignLetters();
    return true;
}

} // namespace models
