// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "robot/namebook.h"
#include "robot/robotstate.h"
#include <QAbstractTableModel>
#include <QTimer>
#include <array>

namespace models {

/// One signal as it is painted.
struct Lamp {
    robot::Freshness freshness = robot::Freshness::Unknown;
    bool isOn = false; ///< Only with a live or a stale value.
    bool isRecent = false; ///< Changed within the last two seconds.
    QString address; ///< "IN#(1)" where the pendant has one, else "#27010".
    names::Name name;
};

/// The signals of one area, a group of eight a row. Rows change in place.
class IoModel : public QAbstractTableModel
{
    Q_OBJECT

public:
    /// `state` and `book` must outlive the model.
    IoModel(const robot::RobotState &state, robot::NameBook &book, const protocol::Dialect &dialect,
        protocol::InstanceRange groups, QObject *parent = nullptr);

    [[nodiscard]] names::Signal signalAt(const QModelIndex &index) const;
    /// Invalid outside the area.
    [[nodiscard]] QModelIndex indexOf(const names::Signal &signal) const;
    [[nodiscard]] Lamp lamp(const QModelIndex &index) const;
    /// The groups of rows first..last, as the poller wants them.
    [[nodiscard]] robot::TopicRange groups(int firstRow, int lastRow) const;
    /// Rows that the controller refuses, among those that were asked for, and why the first of them is.
    [[nodiscard]] QList<int> refusedRows() const;

    [[nodiscard]] int rowCount(const QModelIndex &parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex &parent = {}) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
    [[nodiscard]] QVariant data(const QModelIndex &index, int role) const override;
    [[nodiscard]] Qt::ItemFlags flags(const QModelIndex &index) const override;
    /// Gives a signal a local name.
    bool setData(const QModelIndex &index, const QVariant &value, int role) override;

    /// Looks at the clock: what changed longer ago is no longer outlined. Called by itself.
    void tick(robot::Time now);

Q_SIGNALS:
    void refusedRowsChanged();

private:
    struct Group {
        std::optional<quint8> bits;
        robot::Freshness freshness = robot::Freshness::Unknown;
        quint8 recent = 0; ///< By bit.
        std::array<robot::Time, names::signalsPerGroup> changed {};
    };

    void onChanged(const robot::TopicRange &range);
    [[nodiscard]] bool look(int row, robot::Time now);
    [[nodiscard]] QString words(const QModelIndex &index) const;

    const robot::RobotState &m_state;
    robot::NameBook &m_book;
    protocol::Dialect m_dialect;
    protocol::InstanceRange m_range;
    std::vector<Group> m_groups;
    QTimer m_fade;
};

} // namespace models
