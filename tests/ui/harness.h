// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "settings/settingsfile.h"
#include "ui/controllerview.h"
#include "ui/mainwindow.h"
#include "ui/theme.h"
#include "ui/widgets/messagebar.h"
#include "ui/widgets/valuelabel.h"
#include "virtualcontroller/server.h"
#include <QApplication>
#include <QTemporaryDir>
#include <QTest>

/// A window, its settings in a folder of their own, and a virtual controller on real sockets.
class Harness
{
public:
    Harness()
        : file {folder.filePath(QStringLiteral("settings.json"))}, store {file}, window {fleet, [this] {
                                                                                             return startController();
                                                                                         }}
    {
        window.resize(1440, 900); // the screen that is not there is smaller
    }

    values::Result<settings::Profile> startController()
    {
        if (!server) {
            virtualcontroller::Options options;
            options.port = port;
            options.filePort = filePort;
            server = std::make_unique<virtualcontroller::Server>(options);
            server->memory() = virtualcontroller::Memory::demo();
            if (auto started = server->start(); !started)
                return tl::unexpected(started.error());
            port = server->port();
            filePort = server->filePort();
        }
        return profile();
    }
    void stopController() { server.reset(); }

    [[nodiscard]] settings::Profile profile() const
    {
        settings::Profile profile;
        profile.name = QStringLiteral("CELL 4 · Weld");
        profile.host = QStringLiteral("127.0.0.1");
        profile.port = port;
        profile.filePort = filePort;
        profile.readTimeout = readTimeout;
        profile.servoTimeout = servoTimeout;
        return profile;
    }

    /// Starts the controller and connects; true as soon as every value on the overview is live.
    [[nodiscard]] bool connectLive()
    {
        if (!startController())
            return false;
        window.show();
        window.connectTo(profile());
        return QTest::qWaitFor([this] { return isAllLive(); });
    }
    /// As after a restart of the program: nothing is left of the station but what is kept on the disk.
    void connectAnew()
    {
        window.controller().close();
        window.offer({});
        window.connectTo(profile());
    }
    [[nodiscard]] bool isAllLive() const
    {
        for (const robot::Topic topic : robot::topics::overview) {
            if (state().freshness(topic) != robot::Freshness::Live)
                return false;
        }
        return window.controller().linkState() == robot::LinkState::Monitoring;
    }

    /// The state, to be filled by hand between two reads.
    [[nodiscard]] robot::RobotState &state() const
    {
        return const_cast<robot::RobotState &>(window.controller().state());
    }
    [[nodiscard]] widgets::ValueLabel *value(const char *name) const
    {
        auto *found = window.view().findChild<widgets::ValueLabel *>(QLatin1String(name));
        return found ? found : window.findChild<widgets::ValueLabel *>(QLatin1String(name)); // in a sheet
    }
    [[nodiscard]] QString word(const char *name) const { return value(name) ? value(name)->text() : QString(); }
    [[nodiscard]] widgets::MessageBar *bar() const
    {
        return window.findChild<widgets::MessageBar *>(QStringLiteral("linkNotice"));
    }
    [[nodiscard]] QString barText() const { return bar()->isVisible() ? bar()->message().text : QString(); }

    /// The level at the controller that the window shows.
    [[nodiscard]] robot::Access &access() const { return window.view().station()->access; }

    QTemporaryDir folder;
    bool isDataHere = qputenv("XDG_DATA_HOME", folder.path().toLocal8Bit()); ///< Before anything is kept.
    settings::SettingsFile file;
    settings::ProfileStore store;
    robot::AccessRules rules;
    robot::Arming arming {std::chrono::hours {1}}; ///< However busy the computer is.
    std::chrono::milliseconds readTimeout {500}; ///< Of the profile; patient with a busy computer.
    std::chrono::milliseconds servoTimeout {8000};
    journal::Store journal {QUrl::fromLocalFile(folder.filePath(QStringLiteral("journal.sqlite")))};
    station::Fleet fleet {{store, rules, arming, journal}};
    quint16 port = 0;
    quint16 filePort = 0;
    std::unique_ptr<virtualcontroller::Server> server;
    ui::MainWindow window;
};
