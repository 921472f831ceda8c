// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "ui/models/fleetmodel.h"
#include "ui/pages/page.h"

class QLabel;
class QLineEdit;
class QListView;
class QSortFilterProxyModel;
class QStackedWidget;

namespace widgets {
class HoldButton;
class Segments;
class Table;
} // namespace widgets

namespace pages {

class TileDelegate;

/// All controllers side by side, as a board of tiles or as a table. No order goes to several of them but HOLD.
class FleetPage : public Page
{
    Q_OBJECT

public:
    explicit FleetPage(const Context &context, QWidget *parent = nullptr);

    [[nodiscard]] QList<robot::TopicRange> topics() const override { return {}; }

protected:
    /// The other controllers are there whatever this one does.
    [[nodiscard]] bool needsLink() const override { return false; }

private:
    [[nodiscard]] QWidget *head();
    [[nodiscard]] QWidget *tools();
    void makeBoard();
    void makeTable();
    void open(const QModelIndex &index);
    void connectAll();
    void backUpAll();
    void setSize(int size);
    void showCounts();
    void showHold();

    const Context m_context;
    models::FleetModel *m_model;
    QSortFilterProxyModel *m_sorted;
    QListView *m_board;
    TileDelegate *m_tiles;
    widgets::Table *m_table;
    QStackedWidget *m_views;
    widgets::Segments *m_view;
    widgets::Segments *m_size;
    QLineEdit *m_filter;
    widgets::HoldButton *m_hold;
    QLabel *m_counts;
    QLabel *m_held; ///< What came of HOLD ALL.
};

} // namespace pages
