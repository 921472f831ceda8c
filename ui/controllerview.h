// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "ui/messages.h"
#include <QTimer>
#include <QWidget>

class QStackedWidget;

namespace widgets {
class MessageBar;
}

namespace pages {
class Page;
}

namespace ui {

class NavigationRail;
class RobotStrip;

/// One controller, and its strip, rail, message bar and pages. Another controller gets a new view.
class ControllerView : public QWidget
{
    Q_OBJECT

public:
    /// `actions` must outlive the view.
    ControllerView(const settings::Profile &profile, const Actions &actions, QWidget *parent = nullptr);

    [[nodiscard]] robot::Controller &controller() { return m_controller; }
    [[nodiscard]] const QList<pages::Page *> &pages() const { return m_pages; }
    void openPage(int row);
    /// Orders HOLD at once, or says why it cannot be ordered.
    void hold();
    /// Shows a message until the link has something new to say.
    void show(const Notice &notice);
    using QWidget::show;

private:
    [[nodiscard]] QWidget *desk();
    void addPages(const Actions &actions);
    void follow();
    void readFor(const pages::Page *page);
    void onLinkChanged();
    void onHoldProgressChanged();
    void onStatisticsChanged();
    void showLink();

    robot::Controller m_controller;
    RobotStrip *m_strip;
    NavigationRail *m_rail;
    widgets::MessageBar *m_bar;
    QStackedWidget *m_stack;
    QList<pages::Page *> m_pages; ///< In the order of the page catalogue.
    robot::Poller::Interest m_stripInterest;
    QHash<const pages::Page *, robot::Poller::Interest> m_pageInterests; ///< Of the pages in view.
    std::optional<ActionId> m_barAction;
    QTimer m_fade; ///< Takes away what need not be read twice.
};

} // namespace ui
