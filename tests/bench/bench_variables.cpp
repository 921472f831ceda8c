// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
//
// Reads all variables of a kind the way the pages do, in the fewest packets, and one by one. The controller takes 2 ms
// for each. Prints a table; nothing here passes or fails.
#include "bareserver.h"
#include "protocol/datarequests.h"
#include "robot/readplan.h"
#include "session/session.h"
#include "session/udptransport.h"
#include <QCoreApplication>
#include <QElapsedTimer>
#include <QEventLoop>
#include <QHostAddress>
#include <cstdio>

using namespace std::chrono_literals;
using values::Result;

namespace {

session::Policy policy()
{
    session::Policy result;
    result.requestsPerSecond = 0;
    return result;
}

struct Reading {
    int packets = 0;
    int failures = 0;
    double milliseconds = 0;
};

/// Sends the requests of `plan` and waits for the last answer.
template <typename Item> Reading read(session::Session &session, const QList<robot::PlannedRead> &plan)
{
    QEventLoop loop;
    Reading result;
    result.packets = int(plan.size());
    int left = result.packets;
    const auto onAnswer = [&](bool isGood) {
        result.failures += !isGood;
        if (--left == 0)
            loop.quit();
    };
    QElapsedTimer clock;
    clock.start();
    for (const auto &read : plan) {
        if (read.count == 1) {
            session.send(protocol::ReadItem<Item> {read.range.first}, &loop,
                [onAnswer](const Result<Item> &item) { onAnswer(item.has_value()); });
            continue;
        }
        session.send(*protocol::ReadItems<Item>::create(read.range.first, read.count), &loop,
            [onAnswer](const Result<QList<Item>> &items) { onAnswer(items.has_value()); });
    }
    loop.exec();
    result.milliseconds = double(clock.nsecsElapsed()) / 1e6;
    return result;
}

template <typename Item> void row(session::Session &session, const char *letter, robot::Kind kind, int count)
{
    const auto &dialect = protocol::dialect(protocol::Model::YRC1000);
    const robot::TopicRange all {kind, 0, count - 1};
    QList<robot::PlannedRead> singles;
    for (int number = 0; number < count; ++number)
        singles << robot::PlannedRead {robot::Topic {kind, quint16(number)}, 1};
    const Reading few = read<Item>(session, robot::planReads({all}, {}, dialect));
    const Reading many = read<Item>(session, singles);
    std::printf("%-2s %5d %10d %10.1f %10d %10.1f %10d\n", letter, count, few.packets, few.milliseconds, many.packets,
        many.milliseconds, few.failures + many.failures);
}

} // namespace

int main(int argc, char *argv[])
{
    const QCoreApplication application {argc, argv};
    bare::Server server {1, 2ms};
    session::UdpTransport transport {QHostAddress {QHostAddress::LocalHost}, quint16(server.port())};
    session::Session session {transport, policy()};
    std::puts("        count    packets         ms   one each         ms   failures");
    row<values::ByteVariable>(session, "B", robot::Kind::ByteVariable, 100);
    row<values::IntegerVariable>(session, "I", robot::Kind::IntegerVariable, 100);
    row<values::DoubleVariable>(session, "D", robot::Kind::DoubleVariable, 100);
    row<values::RealVariable>(session, "R", robot::Kind::RealVariable, 100);
    row<values::StringVariable32>(session, "S", robot::Kind::StringVariable, 100);
    row<values::PositionVariable>(session, "P", robot::Kind::PositionVariable, 128);
    return 0;
}
