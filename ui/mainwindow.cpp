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
#include "ui/widgets/text.h"
#include <QApplication>
#include <QCloseEvent>
#include <QLocale>
#include <QMessageBox>
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
      m_requests {widgets::text({}, Type::Label, Role::Text2)}
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
    connect(new HoldKey(this), &HoldKey::pressed, this, [this] { run(ActionId::Hold); });
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

/// HLOCK outlives this program: the person at the pendant would stand there locked out.
void MainWindow::closeEvent(QCloseEvent *event)
{
    const auto stations = m_fleet.stations();
    const auto locked = std::ranges::find_if(stations, [](const auto &one) { return one->orders.isPendantLocked(); });
    const bool isLocked = locked != stations.end() && !m_isLeavingLocked;
    if (!isLocked && (m_isLeaving || m_fleet.unfinished().isEmpty()))
        return QMainWindow::closeEvent(event);
    event->ignore();
    if (isLocked) {
        turnTo(*locked);
        return offerRelease();
    }
    leaveProgram([this] {
        m_isLeaving = true;
        close();
    });
}

void MainWindow::offerRelease()
{
    if (findChild<QMessageBox *>(QStringLiteral("releaseLockBox")))
        return;
    auto *box = new QMessageBox(QMessageBox::NoIcon, tr("HLOCK is on"),
        tr("HLOCK is still on at %1: the pendant stays locked out after closing.").arg(controller().profile().name),
        QMessageBox::Cancel, this);
    box->setObjectName(QStringLiteral("releaseLockBox"));
    box->setAttribute(Qt::WA_DeleteOnClose);
    auto *release = box->addButton(tr("Release HLOCK and close"), QMessageBox::AcceptRole);
    auto *leave = box->addButton(tr("Close and leave it on"), QMessageBox::DestructiveRole);
    release->setObjectName(QStringLiteral("releaseLock"));
    leave->setObjectName(QStringLiteral("leaveLock"));
    connect(release, &QAbstractButton::clicked, m_view, [this] {
        m_view->releaseLock();
        connect(&m_view->orders(), &robot::Orders::pendantLockChanged, this, &QWidget::close);
    });
    connect(leave, &QAbstractButton::clicked, this, [this] {
        m_isLeavingLocked = true;
        close();
    });
    box->open();
}

void MainWindow::offer(const settings::Profile &profile) { turnTo(m_fleet.add(profile)); }

/// The pages of a controller; one that is not connected is offered.
void MainWindow::openStation(const QUuid &id)
{
    for (const auto &entry : m_fleet.roster()) {
        if (entry.profile.id == id && !id.isNull())
            return entry.station ? turnTo(entry.station) : offer(entry.profile);
    }
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
    m_view->setFocus();
    connect(&controller(), &robot::Controller::linkStateChanged, this, &MainWindow::onLinkStateChanged);
    connect(&m_view->station()->access, &robot::Access::levelChanged, m_view, [this] { showLevel(); });
    showLevel();
    connect(m_view, &ControllerView::pageOpened, this, &MainWindow::showHelpOf);
    showHelpOf(m_view->pageInView());
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
    for (QDialog *dialog : findChildren<QDialog *>(QString(), Qt::FindDirectChildrenOnly))
        dialog->close();
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
    auto *box = new QMessageBox(
        QMessageBox::NoIcon, tr("Something is unfinished"), losses.join(u'\n'), QMessageBox::Cancel, this);
    box->setObjectName(QStringLiteral("unfinishedBox"));
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->setDefaultButton(QMessageBox::Cancel);
    auto *goOn = box->addButton(tr("Go on and lose it"), QMessageBox::DestructiveRole);
    goOn->setObjectName(QStringLiteral("loseUnfinished"));
    connect(goOn, &QAbstractButton::clicked, this, then);
    box->open();
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
    turnTo(m_fleet.open(profile));
    if (m_fleet.shared().store.find(profile.name))
        m_fleet.shared().store.setLastUsed(profile.name);
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
    case ActionId::Disconnect: return controller().close();
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
    m_connectionDialog->raise();
}

void MainWindow::openDiagnosis() { (new dialogs::DiagnosisDialog(controller().profile(), this))->show(); }

void MainWindow::openHelp()
{
    auto *help = findChild<dialogs::HelpDialog *>();
    if (!help)
        help = new dialogs::HelpDialog(m_view->pageInView(), this);
    help->show();
    help->raise();
    help->activateWindow();
}

/// While the help is open it follows the page.
void MainWindow::showHelpOf(int page)
{
    if (auto *help = findChild<dialogs::HelpDialog *>())
        help->showPage(page);
}

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
    dialog->open();
}

void MainWindow::wear(const settings::Appearance &wanted)
{
    m_fleet.shared().store.setAppearance(wanted);
    ui::wear(*qApp, wanted);
}

void MainWindow::showAbout()
{
    auto *box = new QMessageBox(QMessageBox::NoIcon, tr("About Pendesk"),
        tr("Pendesk %1\n\nA teach and monitor desk for Yaskawa robot controllers.\nFree software under the GNU General "
           "Public License, version 3 or later.\n\nHOLD is a software hold over the network, not a safety function.")
            .arg(QCoreApplication::applicationVersion()),
        QMessageBox::Close, this);
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->setModal(false);
    box->show();
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
