// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "ui/models/fleetmodel.h"
#include <QWidget>

class QPushButton;
class QVBoxLayout;

namespace widgets {
class ControllerTile;
}

namespace ui {

/// The controllers in the rail, a tile each: troubled ones first, then in the order of their names. Their order stays
/// as it is while the mouse is over them or one has the focus.
class StationList : public QWidget
{
    Q_OBJECT

public:
    static constexpr int mostTiles = 6; ///< The others are on the fleet page.

    /// `shown` is the controller whose pages stand beside the list; it always has a tile. The fleet must outlive it.
    StationList(const station::Fleet &fleet, const settings::Profile &shown, QWidget *parent = nullptr);

    /// The age of the last backup of the controller that is shown.
    void showBackup(const widgets::Word &age);

Q_SIGNALS:
    /// The person chose a controller.
    void chosen(const QUuid &id);
    /// The person wants to see those without a tile.
    void moreWanted();

private:
    void update();
    [[nodiscard]] QList<int> order() const;
    [[nodiscard]] bool isInUse() const;
    void show(widgets::ControllerTile *tile, const models::FleetRow &row);

    models::FleetModel *m_model;
    settings::Profile m_shown;
    QVBoxLayout *m_column;
    QList<widgets::ControllerTile *> m_tiles;
    QList<QString> m_names; ///< Of the tiles, in their order.
    QPushButton *m_more;
    widgets::Word m_backup;
};

} // namespace ui
