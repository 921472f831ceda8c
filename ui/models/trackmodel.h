// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "trend/track.h"
#include <QAbstractTableModel>
#include <QFont>

namespace models {

/// The tracks that may be plotted, a row each: shown or not and its letter, label, value, unit, lowest and highest in
/// view. Rows come and go in place; the rest is told with refresh().
class TrackModel : public QAbstractTableModel
{
    Q_OBJECT

public:
    enum Column { Letter, Label, Value, Unit, Lowest, Highest };

    using QAbstractTableModel::QAbstractTableModel;

    /// Tracks that are in both lists keep their rows. The pointers must stay until they are replaced. The first ones
    /// are shown, as many as a plot takes, unless the person chose others.
    void setTracks(const std::vector<const trend::Track *> &tracks);
    /// The values at `cursor`, or the last ones without one; the bounds of what lies in `range`.
    void refresh(const trend::Range &range, std::optional<trend::Moment> cursor);
    /// The tracks that are shown, in the order of their letters.
    [[nodiscard]] std::vector<const trend::Track *> shown() const;
    [[nodiscard]] trend::Signal signalOf(int row) const { return m_rows[row].signal; }

    [[nodiscard]] int rowCount(const QModelIndex &parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex &parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex &index, int role) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
    [[nodiscard]] Qt::ItemFlags flags(const QModelIndex &index) const override;
    bool setData(const QModelIndex &index, const QVariant &value, int role) override;

Q_SIGNALS:
    /// Another choice of tracks is shown.
    void shownChanged();

private:
    struct Row {
        trend::Signal signal;
        const trend::Track *track = nullptr;
        bool isShown = false;
        QString letter; ///< Empty while it is not shown.
        QString value;
        QString note; ///< Why there is no value.
        QString lowest;
        QString highest;
    };

    [[nodiscard]] int shownCount() const;
    void assignLetters();
    void refreshRow(Row &row, const trend::Range &range, std::optional<trend::Moment> cursor) const;
    [[nodiscard]] QVariant text(const Row &row, int column) const;

    QList<Row> m_rows;
};

} // namespace models
