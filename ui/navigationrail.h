// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "ui/actioncatalog.h"
#include "ui/linkview.h"
#include <QWidget>

class QButtonGroup;
class QMenu;
class QVBoxLayout;

namespace widgets {
class ControllerTile;
struct Word;
} // namespace widgets

namespace ui {

/// At the left: the controller, the pages, and the orders about the connection.
class NavigationRail : public QWidget
{
    Q_OBJECT

public:
    NavigationRail(const robot::RobotState &state, const settings::Profile &profile, const Actions &actions,
        QWidget *parent = nullptr);

    void showLink(const LinkView &link);
    /// The age of the last backup, on the controller's tile.
    void showBackup(const widgets::Word &age);
    /// Marks the page that is in view, by its row of the page catalogue.
    void showPage(int row);

Q_SIGNALS:
    /// The person chose a row of the page catalogue.
    void pageChosen(int row);

protected:
    void paintEvent(QPaintEvent *event) override;

private:
    void addScroll(QWidget *entries);
    void addPages(QVBoxLayout *column);
    void addActions(QVBoxLayout *column, const Actions &actions);
    void showTile();

    const robot::RobotState &m_state;
    LinkView m_link;
    widgets::ControllerTile *m_tile;
    QButtonGroup *m_pages;
};

} // namespace ui
