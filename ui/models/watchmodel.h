// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "robot/namebook.h"
#include "robot/signalwatch.h"
#include <QAbstractTableModel>

namespace models {

/// The watched signals, with the edges that were counted.
class WatchModel : public QAbstractTableModel
{
    Q_OBJECT

public:
    enum Column { Address, Inform, Name, Value, Rises, Falls, Changed, columns };

    /// All of them must outlive the model.
    WatchModel(const robot::RobotState &state, robot::SignalWatch &watch, const robot::NameBook &book,
        const protocol::Dialect &dialect, QObject *parent = nullptr);

    [[nodiscard]] int rowCount(const QModelIndex &parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex &parent = {}) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
    [[nodiscard]] QVariant data(const QModelIndex &index, int role) const override;

private:
    void onListChanged();
    [[nodiscard]] QString text(const QModelIndex &index) const;

    const robot::RobotState &m_state;
    const robot::SignalWatch &m_watch;
    const robot::NameBook &m_book;
    protocol::Dialect m_dialect;
    QList<names::Signal> m_signals; ///< As the views know them.
};

} // namespace models
