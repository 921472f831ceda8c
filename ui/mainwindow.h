// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "station/fleet.h"
#include "ui/controllerview.h"
#include <QMainWindow>
#include <QPointer>
#include <QSet>
#include <QUuid>
#include <functional>

class QLabel;

namespace robot {
class Controller;
}

namespace dialogs {
class ConnectionDialog;
}

namespace widgets {
class SheetLayer;
}

namespace ui {

/// The window. It shows one station of the fleet at a time; the others go on meanwhile, read once a second.
class MainWindow : public QMainWindow
{
    Q_OBJECT

public:
    /// Starts the simulated controller, if it does not run yet, and tells where it listens.
    using StartDemo = std::function<values::Result<settings::Profile>()>;

    /// `fleet` must outlive the window.
    MainWindow(station::Fleet &fleet, StartDemo startDemo, QWidget *parent = nullptr);

    /// Shows the profile's controller without connecting.
    void offer(const settings::Profile &profile);
    /// Shows the profile's controller and begins checking it. A profile that is in the store becomes the last used.
    void connectTo(const settings::Profile &profile);
    void openDemo();

    using QMainWindow::show;
    [[nodiscard]] robot::Controller &controller() const;
    [[nodiscard]] ControllerView &view() const { return *m_view; }
    [[nodiscard]] const Actions &actions() const { return *m_actions; }

protected:
    void closeEvent(QCloseEvent *event) override;
    void changeEvent(QEvent *event) override;

private:
    void run(ActionId id);
    void show(std::shared_ptr<station::Station> station);
    void translate();
    void openStation(const QUuid &id);
    void turnTo(const std::shared_ptr<station::Station> &station);
    void leave();
    void disarm(robot::Arming::Drop reason);
    void askAndTurnTo(const QUuid &id, const std::function<void()> &turn);
    void leaveLocks(const std::function<void()> &then);
    void leaveLock(const std::function<void()> &then);
    void leaveProgram(const std::function<void()> &then);
    void openAppearance();
    void wear(const settings::Appearance &wanted);
    void restoreWindows();
    void openAccessMenu();
    void openConnectionDialog();
    void openDiagnosis();
    void openHelp();
    void copyDiagnosis();
    void showAbout();
    void makeStatusBar();
    void showLevel();
    void onLinkStateChanged();
    void onStatisticsChanged();

    station::Fleet &m_fleet;
    StartDemo m_startDemo;
    Actions *m_actions;
    ControllerView *m_view = nullptr;
    QLabel *m_level;
    QLabel *m_requests;
    QPointer<dialogs::ConnectionDialog> m_connectionDialog;
    widgets::SheetLayer *m_sheets;
    QSet<QUuid> m_leftLocked; ///< Where the person said to leave HLOCK on.
    bool m_isLeaving = false; ///< Everything was asked: the window closes.
};

} // namespace ui
