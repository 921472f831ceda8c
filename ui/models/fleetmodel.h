// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "station/fleet.h"
#include "ui/widgets/shown.h"
#include <QAbstractTableModel>
#include <QTimer>

namespace models {

/// The most urgent first.
enum class Trouble { Alarm, NoLink, Held, None };

/// One controller as the fleet shows it, in the person's language.
struct FleetRow {
    QUuid id;
    QString name;
    int tag = 0;
    Trouble trouble = Trouble::None;
    widgets::Word state; ///< One big word: ALARM, NO LINK, HELD, RUNNING, TEACH, STOPPED, OFF.
    QDateTime since; ///< When it became so, as far as this program saw it; invalid if it was always so.
    widgets::Word summary; ///< "REMOTE PLAY · running"; one line for a small tile.
    QString mode;
    QString reason; ///< The alarm, why there is no link, or who holds; empty else.
    QString job;
    QString place; ///< Line and override.
    QString servo;
    QString link;
    int alarms = 0; ///< Active ones.
    bool isOpen = false;
    bool isStale = false; ///< What was read is old.
    bool isArmed = false;
    bool isSimulation = false;

    bool operator==(const FleetRow &) const = default;
};

/// How a station is shown now. `since` is left out.
[[nodiscard]] FleetRow fleetRow(const station::RosterEntry &entry);

/// Every controller of the fleet, one a row, in the fleet's own order. Rows change in place, twice a second at most.
class FleetModel : public QAbstractTableModel
{
    Q_OBJECT

public:
    enum Column { Name, State, Mode, Reason, Job, Place, Servo, Alarms, Link, columns };
    enum Role {
        RowRole = Qt::UserRole, ///< const FleetRow *, until the next change.
        TroubleRole, ///< int: sorts the troubled first.
    };

    /// `fleet` must outlive the model.
    explicit FleetModel(const station::Fleet &fleet, QObject *parent = nullptr);

    [[nodiscard]] const FleetRow &row(int row) const { return m_rows[row]; }
    [[nodiscard]] const QList<FleetRow> &rows() const { return m_rows; }
    /// Takes what is known now. It calls itself.
    void update();

    [[nodiscard]] int rowCount(const QModelIndex &parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex &parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex &index, int role) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    void fit(const QList<station::RosterEntry> &roster);
    [[nodiscard]] static QString text(const FleetRow &row, int column);

    const station::Fleet &m_fleet;
    QList<FleetRow> m_rows;
    QTimer m_timer;
};

} // namespace models
