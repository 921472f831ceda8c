// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
//
// Reads all variables of a kind the way the pages do and one by one. The controller takes 2 ms for each request. Prints
// a table: the fewest packets that the protocol allows, those that arrived at the controller, and the time of each way.
// Nothing here passes or fails.
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
    long packets = 0; ///< That arrived.
    int failures = 0;
    double milliseconds = 0;
};

/// Sends the requests of `plan` and waits for the last answer.
template <typename Item>
Reading read(const bare::Server &server, session::Session &session, const QList<robot::PlannedRead> &plan)
{
    QEventLoop loop;
    Reading result;
    const long before = server.requests();
    qsizetype left = plan.size();
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
    result.packets = server.requests() - before;
    return result;
}

/// The kinds of reference §4.5 with the most items that a packet may carry.
struct Row {
    const char *letter;
    robot::Kind kind;
    int count;
    int mostInAPacket;
};

struct Sum {
    long fewest = 0;
    Reading few;
    Reading many;
};

void print(const char *letter, int count, const Sum &sum)
{
    std::printf("%-3s %6d %8ld %8ld %9.1f %11ld %9.1f %9d\n", letter, count, sum.fewest, sum.few.packets,
        sum.few.milliseconds, sum.many.packets, sum.many.milliseconds, sum.few.failures + sum.many.failures);
}

void add(Reading &sum, const Reading &reading)
{
    sum.packets += reading.packets;
    sum.failures += reading.failures;
    sum.milliseconds += reading.milliseconds;
}

template <typename Item> void measure(const bare::Server &server, session::Session &session, const Row &row, Sum &total)
{
    const auto &dialect = protocol::dialect(protocol::Model::YRC1000);
    const robot::TopicRange all {row.kind, 0, row.count - 1};
    QList<robot::PlannedRead> singles;
    for (int number = 0; number < row.count; ++number)
        singles << robot::PlannedRead {robot::Topic {row.kind, quint16(number)}, 1};
    Sum sum;
    sum.fewest = (row.count + row.mostInAPacket - 1) / row.mostInAPacket;
    sum.few = read<Item>(server, session, robot::planReads({all}, {}, dialect));
    sum.many = read<Item>(server, session, singles);
    print(row.letter, row.count, sum);
    total.fewest += sum.fewest;
    add(total.few, sum.few);
    add(total.many, sum.many);
}

} // namespace

int main(int argc, char *argv[])
{
    using enum robot::Kind;
    const QCoreApplication application {argc, argv};
    bare::Server server {1, 2ms};
    session::UdpTransport transport {QHostAddress {QHostAddress::LocalHost}, quint16(server.port())};
    session::Session session {transport, policy()};
    Sum total;
    std::puts("     count   fewest     sent        ms  one by one        ms  failures");
    measure<values::ByteVariable>(server, session, {"B", ByteVariable, 100, 474}, total);
    measure<values::IntegerVariable>(server, session, {"I", IntegerVariable, 100, 237}, total);
    measure<values::DoubleVariable>(server, session, {"D", DoubleVariable, 100, 118}, total);
    measure<values::RealVariable>(server, session, {"R", RealVariable, 100, 118}, total);
    measure<values::StringVariable32>(server, session, {"S", StringVariable, 100, 14}, total);
    measure<values::PositionVariable>(server, session, {"P", PositionVariable, 128, 9}, total);
    print("all", 5 * 100 + 128, total);
    return 0;
}
