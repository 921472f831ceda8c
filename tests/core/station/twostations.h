// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "settings/settingsfile.h"
#include "station/fleet.h"
#include "virtualcontroller/machine.h"
#include "virtualcontroller/server.h"
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

/// A virtual controller at rest, in PLAY and REMOTE, ready to be armed.
struct Machine {
    explicit Machine(quint16 port = 0)
    {
        virtualcontroller::Options options;
        options.port = port;
        options.filePort = 0;
        options.settings.servoDelay = std::chrono::milliseconds {0};
        server = std::make_unique<virtualcontroller::Server>(options);
        isUp = server->start().has_value();
        using values::Status;
        server->memory().status =
            Status {Status::Data1 {Status::Remote} | Status::Play | Status::Continuous, Status::ServoOn};
        virtualcontroller::selectJob(server->memory(), 0, "WELD_A12", 0);
    }
    [[nodiscard]] settings::Profile profile(const QString &name) const
    {
        settings::Profile profile;
        profile.name = name;
        profile.host = QStringLiteral("127.0.0.1");
        profile.port = server->port();
        profile.filePort = server->filePort();
        profile.readTimeout = std::chrono::milliseconds {500};
        return profile;
    }

    std::unique_ptr<virtualcontroller::Server> server;
    bool isUp = false;
};

/// A fleet whose settings, journal and data are in a folder of their own.
struct Plant {
    [[nodiscard]] static bool isLive(const station::Station &station)
    {
        const auto &situation = station.orders.situation();
        return situation.isLinkUp && situation.status && situation.job;
    }

    QTemporaryDir folder;
    bool isDataHere = qputenv("XDG_DATA_HOME", folder.path().toLocal8Bit()); ///< Before anything is kept.
    settings::SettingsFile file {folder.filePath(QStringLiteral("settings.json"))};
    settings::ProfileStore store {file};
    robot::AccessRules rules;
    robot::Arming arming {std::chrono::hours {1}}; ///< However busy the computer is.
    journal::Store journal {QUrl::fromLocalFile(folder.filePath(QStringLiteral("journal.sqlite")))};
    station::Fleet fleet {{store, rules, arming, journal}};
};

/// Two controllers, both monitored.
struct TwoStations : Plant {
    [[nodiscard]] bool live()
    {
        one = fleet.open(machineOne.profile(QStringLiteral("CELL 1")));
        other = fleet.open(machineOther.profile(QStringLiteral("CELL 2")));
        return machineOne.isUp && machineOther.isUp
            && QTest::qWaitFor([this] { return isLive(*one) && isLive(*other); });
    }

    Machine machineOne;
    Machine machineOther;
    std::shared_ptr<station::Station> one;
    std::shared_ptr<station::Station> other;
};
