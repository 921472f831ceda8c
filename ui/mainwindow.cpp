// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/mainwindow.h"

#include "robot/controller.h"
#include "ui/controllerview.h"
#include "ui/dialogs/connectiondialog.h"
#include "ui/dialogs/diagnosisdialog.h"
#include "ui/dialogs/shortcutsdialog.h"
#include "ui/holdkey.h"
#include "ui/icons.h"
#include "ui/widgets/text.h"
#include <QApplication>
#include <QLocale>
#include <QMessageBox>
#include <QStatusBar>

namespace ui {

using robot::LinkState;

MainWindow::MainWindow(settings::ProfileStore &store, StartDemo startDemo, QWidget *parent)
    : QMainWindow(parent),
      m_store {store},
      m_startDemo {std::move(startDemo)},
      m_actions {new Actions(this)},
      m_requests {widgets::text({}, Type::Label, Role::Text2)}
{
    setWindowIcon(applicationIcon());
    resize(1440, 900);
    makeStatusBar();
    connect(m_actions, &Actions::triggered, this, &MainWindow::run);
    connect(new HoldKey(this), &HoldKey::pressed, this, [this] { run(ActionId::Hold); });
    offer({});
}

robot::Controller &MainWindow::controller() const { return m_view->controller(); }

void MainWindow::makeStatusBar()
{
    statusBar()->addWidget(widgets::text(tr("Level: Monitor"), Type::Label, Role::Text2));
    statusBar()->addWidget(m_requests);
    m_requests->setObjectName(QStringLiteral("requestsPerSecond"));
    statusBar()->setSizeGripEnabled(false);
    statusBar()->setContentsMargins(space::page - 4, 0, space::page, 0);
}

void MainWindow::offer(const settings::Profile &profile)
{
    if (QWidget *old = takeCentralWidget()) {
        controller().disconnect(this);
        controller().close();
        old->deleteLater(); // it may be one of its buttons that led here
    }
    m_view = new ControllerView(profile, *m_actions);
    setCentralWidget(m_view);
    m_view->setFocus();
    connect(&controller(), &robot::Controller::linkStateChanged, this, &MainWindow::onLinkStateChanged);
    connect(&controller(), &robot::Controller::statisticsChanged, this, &MainWindow::onStatisticsChanged);
    setWindowTitle(profile.name.isEmpty() ? tr("Pendesk") : tr("%1 — Pendesk").arg(profile.name));
    onLinkStateChanged();
}

void MainWindow::connectTo(const settings::Profile &profile)
{
    offer(profile);
    if (m_store.find(profile.name))
        m_store.setLastUsed(profile.name);
    controller().open();
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
    case ActionId::Connect: return openConnectionDialog();
    case ActionId::Reconnect: return controller().open();
    case ActionId::Disconnect: return controller().close();
    case ActionId::Demo: return openDemo();
    case ActionId::Diagnose: return openDiagnosis();
    case ActionId::CopyDiagnosis: return copyDiagnosis();
    case ActionId::Shortcuts: return (new dialogs::ShortcutsDialog(this))->show();
    case ActionId::About: return showAbout();
    case ActionId::Quit: close();
    }
}

void MainWindow::openConnectionDialog()
{
    if (!m_connectionDialog) {
        m_connectionDialog = new dialogs::ConnectionDialog(m_store, controller().profile().name, this);
        connect(m_connectionDialog, &dialogs::ConnectionDialog::connectRequested, this, &MainWindow::connectTo);
    }
    m_connectionDialog->show();
    m_connectionDialog->raise();
}

void MainWindow::openDiagnosis() { (new dialogs::DiagnosisDialog(controller().profile(), this))->show(); }

void MainWindow::copyDiagnosis()
{
    auto *dialog = new dialogs::DiagnosisDialog(controller().profile(), this);
    dialog->copyWhenFinished();
    dialog->show();
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
    for (const ActionId id : {ActionId::Diagnose, ActionId::CopyDiagnosis})
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
