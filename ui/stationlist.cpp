// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/stationlist.h"

#include "ui/widgets/controllertile.h"
#include <QPushButton>
#include <QVBoxLayout>

namespace ui {

using models::FleetRow;
using widgets::ControllerTile;

StationList::StationList(const station::Fleet &fleet, const settings::Profile &shown, QWidget *parent)
    : QWidget(parent),
      m_model {new models::FleetModel(fleet, this)},
      m_shown {shown},
      m_column {new QVBoxLayout(this)},
      m_more {new QPushButton}
{
    m_column->setContentsMargins(0, 0, 0, 0);
    m_column->setSpacing(2);
    m_more->setObjectName(QStringLiteral("moreStations"));
    m_more->setProperty("link", true);
    m_column->addWidget(m_more, 0, Qt::AlignLeft);
    connect(m_more, &QPushButton::clicked, this, &StationList::moreWanted);
    for (const auto signal : {&QAbstractItemModel::rowsInserted, &QAbstractItemModel::rowsRemoved})
        connect(m_model, signal, this, &StationList::update);
    connect(m_model, &QAbstractItemModel::dataChanged, this, &StationList::update);
    update();
}

void StationList::showBackup(const widgets::Word &age)
{
    m_backup = age;
    update();
}

/// The one that is shown is never left out; without any there is a tile that says so.
QList<int> StationList::order() const
{
    QList<int> rows;
    for (int row = 0; row < m_model->rowCount(); ++row)
        rows << row;
    std::ranges::stable_sort(rows, {}, [this](int row) { return int(m_model->row(row).trouble); });
    const auto shown = std::ranges::find(rows, m_shown.name, [this](int row) { return m_model->row(row).name; });
    if (shown != rows.end() && shown - rows.begin() >= mostTiles)
        rows.swapItemsAt(shown - rows.begin(), mostTiles - 1);
    return rows.mid(0, mostTiles);
}

bool StationList::isInUse() const
{
    return underMouse() || std::ranges::any_of(m_tiles, [](const QWidget *tile) { return tile->hasFocus(); });
}

void StationList::update()
{
    QList<QString> names;
    for (const int row : order())
        names << m_model->row(row).name;
    if (names.isEmpty() || (m_shown.name.isEmpty() && !names.contains(QString())))
        names.prepend(QString()); // no controller
    QList<QString> sortedNew = names;
    QList<QString> sortedOld = m_names;
    std::ranges::sort(sortedNew);
    std::ranges::sort(sortedOld);
    if (sortedNew != sortedOld || !isInUse())
        m_names = names;
    while (m_tiles.size() > m_names.size())
        m_tiles.takeLast()->deleteLater();
    while (m_tiles.size() < m_names.size()) {
        auto *tile = new ControllerTile(this);
        m_column->insertWidget(int(m_tiles.size()), tile);
        m_tiles << tile;
        connect(tile, &QAbstractButton::clicked, this, [this, tile] { Q_EMIT chosen(tile->id()); });
    }
    for (int place = 0; place < m_tiles.size(); ++place) {
        const auto &rows = m_model->rows();
        const auto row = std::ranges::find(rows, m_names[place], &FleetRow::name);
        show(m_tiles[place], row == rows.end() ? FleetRow {} : *row);
    }
    const int more = int(m_model->rowCount() - m_names.size());
    m_more->setText(tr("%n more in Fleet", nullptr, more));
    m_more->setVisible(more > 0);
}

void StationList::show(ControllerTile *tile, const FleetRow &row)
{
    const bool isShown = row.name == m_shown.name;
    tile->setObjectName(isShown ? QStringLiteral("controllerTile") : QStringLiteral("stationTile") + row.name);
    tile->showStation(row.id, row.name.isEmpty() ? tr("No controller") : row.name, row.tag);
    tile->show(row.name.isEmpty() ? widgets::Word {tr("not connected")} : row.summary);
    tile->showAlarms(row.alarms);
    tile->setChecked(isShown);
    tile->showBackup(isShown ? m_backup : widgets::Word {});
}

} // namespace ui
