// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "robot/orders.h"
#include "virtualcontroller/machine.h"
#include "virtualcontroller/server.h"
#include <QTest>

/// A virtual controller at rest, with servo on and a job selected that runs for ever, and the door to it.
struct Cell {
    explicit Cell(const char *job = "WELD_A12")
    {
        virtualcontroller::Options options;
        options.port = 0;
        options.filePort = 0;
        options.settings.servoDelay = std::chrono::milliseconds {0};
        server = std::make_unique<virtualcontroller::Server>(options);
        isUp = server->start().has_value();
        using values::Status;
        server->memory().status =
            Status {Status::Data1 {Status::Remote} | Status::Play | Status::Continuous, Status::ServoOn};
        virtualcontroller::selectJob(server->memory(), 0, job, 0);
        settings::Profile profile;
        profile.name = QStringLiteral("CELL 4");
        profile.host = QStringLiteral("127.0.0.1");
        profile.port = server->port();
        profile.filePort = server->filePort();
        profile.readTimeout = std::chrono::milliseconds {100};
        profile.fileTimeout = std::chrono::milliseconds {300};
        profile.servoTimeout = std::chrono::milliseconds {1000};
        controller = std::make_unique<robot::Controller>(profile);
        interest = controller->poller().want({robot::topics::masterJob});
        orders = std::make_unique<robot::Orders>(*controller, access, arming);
        QObject::connect(orders.get(), &robot::Orders::recorded, orders.get(),
            [this](const journal::OrderRecord &record) { records << record; });
        controller->open();
    }

    [[nodiscard]] bool live(robot::Level level = robot::Level::Engineer)
    {
        access.enter(level);
        const auto isRead = [this] { return orders->situation().status && orders->situation().job; };
        return isUp && QTest::qWaitFor([this] { return orders->situation().isLinkUp; }) && QTest::qWaitFor(isRead);
    }
    [[nodiscard]] bool armed() { return live() && orders->arm(); }

    QList<journal::OrderRecord> records; ///< Outlives the orders, which record to the last.
    robot::AccessRules rules;
    robot::Access access {rules};
    robot::Arming arming {std::chrono::hours {1}}; ///< However busy the computer is.
    std::unique_ptr<virtualcontroller::Server> server;
    std::unique_ptr<robot::Controller> controller;
    robot::Poller::Interest interest;
    std::unique_ptr<robot::Orders> orders;
    bool isUp = false;
};
