// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "robot/alarmlog.h"
#include <QAbstractTableModel>

namespace models {

/// The active alarms of one controller, and those that cleared unacknowledged. Rows move and change in place.
class ActiveAlarmModel : public QAbstractTableModel
{
    Q_OBJECT

public:
    enum Column { State, Code, Data, Text, Time, FirstSeen, Count, columns };

    /// All of them must outlive the model.
    ActiveAlarmModel(const robot::AlarmLog &log, const robot::RobotState &state, const protocol::TextCodec &codec,
        QObject *parent = nullptr);

    [[nodiscard]] const journal::ActiveAlarms::Entry &at(int row) const { return m_entries[row]; }

    [[nodiscard]] int rowCount(const QModelIndex &parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex &parent = {}) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
    [[nodiscard]] QVariant data(const QModelIndex &index, int role) const override;

private:
    using Entry = journal::ActiveAlarms::Entry;

    void update();
    void onStateChanged(const robot::TopicRange &range);
    [[nodiscard]] bool isStale(const Entry &entry) const;
    [[nodiscard]] QString text(const Entry &entry, int column) const;
    [[nodiscard]] QString toolTip(const Entry &entry, int column) const;

    const robot::AlarmLog &m_log;
    const robot::RobotState &m_state;
    protocol::TextCodec m_codec;
    QList<Entry> m_entries;
    bool m_areSlotsLive = false;
};

} // namespace models
