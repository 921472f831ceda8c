// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "robot/edits.h"
#include "virtualcontroller/server.h"
#include <QElapsedTimer>
#include <QSignalSpy>
#include <QTest>

/// QTest::qWaitFor() sleeps between two looks, which makes hundreds of requests slow. Nobody is late before a minute.
inline bool waitFor(const std::function<bool()> &isTrue)
{
    QElapsedTimer clock;
    clock.start();
    while (!isTrue() && clock.elapsed() < 60'000)
        QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
    return isTrue();
}

/// A controller on real sockets, the door to it, and edits. The profile may believe another numbering than it has.
struct Desk {
    explicit Desk(protocol::Numbering numbering = protocol::Numbering::FromZero,
        protocol::Model model = protocol::Model::YRC1000, std::optional<protocol::Numbering> believed = {})
    {
        options.port = 0;
        options.filePort = 0;
        options.settings.numbering = numbering;
        options.settings.model = model;
        isUp = start();
        settings::Profile profile;
        profile.name = QStringLiteral("CELL 4");
        profile.host = QStringLiteral("127.0.0.1");
        profile.port = server->port();
        profile.filePort = server->filePort();
        profile.readTimeout = std::chrono::milliseconds {500};
        profile.requestsPerSecond = 2000;
        profile.numbering = believed.value_or(numbering);
        profile.model = model;
        controller = std::make_unique<robot::Controller>(profile);
        orders = std::make_unique<robot::Orders>(*controller, access, arming);
        QObject::connect(orders.get(), &robot::Orders::recorded, orders.get(),
            [this](const journal::OrderRecord &record) { records << record; });
        variables::Format format;
        format.stringSize = protocol::dialect(model).stringSize;
        edits = std::make_unique<robot::Edits>(*orders, format);
        controller->open();
    }

    /// A new controller at the same place.
    [[nodiscard]] bool start()
    {
        server = std::make_unique<virtualcontroller::Server>(options);
        const bool isStarted = server->start().has_value();
        options.port = server->port();
        options.filePort = server->filePort();
        return isStarted;
    }

    [[nodiscard]] bool live(bool isVerified = true)
    {
        access.enter(robot::Level::Engineer);
        orders->setNumberingVerified(isVerified);
        return isUp && waitFor([this] { return orders->situation().isLinkUp && orders->situation().status; });
    }

    [[nodiscard]] bool watch(const QList<robot::TopicRange> &topics)
    {
        interest = controller->poller().want(topics);
        return waitFor([&] {
            return std::ranges::all_of(topics, [this](const robot::TopicRange &range) {
                return controller->state().freshness({range.kind, range.last}) != robot::Freshness::Unknown;
            });
        });
    }

    /// Applies, and waits for the end.
    [[nodiscard]] bool apply()
    {
        QSignalSpy applied {edits.get(), &robot::Edits::applied};
        edits->apply();
        return waitFor([&] { return applied.count() == 1; });
    }

    [[nodiscard]] int writes() const
    {
        int count = 0;
        for (const auto &record : records)
            count += record.action.startsWith(QStringLiteral("write-"));
        return count;
    }

    virtualcontroller::Options options;
    robot::AccessRules rules;
    robot::Access access {rules};
    robot::Arming arming {std::chrono::hours {1}}; ///< However busy the computer is.
    std::unique_ptr<virtualcontroller::Server> server;
    std::unique_ptr<robot::Controller> controller;
    std::unique_ptr<robot::Orders> orders;
    std::unique_ptr<robot::Edits> edits;
    robot::Poller::Interest interest;
    QList<journal::OrderRecord> records;
    bool isUp = false;
};
