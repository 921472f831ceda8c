// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "robot/alarmlog.h"
#include "robot/namebook.h"
#include "robot/numbering.h"
#include "robot/orders.h"
#include "settings/profilestore.h"
#include "trend/recorder.h"
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

/// What the whole program shares: who may do what, and where it is written down.
struct Authority {
    robot::Access &access;
    robot::Arming &arming;
    journal::Store &journal;
};

class NavigationRail;
class PageWindow;
class RobotStrip;

/// One controller, and its strip, rail, message bar and pages. Another controller gets a new view.
class ControllerView : public QWidget
{
    Q_OBJECT

public:
    /// `store`, `authority` and `actions` must outlive the view.
    ControllerView(const settings::Profile &profile, settings::ProfileStore &store, Authority authority,
        const Actions &actions, QWidget *parent = nullptr);
    ~ControllerView() override;

    [[nodiscard]] robot::Controller &controller() { return m_controller; }
    [[nodiscard]] trend::Recorder &recorder() { return m_recorder; }
    [[nodiscard]] robot::Orders &orders() { return m_orders; }
    [[nodiscard]] robot::AlarmLog &alarms() { return m_alarms; }
    [[nodiscard]] robot::NameBook &names() { return m_names; }
    [[nodiscard]] const QList<pages::Page *> &pages() const { return m_pages; }
    /// Brings the page in view, in its own window if it has one.
    void openPage(int row);
    /// Gives the page a window of its own, beside this one; closing it brings the page back. Pages are told by the
    /// catalogue's ids.
    void openInWindow(const QString &id);
    /// Does so for the page in view.
    void openInWindow();
    /// The pages that have windows.
    [[nodiscard]] QStringList pagesInWindows() const;
    /// Orders HOLD at once, or says why it cannot be ordered.
    void hold();
    /// Orders HLOCK off, or says why it cannot be ordered.
    void releaseLock();
    /// Shows a message until the link has something new to say.
    void show(const Notice &notice);
    using QWidget::show;

Q_SIGNALS:
    /// The person opened or closed a window.
    void pagesInWindowsChanged();

protected:
    void focusInEvent(QFocusEvent *event) override;

private:
    [[nodiscard]] RobotStrip *makeStrip();
    [[nodiscard]] PageWindow *windowOf(const pages::Page *page) const;
    void takeBack(PageWindow *window);
    [[nodiscard]] QWidget *desk();
    void addPages(settings::ProfileStore &store, const Actions &actions);
    void follow();
    void readFor(const pages::Page *page);
    void onLinkChanged();
    void onHoldProgressChanged();
    void onStatisticsChanged();
    void showLink();
    void showLock();
    void followJournal();

    robot::Controller m_controller;
    robot::Orders m_orders;
    robot::NameBook m_names;
    robot::NumberingGuard m_numbering;
    Authority m_authority;
    trend::Recorder m_recorder;
    robot::AlarmLog m_alarms;
    NavigationRail *m_rail;
    widgets::MessageBar *m_bar;
    widgets::MessageBar *m_lockBar; ///< On every page while HLOCK is on.
    widgets::MessageBar *m_journalBar; ///< On every page while the journal fails.
    QStackedWidget *m_stack;
    QList<pages::Page *> m_pages; ///< In the order of the page catalogue.
    robot::Poller::Interest m_stripInterest;
    QHash<const pages::Page *, robot::Poller::Interest> m_pageInterests; ///< Of the pages in view.
    std::optional<ActionId> m_barAction;
    QTimer m_fade; ///< Takes away what need not be read twice.
};

} // namespace ui
