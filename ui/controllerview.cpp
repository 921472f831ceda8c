// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/controllerview.h"

#include "ui/accessswitch.h"
#include "ui/announcer.h"
#include "ui/armbadge.h"
#include "ui/backupage.h"
#include "ui/conditionwords.h"
#include "ui/navigationrail.h"
#include "ui/pagecatalog.h"
#include "ui/pagewindow.h"
#include "ui/robotstrip.h"
#include <QHBoxLayout>
#include <QStackedWidget>

namespace ui {

using namespace std::chrono_literals;
using robot::HoldProgress;
using robot::LinkState;

namespace {

/// What the strip shows, and the alarms, which are kept whatever page is in view.
QList<robot::TopicRange> alwaysRead()
{
    return {robot::topics::status, robot::topics::masterJob, robot::topics::systemInformation,
        {robot::Kind::Alarm, 1, values::activeAlarmCount}};
}

} // namespace

ControllerView::ControllerView(const settings::Profile &profile, settings::ProfileStore &store, Authority authority,
    const Actions &actions, QWidget *parent)
    : QWidget(parent),
      m_controller {profile},
      m_orders {m_controller, authority.access, authority.arming},
      m_names {profile, store.notes(profile.name)},
      m_numbering {m_orders},
      m_authority {authority},
      m_recorder {m_controller, trend::Archive::folderOf(profile.name)},
      m_alarms {m_orders, authority.journal},
      m_rail {new NavigationRail(m_controller.state(), m_controller.profile(), actions)},
      m_bar {new widgets::MessageBar},
      m_lockBar {new widgets::MessageBar},
      m_journalBar {new widgets::MessageBar},
      m_stack {new QStackedWidget},
      m_stripInterest {m_controller.poller().want(alwaysRead())}
{
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(makeStrip());
    column->addWidget(desk(), 1);
    m_bar->setObjectName(QStringLiteral("messageBar"));
    m_lockBar->setObjectName(QStringLiteral("lockBar"));
    m_journalBar->setObjectName(QStringLiteral("journalBar"));
    m_fade.setSingleShot(true);
    m_fade.setInterval(20s);
    m_names.follow(m_controller);
    addPages(store, actions);
    const auto *backup = new BackupAge(profile.name, store.notes(profile.name), this);
    connect(backup, &BackupAge::told, m_rail, &NavigationRail::showBackup);
    connect(m_bar, &widgets::MessageBar::linkActivated, this, [this, &actions] {
        if (m_barAction)
            actions.action(*m_barAction)->trigger();
    });
    follow();
    followJournal();
    new Announcer(m_alarms, protocol::TextCodec {profile.encoding}, this);
    openPage(0);
    onLinkChanged();
}

RobotStrip *ControllerView::makeStrip()
{
    auto *strip = new RobotStrip(m_controller.state(), m_controller.profile());
    strip->addBadge(new ArmBadge(m_orders));
    strip->addBadge(new AccessSwitch(m_authority.access));
    connect(strip, &RobotStrip::holdRequested, this, &ControllerView::hold);
    return strip;
}

QWidget *ControllerView::desk()
{
    auto *content = new QVBoxLayout;
    content->setSpacing(0);
    m_bar->setContentsMargins(space::page, space::page, space::page, 0);
    m_lockBar->setContentsMargins(space::page, space::page, space::page, 0);
    m_journalBar->setContentsMargins(space::page, space::page, space::page, 0);
    content->addWidget(m_lockBar);
    content->addWidget(m_journalBar);
    content->addWidget(m_bar);
    content->addWidget(m_stack, 1);
    auto *result = new QWidget;
    auto *row = new QHBoxLayout(result);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(0);
    row->addWidget(m_rail);
    row->addLayout(content, 1);
    return result;
}

void ControllerView::addPages(settings::ProfileStore &store, const Actions &actions)
{
    const pages::Context context {m_controller, m_orders, m_alarms, m_authority.journal, m_controller.state(),
        m_controller.profile(), store, m_names, m_numbering, actions, m_recorder};
    for (const PageRow &row : pageCatalog()) {
        pages::Page *page = row.create(context, m_stack);
        page->setObjectName(QLatin1String(row.id) + QStringLiteral("Page"));
        m_stack->addWidget(page);
        for (const auto signal : {&pages::Page::topicsChanged, &pages::Page::visibilityChanged})
            connect(page, signal, this, [this, page] { readFor(page); });
        m_pages << page;
    }
}

void ControllerView::follow()
{
    using robot::Controller;
    connect(m_rail, &NavigationRail::pageChosen, this, &ControllerView::openPage);
    connect(&m_controller, &Controller::linkStateChanged, this, &ControllerView::onLinkChanged);
    connect(&m_controller, &Controller::troubleChanged, this, &ControllerView::onLinkChanged);
    connect(&m_controller, &Controller::holdProgressChanged, this, &ControllerView::onHoldProgressChanged);
    connect(&m_controller, &Controller::statisticsChanged, this, &ControllerView::onStatisticsChanged);
    connect(&m_orders, &robot::Orders::pendantLockChanged, this, &ControllerView::showLock);
    connect(m_lockBar, &widgets::MessageBar::linkActivated, this, &ControllerView::releaseLock);
    connect(&m_fade, &QTimer::timeout, this, [this] { show(Notice {}); });
}

/// The pages look at the orders, which look at the controller: the children go first.
ControllerView::~ControllerView() { qDeleteAll(findChildren<QWidget *>(QString(), Qt::FindDirectChildrenOnly)); }

void ControllerView::openPage(int row)
{
    if (PageWindow *window = windowOf(m_pages[row])) {
        window->raise();
        window->activateWindow();
    } else {
        m_stack->setCurrentWidget(m_pages[row]);
    }
    m_rail->showPage(row);
}

PageWindow *ControllerView::windowOf(const pages::Page *page) const
{
    for (PageWindow *window : findChildren<PageWindow *>(QString(), Qt::FindDirectChildrenOnly)) {
        if (window->page() == page)
            return window;
    }
    return nullptr;
}

void ControllerView::openInWindow()
{
    if (const auto row = m_pages.indexOf(m_stack->currentWidget()); row >= 0)
        openInWindow(QLatin1String(pageCatalog()[row].id));
}

void ControllerView::openInWindow(const QString &id)
{
    const auto catalog = pageCatalog();
    const auto found = std::ranges::find_if(catalog, [&](const PageRow &row) { return id == QLatin1String(row.id); });
    if (found == catalog.end() || m_stack->count() < 2) // the main window keeps one
        return;
    pages::Page *page = m_pages[found - catalog.begin()];
    if (windowOf(page))
        return openPage(int(found - catalog.begin()));
    m_stack->removeWidget(page);
    auto *window =
        new PageWindow(makeStrip(), page, tr("%1 — %2").arg(title(*found), m_controller.profile().name), this);
    connect(window, &PageWindow::closed, this, &ControllerView::takeBack);
    showLink();
    window->show();
    Q_EMIT pagesInWindowsChanged();
}

void ControllerView::takeBack(PageWindow *window)
{
    m_stack->addWidget(window->page());
    window->setParent(nullptr); // no window of ours any more
    window->deleteLater();
    Q_EMIT pagesInWindowsChanged();
}

QStringList ControllerView::pagesInWindows() const
{
    QStringList ids;
    for (qsizetype row = 0; row < m_pages.size(); ++row) {
        if (windowOf(m_pages[row]))
            ids << QLatin1String(pageCatalog()[row].id);
    }
    return ids;
}

/// What is read for a page: its topics while it is in view, else nothing.
void ControllerView::readFor(const pages::Page *page)
{
    if (page->isVisible())
        m_pageInterests[page] = m_controller.poller().want(page->topics());
    else
        m_pageInterests.remove(page);
}

/// Nobody holds a robot with a stray Space. It is no focus proxy: Tab would come back here before it got to HOLD.
void ControllerView::focusInEvent(QFocusEvent *event) { m_rail->setFocus(event->reason()); }

void ControllerView::hold()
{
    if (m_controller.linkState() == LinkState::Disconnected)
        show(holdWithoutLink());
    else
        m_controller.hold();
}

void ControllerView::show(const Notice &notice)
{
    m_barAction = notice.action;
    m_bar->show(notice.message);
    const bool isPassing = notice.message.severity == widgets::Severity::Notice
        && m_controller.linkState() == LinkState::Monitoring && m_controller.holdProgress() != HoldProgress::Sent;
    if (isPassing && !notice.message.text.isEmpty())
        m_fade.start();
    else
        m_fade.stop();
}

void ControllerView::onLinkChanged()
{
    showLink();
    show(noticeOf(linkView(m_controller), m_controller.profile()));
}

void ControllerView::onHoldProgressChanged()
{
    onLinkChanged();
    if (m_controller.holdProgress() == HoldProgress::Confirmed && m_controller.linkState() == LinkState::Monitoring)
        show(holdConfirmed());
}

void ControllerView::onStatisticsChanged()
{
    const auto statistics = m_controller.statistics();
    for (RobotStrip *strip : findChildren<RobotStrip *>())
        strip->showStatistics(statistics);
    for (pages::Page *page : m_pages)
        page->showStatistics(statistics);
}

void ControllerView::showLock()
{
    const QString text = tr("HLOCK is on at %1: the pendant is locked out, but for its emergency stop.");
    const widgets::Message locked {
        widgets::Severity::Warning, text.arg(m_controller.profile().name), tr("Release HLOCK")};
    m_lockBar->show(m_orders.isPendantLocked() ? locked : widgets::Message {});
}

/// Everything that is ordered is written down; while that fails work goes on and every page says so.
void ControllerView::followJournal()
{
    using journal::Store;
    using widgets::Severity;
    Store &journal = m_authority.journal;
    const auto fail = [this](const QString &reason) { m_journalBar->show({Severity::Warning, reason, {}}); };
    connect(&m_orders, &robot::Orders::recorded, &journal, &Store::append);
    connect(&journal, &Store::failed, this, fail);
    connect(&journal, &Store::recovered, this, [this](qint64 dropped) {
        const QString lost = tr("The journal works again. %n record(s) were lost.", nullptr, int(dropped));
        m_journalBar->show(dropped > 0 ? widgets::Message {Severity::Warning, lost, tr("Close")} : widgets::Message {});
    });
    connect(&journal, &Store::setAside, this, [this](const QString &path) {
        const QString text = tr("The journal was damaged. It was kept as %1, and a new one was begun.");
        m_journalBar->show({Severity::Warning, text.arg(path), tr("Close")});
    });
    connect(m_journalBar, &widgets::MessageBar::linkActivated, this, [this] { m_journalBar->show({}); });
    if (!journal.trouble().isEmpty())
        fail(journal.trouble());
}

void ControllerView::releaseLock()
{
    m_orders.send(protocol::HlockOff {}, {robot::Act::HlockOff}, this, [this](const values::Result<void> &result) {
        if (!result) {
            const auto text = explain(robot::Act::HlockOff, result.error(), m_controller.profile().model);
            show({{widgets::Severity::Warning, text, {}}, {}});
        }
    });
}

void ControllerView::showLink()
{
    const LinkView link = linkView(m_controller);
    for (RobotStrip *strip : findChildren<RobotStrip *>())
        strip->showLink(link);
    m_rail->showLink(link);
    for (pages::Page *page : m_pages)
        page->showLink(link);
}

} // namespace ui
