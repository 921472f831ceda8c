// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "station/fleet.h"
#include "ui/messages.h"
#include <QPointer>
#include <QTimer>
#include <QWidget>
#include <memory>

class QStackedWidget;

namespace widgets {
class MessageBar;
class NoticeStack;
} // namespace widgets

namespace pages {
class Page;
}

namespace ui {

class NavigationRail;
class PageWindow;
class RobotStrip;

/// Shows one controller: its strip, rail, pages, and notices over the lower edge of the window. A page is made when it
/// is first opened. Another controller gets a new view, and so does another language.
class ControllerView : public QWidget
{
    Q_OBJECT

public:
    /// `fleet` and `actions` must outlive the view.
    ControllerView(std::shared_ptr<station::Station> station, station::Fleet &fleet, const Actions &actions,
        QWidget *parent = nullptr);
    ~ControllerView() override;

    [[nodiscard]] const std::shared_ptr<station::Station> &station() { return m_station; }
    [[nodiscard]] robot::Controller &controller() { return m_station->controller; }
    [[nodiscard]] trend::Recorder &recorder() { return m_station->recorder; }
    [[nodiscard]] robot::Orders &orders() { return m_station->orders; }
    [[nodiscard]] robot::AlarmLog &alarms() { return m_station->alarms; }
    [[nodiscard]] robot::NameBook &names() { return m_station->names; }
    /// The page of this row of the catalogue.
    [[nodiscard]] pages::Page *page(int row);
    /// The row of the page in view in this window.
    [[nodiscard]] int openRow() const;
    /// Brings the page in view, in its own window if it has one.
    void openPage(int row);
    /// Row of the page that was opened last.
    [[nodiscard]] int pageInView() const { return m_pageInView; }
    /// Gives the page a window of its own, beside this one; closing it brings the page back. Pages are told by the
    /// catalogue's ids.
    void openInWindow(const QString &id);
    /// Does so for the page in view.
    void openInWindow();
    /// The pages that have windows.
    [[nodiscard]] QStringList pagesInWindows() const;
    /// What this controller allows now.
    void showReadiness();
    /// Orders HOLD at once, or says why it cannot be ordered.
    void hold();
    /// Orders HLOCK off and calls `then` when that is done, or says why it cannot be done.
    void releaseLock(const std::function<void()> &then);
    /// Shows a message until the link has something new to say.
    void show(const Notice &notice);
    using QWidget::show;

Q_SIGNALS:
    /// The person opened or closed a window.
    void pagesInWindowsChanged();
    void pageOpened(int row);

protected:
    bool event(QEvent *event) override;
    void focusInEvent(QFocusEvent *event) override;

private:
    [[nodiscard]] RobotStrip *makeStrip();
    [[nodiscard]] PageWindow *windowOf(const pages::Page *page) const;
    void takeBack(PageWindow *window);
    [[nodiscard]] QWidget *makeBoard();
    [[nodiscard]] pages::Page *makePage(int row);
    [[nodiscard]] QList<pages::Page *> madePages() const;
    bool openAnother(int row);
    void follow();
    void readFor(const pages::Page *page);
    void onLinkChanged();
    void onHoldStateChanged();
    void onStatisticsChanged();
    void showLink();
    void showLock();
    void followJournal();

    std::shared_ptr<station::Station> m_station;
    station::Fleet &m_fleet;
    const Actions &m_actions;
    NavigationRail *m_rail;
    QPointer<widgets::NoticeStack> m_notices; ///< A child of the window.
    widgets::MessageBar *m_notice;
    widgets::MessageBar *m_lockNotice; ///< While HLOCK is on.
    widgets::MessageBar *m_journalNotice; ///< While the journal fails.
    QStackedWidget *m_stack;
    int m_pageInView = 0;
    QList<pages::Page *> m_pages; ///< In the order of the page catalogue; nullptr until it is opened.
    robot::Poller::Interest m_stripInterest;
    QHash<const pages::Page *, robot::Poller::Interest> m_pageInterests; ///< Of the pages in view.
    std::optional<ActionId> m_noticeAction;
    Notice m_linkNotice; ///< What the link and HOLD had to say last.
    QTimer m_fade; ///< Takes away what need not be read twice.
};

} // namespace ui
