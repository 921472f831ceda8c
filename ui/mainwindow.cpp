// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/mainwindow.h"

#include "robot/controller.h"
#include "ui/accessswitch.h"
#include "ui/appearance.h"
#include "ui/conditionwords.h"
#include "ui/dialogs/appearancedialog.h"
#include "ui/dialogs/connectiondialog.h"
#include "ui/dialogs/diagnosisdialog.h"
#include "ui/dialogs/helpdialog.h"
#include "ui/holdkey.h"
#include "ui/icons.h"
#include "ui/widgets/question.h"
#include "ui/widgets/sheetlayer.h"
#include "ui/widgets/text.h"
#include <QApplication>
#include <QCloseEvent>
#include <QLocale>
#include <QScreen>
#include <QStatusBar>

namespace ui {

using robot::LinkState;

MainWindow::MainWindow(station::Fleet &fleet, StartDemo startDemo, QWidget *parent)
    : QMainWindow(parent),
      m_fleet {fleet},
      m_startDemo {std::move(startDemo)},
      m_actions {new Actions(this)},
      m_level {widgets::text({}, Type::Label, Role::Text2)},
      m_requests {widgets::text({}, Type::Label, Role::Text2)},
      m_sheets {new widgets::SheetLayer(this, space::strip)}
{
    setWindowIcon(applicationIcon());
    resize(QSize(1440, 900).boundedTo(screen()->availableSize()));
    makeStatusBar();
    connect(m_actions, &Actions::triggered, this, &MainWindow::run);
    connect(m_actions, &Actions::profileChosen, this, [this](const QString &name) {
        if (const auto profile = m_fleet.shared().store.find(name))
            connectTo(*profile);
    });
    connect(m_actions, &Actions::stationChosen, this, &MainWindow::openStation);
    new HoldKey(this);
    offer({});
}

robot::Controller &MainWindow::controller() const { return m_view->controller(); }

void MainWindow::makeStatusBar()
{
    m_level->setObjectName(QStringLiteral("levelInStatusBar"));
    statusBar()->addWidget(m_level);
    statusBar()->addWidget(m_requests);
    m_requests->setObjectName(QStringLiteral("requestsPerSecond"));
    statusBar()->setSizeGripEnabled(false);
    statusBar()->setContentsMargins(space::page - 4, 0, space::page, 0);
}

void MainWindow::showLevel() { m_level->setText(tr("Level: %1").arg(title(m_view->station()->access.level()))); }

void MainWindow::openAccessMenu()
{
    if (auto *badge = m_view->findChild<AccessSwitch *>())
        badge->showMenu();
}

void MainWindow::closeEvent(QCloseEvent *event)
{
    const auto stations = m_fleet.stations();
    const bool isLocked = std::ranges::any_of(stations, [](const auto &one) { return one->orders.isPendantLocked(); });
    if (m_isLeaving || (!isLocked && m_fleet.unfinished().isEmpty()))
        return QMainWindow::closeEvent(event);
    event->ignore();
    const auto closeNow = [this] {
        m_isLeaving = true;
        close();
    };
    leaveLocks([this, closeNow] { leaveProgram(closeNow); });
}

/// Asks for one station after the other where HLOCK is on.
void MainWindow::leaveLocks(const std::function<void()> &then)
{
    const auto stations = m_fleet.stations();
    const auto locked = std::ranges::find_if(stations,
        [this](const auto &one) { return one->orders.isPendantLocked() && !m_leftLocked.contains(one->id()); });
    if (locked == stations.end())
        return then();
    turnTo(*locked);
    leaveLock([this, then] { leaveLocks(then); });
}

/// HLOCK outlives this program: the person at the pendant would stand there locked out.
void MainWindow::leaveLock(const std::function<void()> &then)
{
    const QUuid id = m_view->station()->id();
    if (!m_view->orders().isPendantLocked() || m_leftLocked.contains(id))
        return then();
    const auto leaveOn = [this, id, then] {
        m_leftLocked.insert(id);
        then();
    };
    widgets::ask("releaseLockBox", tr("HLOCK is on"),
        tr("HLOCK is still on at %1: the pendant stays locked out if you go on.").arg(controller().profile().name),
        {{"releaseLock", tr("Release HLOCK and go on"), [this, then] { m_view->releaseLock(then); }},
            {"leaveLock", tr("Go on and leave it on"), leaveOn}},
        this);
}

void MainWindow::offer(const settings::Profile &profile) { turnTo(m_fleet.add(profile)); }

/// The pages of a controller; one that is not connected is offered.
void MainWindow::openStation(const QUuid &id)
{
    for (const auto &entry : m_fleet.roster()) {
        if (entry.profile.id == id && !id.isNull())
            return askAndTurnTo(id, [this, entry] { entry.station ? turnTo(entry.station) : offer(entry.profile); });
    }
}

/// Whoever goes to another controller is asked first what becomes of HLOCK at this one.
void MainWindow::askAndTurnTo(const QUuid &id, const std::function<void()> &turn)
{
    if (m_view->station()->id() == id)
        turn();
    else
        leaveLock(turn);
}

void MainWindow::turnTo(const std::shared_ptr<station::Station> &station)
{
    if (m_view && m_view->station() == station)
        return;
    if (m_view)
        leave();
    show(station);
}

/// A level belongs to the controller in view: whoever comes back begins in Monitor.
void MainWindow::leave()
{
    station::Station &left = *m_view->station();
    disarm(robot::Arming::Drop::StationLeft);
    left.access.enter(robot::Level::Monitor);
    left.controller.disconnect(this);
    left.controller.setPace(robot::Pace::Background);
    if (!left.isOpen() && m_fleet.find(left.id()) == m_view->station())
        m_fleet.close(left.id());
}

void MainWindow::disarm(robot::Arming::Drop reason)
{
    if (m_view->orders().isArmed())
        m_fleet.shared().arming.drop(reason);
}

/// Puts widgets around the station, in place of those that are there.
void MainWindow::show(std::shared_ptr<station::Station> station)
{
    if (QWidget *old = takeCentralWidget()) {
        old->deleteLater(); // it may be one of its buttons that led here
    }
    station->controller.setPace(robot::Pace::Watched);
    m_view = new ControllerView(std::move(station), m_fleet, *m_actions);
    setCentralWidget(m_view);
    m_sheets->raise();
    m_view->setFocus();
    connect(&controller(), &robot::Controller::linkStateChanged, this, &MainWindow::onLinkStateChanged);
    connect(&m_view->station()->access, &robot::Access::levelChanged, m_view, [this] { showLevel(); });
    showLevel();
    connect(&controller(), &robot::Controller::statisticsChanged, this, &MainWindow::onStatisticsChanged);
    const settings::Profile &profile = controller().profile();
    setWindowTitle(profile.name.isEmpty() ? tr("Pendesk") : tr("%1 — Pendesk").arg(profile.name));
    if (!profile.host.isEmpty())
        restoreWindows();
    onLinkStateChanged();
}

void MainWindow::changeEvent(QEvent *event)
{
    if (event->type() == QEvent::LanguageChange && m_view)
        translate();
    QMainWindow::changeEvent(event);
}

/// Everything in the window is made anew but the station: the link stays up, and what was read is shown.
void MainWindow::translate()
{
    const int row = m_view->openRow();
    disarm(robot::Arming::Drop::LanguageChanged);
    m_sheets->clear();
    m_actions->translate();
    controller().disconnect(this);
    show(m_view->station());
    m_view->openPage(row);
}

/// Goes on at once if nothing would be lost, else when the person says so.
void MainWindow::leaveProgram(const std::function<void()> &then)
{
    const QStringList losses = m_fleet.unfinished();
    if (losses.isEmpty())
        return then();
    widgets::ask("unfinishedBox", tr("Something is unfinished"), losses.join(u'\n'),
        {{"loseUnfinished", tr("Go on and lose it"), then}}, this);
}

/// The windows that stood open the last time, and from now on what is opened and closed is kept.
void MainWindow::restoreWindows()
{
    for (const QString &id : m_fleet.shared().store.pagesInWindows())
        m_view->openInWindow(id);
    connect(m_view, &ControllerView::pagesInWindowsChanged, this,
        [this] { m_fleet.shared().store.setPagesInWindows(m_view->pagesInWindows()); });
}

void MainWindow::connectTo(const settings::Profile &profile)
{
    askAndTurnTo(profile.id, [this, profile] {
        turnTo(m_fleet.open(profile));
        if (m_fleet.shared().store.find(profile.name))
            m_fleet.shared().store.setLastUsed(profile.name);
    });
}

void MainWindow::openDemo()
{
    const auto profile = m_startDemo();
    if (profile)
        return connectTo(*profile);
    m_view->show(
        {{widgets::Severity::Alarm, tr("The demo could not be started: %1.").arg(profile.error().detail), {}}, {}});
}

void MainWindow::run(ActionId id)
{
    switch (id) {
    case ActionId::Hold: return m_view->hold();
    case ActionId::OpenInWindow: return m_view->openInWindow();
    case ActionId::Access: return openAccessMenu();
    case ActionId::Connect: return openConnectionDialog();
    case ActionId::Reconnect: return controller().open();
    case ActionId::Disconnect: return leaveLock([this] { controller().close(); });
    case ActionId::Demo: return openDemo();
    case ActionId::Diagnose: return openDiagnosis();
    case ActionId::CopyDiagnosis: return copyDiagnosis();
    case ActionId::Appearance: return openAppearance();
    case ActionId::Readiness: return m_view->showReadiness();
    case ActionId::Help: return openHelp();
    case ActionId::About: return showAbout();
    case ActionId::Quit: close();
    }
}

void MainWindow::openConnectionDialog()
{
    if (!m_connectionDialog) {
        m_connectionDialog = new dialogs::ConnectionDialog(m_fleet.shared().store, controller().profile().name, this);
        connect(m_connectionDialog, &dialogs::ConnectionDialog::connectRequested, this, &MainWindow::connectTo);
    }
    m_connectionDialog->show();
}

void MainWindow::openDiagnosis() { (new dialogs::DiagnosisDialog(controller().profile(), this))->show(); }

void MainWindow::openHelp() { (new dialogs::HelpDialog(m_view->pageInView(), this))->show(); }

void MainWindow::copyDiagnosis()
{
    auto *dialog = new dialogs::DiagnosisDialog(controller().profile(), this);
    dialog->copyWhenFinished();
    dialog->show();
}

void MainWindow::openAppearance()
{
    auto *dialog = new dialogs::AppearanceDialog(m_fleet.shared().store.appearance(), this);
    connect(dialog, &dialogs::AppearanceDialog::chosen, this, &MainWindow::wear);
    dialog->show();
}

void MainWindow::wear(const settings::Appearance &wanted)
{
    const auto change = [this, wanted] {
        m_fleet.shared().store.setAppearance(wanted);
        ui::wear(*qApp, wanted);
    };
    if (wanted.language == m_fleet.shared().store.appearance().language)
        change(); // no page is made anew
    else
        leaveLock(change);
}

void MainWindow::showAbout()
{
    widgets::ask("aboutBox", tr("About Pendesk"),
        tr("Pendesk %1\n\nA teach and monitor desk for Yaskawa robot controllers.\nFree software under the GNU General "
           "Public License, version 3 or later.\n\nHOLD is a software hold over the network, not a safety function.")
            .arg(QCoreApplication::applicationVersion()),
        {}, this);
}

void MainWindow::onLinkStateChanged()
{
    const LinkState state = controller().linkState();
    const bool hasHost = !controller().profile().host.isEmpty();
    const auto allow = [this](ActionId id, bool allowed, const QString &reason) {
        QAction *action = m_actions->action(id);
        action->setEnabled(allowed);
        action->setToolTip(allowed ? action->text() : reason);
    };
    allow(ActionId::Disconnect, state != LinkState::Disconnected, tr("There is no connection."));
    allow(ActionId::Reconnect, hasHost && state == LinkState::Disconnected,
        hasHost ? tr("The connection is open.") : tr("No controller is chosen."));
    for (const ActionId id : {ActionId::Diagnose, ActionId::CopyDiagnosis, ActionId::Readiness})
        allow(id, hasHost, tr("No controller is chosen: connect first."));
    if (state == LinkState::Disconnected)
        m_requests->clear();
    if (state == LinkState::Monitoring && m_connectionDialog)
        m_connectionDialog->close();
}

void MainWindow::onStatisticsChanged()
{
    m_requests->setText(tr("%1 requests/s").arg(QLocale().toString(controller().statistics().requestsPerSecond)));
}

} // namespace ui
