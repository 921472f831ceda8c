// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/controllerview.h"

#include "ui/accessswitch.h"
#include "ui/announcer.h"
#include "ui/armbadge.h"
#include "ui/backupage.h"
#include "ui/conditionwords.h"
#include "ui/dialogs/readinesssheet.h"
#include "ui/firstcontact.h"
#include "ui/navigationrail.h"
#include "ui/pagecatalog.h"
#include "ui/pagewindow.h"
#include "ui/robotstrip.h"
#include "ui/widgets/noticestack.h"
#include <QHBoxLayout>
#include <QStackedWidget>

namespace ui {

using namespace std::chrono_literals;
using robot::LinkState;

namespace {

/// What the strip shows, and the alarms, which are kept whatever page is in view.
QList<robot::TopicRange> alwaysRead()
{
    return {robot::topics::status, robot::topics::masterJob, robot::topics::systemInformation,
        {robot::Kind::Alarm, 1, values::activeAlarmCount}};
}

} // namespace

ControllerView::ControllerView(
    std::shared_ptr<station::Station> station, station::Fleet &fleet, const Actions &actions, QWidget *parent)
    : QWidget(parent),
      m_station {std::move(station)},
      m_fleet {fleet},
      m_actions {actions},
      m_rail {new NavigationRail(fleet, m_station->profile(), actions)},
      m_notices {new widgets::NoticeStack(this)},
      m_notice {m_notices->add(QStringLiteral("linkNotice"))},
      m_lockNotice {m_notices->add(QStringLiteral("lockNotice"))},
      m_journalNotice {m_notices->add(QStringLiteral("journalNotice"))},
      m_stack {new QStackedWidget},
      m_pages(qsizetype(pageCatalog().size()), nullptr),
      m_stripInterest {controller().poller().want(alwaysRead())}
{
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(makeStrip());
    column->addWidget(makeBoard(), 1);
    m_notice->setClosable(true);
    m_journalNotice->setClosable(true);
    m_fade.setSingleShot(true);
    m_fade.setInterval(20s);
    const auto *backup = new BackupAge(m_station->profile().folderName(), m_station->notes(), this);
    connect(backup, &BackupAge::told, m_rail, &NavigationRail::showBackup);
    connect(m_notice, &widgets::MessageBar::linkActivated, this, [this] {
        if (m_noticeAction)
            m_actions.action(*m_noticeAction)->trigger();
    });
    const auto *contact = new FirstContact(controller(), m_station->shared.store, this);
    connect(contact, &FirstContact::readinessDue, this, &ControllerView::showReadiness);
    follow();
    followJournal();
    new Announcer(alarms(), protocol::TextCodec {m_station->profile().encoding}, this);
    openPage(0);
    onLinkChanged();
}

RobotStrip *ControllerView::makeStrip()
{
    auto *strip = new RobotStrip(controller().state(), m_station->profile());
    strip->addMark(new ArmBadge(orders()));
    strip->addBadge(new AccessSwitch(m_station->access));
    connect(strip, &RobotStrip::holdRequested, this, &ControllerView::hold);
    return strip;
}

QWidget *ControllerView::makeBoard()
{
    auto *result = new QWidget;
    auto *row = new QHBoxLayout(result);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(0);
    row->addWidget(m_rail);
    row->addWidget(m_stack, 1);
    return result;
}

pages::Page *ControllerView::page(int row)
{
    if (!m_pages[row])
        m_pages[row] = makePage(row);
    return m_pages[row];
}

pages::Page *ControllerView::makePage(int row)
{
    const pages::Context context {*m_station, m_fleet, m_station->shared.store, m_actions};
    const PageRow &entry = pageCatalog()[std::size_t(row)];
    pages::Page *page = entry.create(context, m_stack);
    page->setObjectName(QLatin1String(entry.id) + QStringLiteral("Page"));
    page->setName(title(entry));
    for (const auto signal : {&pages::Page::topicsChanged, &pages::Page::visibilityChanged})
        connect(page, signal, this, [this, page] { readFor(page); });
    page->showLink(linkView(controller()));
    page->showStatistics(controller().statistics());
    m_stack->addWidget(page);
    return page;
}

int ControllerView::openRow() const
{
    for (int row = 0; row < int(m_pages.size()); ++row) {
        if (m_pages[row] && m_pages[row] == m_stack->currentWidget())
            return row;
    }
    return 0;
}

QList<pages::Page *> ControllerView::madePages() const
{
    QList<pages::Page *> made = m_pages;
    made.removeAll(nullptr);
    return made;
}

void ControllerView::follow()
{
    using robot::Controller;
    connect(m_rail, &NavigationRail::pageChosen, this, &ControllerView::openPage);
    connect(&controller(), &Controller::linkStateChanged, this, &ControllerView::onLinkChanged);
    connect(&controller(), &Controller::troubleChanged, this, &ControllerView::onLinkChanged);
    connect(&controller(), &Controller::holdStateChanged, this, &ControllerView::onHoldStateChanged);
    connect(&controller(), &Controller::statisticsChanged, this, &ControllerView::onStatisticsChanged);
    connect(&orders(), &robot::Orders::pendantLockChanged, this, &ControllerView::showLock);
    connect(m_lockNotice, &widgets::MessageBar::linkActivated, this, [this] { releaseLock([] {}); });
    connect(&m_fade, &QTimer::timeout, this, [this] { show(Notice {}); });
}

/// The widgets look at the station: they go first.
ControllerView::~ControllerView()
{
    delete m_notices;
    qDeleteAll(findChildren<QWidget *>(QString(), Qt::FindDirectChildrenOnly));
}

bool ControllerView::event(QEvent *event)
{
    if (event->type() == QEvent::ParentChange || event->type() == QEvent::Show)
        m_notices->layOver(window());
    return QWidget::event(event);
}

void ControllerView::openPage(int row)
{
    if (PageWindow *window = windowOf(page(row))) {
        window->raise();
        window->activateWindow();
    } else {
        m_stack->setCurrentWidget(page(row));
    }
    m_rail->showPage(row);
    m_pageInView = row;
    Q_EMIT pageOpened(row);
}

PageWindow *ControllerView::windowOf(const pages::Page *page) const
{
    for (PageWindow *window : findChildren<PageWindow *>(QString(), Qt::FindDirectChildrenOnly)) {
        if (window->page() == page)
            return window;
    }
    return nullptr;
}

void ControllerView::openInWindow() { openInWindow(QLatin1String(pageCatalog()[std::size_t(openRow())].id)); }

void ControllerView::openInWindow(const QString &id)
{
    const auto catalog = pageCatalog();
    const auto found = std::ranges::find_if(catalog, [&](const PageRow &row) { return id == QLatin1String(row.id); });
    if (found == catalog.end())
        return;
    const int row = int(found - catalog.begin());
    if (windowOf(page(row)))
        return openPage(row);
    if (m_stack->currentWidget() == page(row) && !openAnother(row)) // the main window keeps one
        return;
    m_stack->removeWidget(page(row));
    auto *window =
        new PageWindow(makeStrip(), page(row), tr("%1 — %2").arg(title(*found), m_station->profile().name), this);
    connect(window, &PageWindow::closed, this, &ControllerView::takeBack);
    showLink();
    window->show();
    Q_EMIT pagesInWindowsChanged();
}

/// Shows the next page that has no window of its own; false if there is none.
bool ControllerView::openAnother(int row)
{
    const int count = int(m_pages.size());
    for (int step = 1; step < count; ++step) {
        const int other = (row + step) % count;
        if (!windowOf(page(other)))
            return openPage(other), true;
    }
    return false;
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
        m_pageInterests[page] = controller().poller().want(page->topics());
    else
        m_pageInterests.remove(page);
}

/// Nobody holds a robot with a stray Space. It is no focus proxy: Tab would come back here before it got to HOLD.
void ControllerView::focusInEvent(QFocusEvent *event) { m_rail->setFocus(event->reason()); }

void ControllerView::hold()
{
    if (controller().linkState() == LinkState::Disconnected)
        show(holdWithoutLink());
    else
        orders().hold();
}

void ControllerView::showReadiness()
{
    (new dialogs::ReadinessSheet(orders(), m_station->numbering, m_station->shared.store, this))->show();
}

void ControllerView::show(const Notice &notice)
{
    m_noticeAction = notice.action;
    m_notice->show(notice.message);
    const bool isPassing =
        notice.message.severity == widgets::Severity::Notice && controller().linkState() == LinkState::Monitoring;
    if (isPassing && !notice.message.text.isEmpty())
        m_fade.start();
    else
        m_fade.stop();
}

void ControllerView::onLinkChanged()
{
    showLink();
    m_linkNotice = noticeOf(linkView(controller()), m_station->profile());
    show(m_linkNotice);
}

/// What the bar says stays, unless this changes it.
void ControllerView::onHoldStateChanged()
{
    const Notice notice = noticeOf(linkView(controller()), m_station->profile());
    if (notice.message.text != m_linkNotice.message.text)
        onLinkChanged();
    else
        showLink();
}

void ControllerView::onStatisticsChanged()
{
    const auto statistics = controller().statistics();
    for (RobotStrip *strip : findChildren<RobotStrip *>())
        strip->showStatistics(statistics);
    for (pages::Page *page : madePages())
        page->showStatistics(statistics);
}

void ControllerView::showLock()
{
    const QString text = tr("HLOCK is on at %1: the pendant is locked out, but for its emergency stop.");
    const widgets::Message locked {
        widgets::Severity::Warning, text.arg(m_station->profile().name), tr("Release HLOCK")};
    m_lockNotice->show(orders().isPendantLocked() ? locked : widgets::Message {});
}

/// Everything that is ordered is written down; while that fails work goes on and every page says so.
void ControllerView::followJournal()
{
    using journal::Store;
    using widgets::Severity;
    Store &journal = m_station->shared.journal;
    const auto fail = [this](const QString &reason) { m_journalNotice->show({Severity::Warning, reason, {}}); };
    connect(&journal, &Store::failed, this, fail);
    connect(&journal, &Store::recovered, this, [this](qint64 dropped) {
        const QString lost = tr("The journal works again. %n record(s) were lost.", nullptr, int(dropped));
        m_journalNotice->show(dropped > 0 ? widgets::Message {Severity::Warning, lost, {}} : widgets::Message {});
    });
    connect(&journal, &Store::setAside, this, [this](const QString &path) {
        const QString text = tr("The journal was damaged. It was kept as %1, and a new one was begun.");
        m_journalNotice->show({Severity::Warning, text.arg(path), {}});
    });
    if (!journal.trouble().isEmpty())
        fail(journal.trouble());
}

void ControllerView::releaseLock(const std::function<void()> &then)
{
    const auto onEnd = [this, then](const values::Result<void> &result) {
        if (result)
            return then();
        const auto text = explain(robot::Act::HlockOff, result.error(), m_station->profile().model);
        show({{widgets::Severity::Warning, text, {}}, {}});
    };
    orders().send(protocol::HlockOff {}, {robot::Act::HlockOff}, this, onEnd);
}

void ControllerView::showLink()
{
    const LinkView link = linkView(controller());
    for (RobotStrip *strip : findChildren<RobotStrip *>())
        strip->showLink(link);
    for (pages::Page *page : madePages())
        page->showLink(link);
}

} // namespace ui
