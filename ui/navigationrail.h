// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "ui/actioncatalog.h"
#include <QWidget>

class QButtonGroup;
class QMenu;
class QVBoxLayout;

namespace widgets {
struct Word;
} // namespace widgets

namespace settings {
struct Profile;
}

namespace station {
class Fleet;
}

namespace ui {

class StationList;

/// At the left: the controllers, the pages, and the orders about the connection.
class NavigationRail : public QWidget
{
    Q_OBJECT

public:
    /// Beside the pages of `shown`. `fleet` must outlive the rail.
    NavigationRail(
        const station::Fleet &fleet, const settings::Profile &shown, const Actions &actions, QWidget *parent = nullptr);

    /// The age of the last backup, on the tile of the controller that is shown.
    void showBackup(const widgets::Word &age);
    /// Marks the page that is in view, by its row of the page catalogue.
    void showPage(int row);

Q_SIGNALS:
    /// The person chose a row of the page catalogue.
    void pageChosen(int row);

protected:
    void focusInEvent(QFocusEvent *event) override;
    void paintEvent(QPaintEvent *event) override;

private:
    void addScroll(QWidget *entries);
    void addPages(QVBoxLayout *column);
    void addActions(QVBoxLayout *column, const Actions &actions);

    StationList *m_stations;
    QButtonGroup *m_pages;
};

} // namespace ui
