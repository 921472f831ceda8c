// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "protocol/requests.h"
#include "session/exchange.h"
#include <QTest>

using namespace std::chrono_literals;
using namespace session;
using protocol::Effect;
using values::ErrorKind;

namespace {

/// One client and one silent wire, with a clock that stands until it is moved.
class Wire
{
public:
    explicit Wire(const Policy &policy = freePolicy(), quint8 firstId = 0) : exchange {policy, firstId, 1} { }

    /// No ceiling: what is tested here is repeats and order.
    static Policy freePolicy()
    {
        Policy policy;
        policy.requestsPerSecond = 0;
        return policy;
    }

    Ticket read(Priority priority = Priority::Page)
    {
        return exchange.submit(protocol::ReadStatus {}.request(), Effect::Reads, priority, now);
    }
    Ticket order(Effect effect, Priority priority = Priority::Control)
    {
        return exchange.submit(protocol::ServoOn {}.request(), effect, priority, now);
    }

    /// Everything that leaves at this moment.
    QList<QByteArray> depart()
    {
        QList<QByteArray> packets;
        while (const auto departure = exchange.depart(now))
            packets.append(departure->packet.toByteArray());
        return packets;
    }

    /// Moves the clock from deadline to deadline; returns how many packets left.
    int runUntil(Time end)
    {
        int packets = int(depart().size());
        while (true) {
            const auto next = exchange.nextDeadline(now);
            if (!next || *next > end)
                break;
            now = std::max(*next, now + 1us);
            for (Ending &ending : exchange.expire(now))
                endings.push_back(std::move(ending));
            packets += int(depart().size());
        }
        now = end;
        return packets;
    }

    std::optional<Ending> answer(const QByteArray &request, quint8 status = 0, quint16 added = 0, int idShift = 0)
    {
        const auto packet = protocol::parseClientPacket(request);
        const protocol::Reply reply {
            {protocol::Division::Robot, true, quint8(packet->framing.id + idShift), protocol::lastBlock},
            protocol::replyService(packet->service), status, quint8(status ? 1 : 0), added, {}};
        return exchange.receive(protocol::encode(reply), now);
    }

    Exchange exchange;
    Time now {1h};
    std::vector<Ending> endings;
};

quint8 idOf(const QByteArray &packet) { return protocol::parseClientPacket(packet)->framing.id; }

} // namespace

class TestExchange : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void triesByEffect_data()
    {
        QTest::addColumn<Effect>("effect");
        QTest::addColumn<Priority>("priority");
        QTest::addColumn<int>("leastTries");
        QTest::addColumn<int>("mostTries");
        QTest::addColumn<ErrorKind>("error");
        // silence, nothing measured: a read waits 300 ms three times; a stop goes on for 2 s, every 300 ms
        QTest::newRow("read") << Effect::Reads << Priority::Page << 3 << 3 << ErrorKind::NoAnswer;
        QTest::newRow("stop") << Effect::Stops << Priority::Stop << 7 << 7 << ErrorKind::NoAnswer;
        QTest::newRow("write") << Effect::Writes << Priority::Control << 1 << 1 << ErrorKind::UnknownOutcome;
        QTest::newRow("start") << Effect::Starts << Priority::Control << 1 << 1 << ErrorKind::UnknownOutcome;
        QTest::newRow("move") << Effect::Moves << Priority::Control << 1 << 1 << ErrorKind::UnknownOutcome;
    }

    void triesByEffect()
    {
        QFETCH(Effect, effect);
        QFETCH(Priority, priority);
        QFETCH(int, leastTries);
        QFETCH(int, mostTries);
        QFETCH(ErrorKind, error);
        Wire wire;
        const Ticket ticket = wire.order(effect, priority);
        const int packets = wire.runUntil(wire.now + 60s);
        QVERIFY(packets >= leastTries && packets <= mostTries);
        QCOMPARE(wire.endings.size(), 1U);
        QCOMPARE(wire.endings.front().ticket, ticket);
        QCOMPARE(wire.endings.front().reply.error().kind, error);
        QVERIFY(wire.exchange.isIdle());
    }

    void aRepeatKeepsItsId()
    {
        Wire wire;
        wire.read();
        const auto first = wire.depart();
        wire.now += 300ms;
        const auto second = wire.depart();
        QCOMPARE(second, first);
        QVERIFY(wire.answer(second.first()));
    }

    void aMeasuredLinkRepeatsSoon()
    {
        Wire wire;
        wire.read();
        const auto first = wire.depart();
        wire.now += 2ms;
        QVERIFY(wire.answer(first.first()));
        wire.read();
        QCOMPARE(wire.depart().size(), 1);
        wire.now += 19ms;
        QCOMPARE(wire.depart().size(), 0); // the floor is 20 ms
        wire.now += 1ms;
        QCOMPARE(wire.depart().size(), 1);
    }

    void oneOutstandingButStopsPass()
    {
        Wire wire;
        wire.read();
        wire.read();
        QCOMPARE(wire.depart().size(), 1);
        wire.exchange.submit(protocol::HoldOn {}.request(), Effect::Stops, Priority::Stop, wire.now);
        const auto stop = wire.depart();
        QCOMPARE(stop.size(), 1);
        QCOMPARE(protocol::parseClientPacket(stop.first())->command, quint16(0x83));
    }

    void stopsPassTheCeiling()
    {
        Policy policy;
        policy.requestsPerSecond = 1;
        policy.window = 8;
        Wire wire {policy};
        wire.read();
        wire.read();
        QCOMPARE(wire.depart().size(), 1);
        wire.order(Effect::Stops, Priority::Stop);
        QCOMPARE(wire.depart().size(), 1);
        wire.now += 1s;
        QVERIFY(wire.depart().size() >= 1);
    }

    void controlGoesBeforePages()
    {
        Wire wire;
        wire.read(Priority::Background);
        wire.read(Priority::Page);
        wire.order(Effect::Writes, Priority::Control);
        const auto first = wire.depart();
        QCOMPARE(first.size(), 1);
        QCOMPARE(protocol::parseClientPacket(first.first())->command, quint16(0x83));
    }

    void aSlowStartDoesNotStopReading()
    {
        Wire wire;
        wire.order(Effect::Starts);
        QCOMPARE(wire.depart().size(), 1);
        wire.read();
        QCOMPARE(wire.depart().size(), 0);
        wire.now += 300ms;
        QCOMPARE(wire.depart().size(), 1);
    }

    void theWindowIsFilledAndNoMore()
    {
        Policy policy = Wire::freePolicy();
        policy.window = 4;
        Wire wire {policy};
        for (int i = 0; i < 10; ++i)
            wire.read();
        const auto packets = wire.depart();
        QCOMPARE(packets.size(), 4);
        QVERIFY(wire.answer(packets[2]));
        QCOMPARE(wire.depart().size(), 1);
    }

    void strayAnswers_data()
    {
        QTest::addColumn<QByteArray>("datagram");
        QTest::addColumn<quint64>("malformed");
        QTest::addColumn<quint64>("mismatched");
        QTest::addColumn<quint64>("late");
        const protocol::Framing framing {protocol::Division::Robot, true, 0, protocol::lastBlock};
        const auto reply = [&](quint8 id, quint8 service) {
            auto other = framing;
            other.id = id;
            return protocol::encode(protocol::Reply {other, service, 0, 0, 0, {}});
        };
        auto file = framing;
        file.division = protocol::Division::File;
        QTest::newRow("nothing") << QByteArray {} << quint64(1) << quint64(0) << quint64(0);
        QTest::newRow("garbage") << QByteArray(40, 'x') << quint64(1) << quint64(0) << quint64(0);
        QTest::newRow("a request") << protocol::encode(protocol::ReadStatus {}.request(), protocol::Framing {})
                                   << quint64(1) << quint64(0) << quint64(0);
        QTest::newRow("file division") << protocol::encode(protocol::Reply {file, 0x81, 0, 0, 0, {}}) << quint64(1)
                                       << quint64(0) << quint64(0);
        QTest::newRow("wrong id") << reply(9, 0x81) << quint64(0) << quint64(0) << quint64(1);
        QTest::newRow("wrong service") << reply(0, 0x8E) << quint64(0) << quint64(1) << quint64(0);
        QTest::newRow("request service") << reply(0, 0x01) << quint64(0) << quint64(1) << quint64(0);
    }

    void strayAnswers()
    {
        QFETCH(QByteArray, datagram);
        QFETCH(quint64, malformed);
        QFETCH(quint64, mismatched);
        QFETCH(quint64, late);
        Wire wire;
        wire.read();
        wire.depart();
        QVERIFY(!wire.exchange.receive(datagram, wire.now));
        QCOMPARE(wire.exchange.counters().malformed, malformed);
        QCOMPARE(wire.exchange.counters().mismatched, mismatched);
        QCOMPARE(wire.exchange.counters().late, late);
        QVERIFY(!wire.exchange.isIdle());
    }

    void aSecondAnswerIsADuplicate()
    {
        Wire wire;
        wire.read();
        const auto packet = wire.depart().first();
        QVERIFY(wire.answer(packet));
        QVERIFY(!wire.answer(packet));
        QCOMPARE(wire.exchange.counters().duplicates, quint64(1));
    }

    void anAnswerAfterTheEndIsLate()
    {
        Wire wire;
        wire.order(Effect::Writes);
        const auto packet = wire.depart().first();
        wire.runUntil(wire.now + 1s);
        QCOMPARE(wire.endings.size(), 1U);
        QVERIFY(!wire.answer(packet));
        QCOMPARE(wire.exchange.counters().late, quint64(1));
    }

    void anIdRestsWhileAnAnswerCouldCome()
    {
        Policy policy = Wire::freePolicy();
        policy.timeout = 20ms;
        policy.repeats = 0;
        policy.idLinger = 60s;
        policy.window = 8;
        Wire wire {policy, 250};
        wire.read();
        const quint8 unanswered = idOf(wire.depart().first());
        QCOMPARE(unanswered, quint8(250));
        wire.runUntil(wire.now + 20ms);
        for (int i = 0; i < 600; ++i) {
            wire.read();
            const auto packet = wire.depart().first();
            QVERIFY(idOf(packet) != unanswered);
            QVERIFY(wire.answer(packet));
        }
        wire.now += 60s;
        QSet<quint8> seen;
        for (int i = 0; i < 256; ++i) {
            wire.read();
            const auto packet = wire.depart().first();
            seen.insert(idOf(packet));
            QVERIFY(wire.answer(packet));
        }
        QCOMPARE(seen.size(), 256);
    }

    void aStopGetsAnIdEvenWhenAllRest()
    {
        Policy policy = Wire::freePolicy();
        policy.timeout = 20ms;
        policy.repeats = 0;
        policy.idLinger = 60s;
        policy.window = 8;
        Wire wire {policy};
        for (int i = 0; i < 300; ++i)
            wire.read();
        wire.runUntil(wire.now + 10s);
        QCOMPARE(wire.exchange.counters().requests, quint64(256));
        wire.order(Effect::Stops, Priority::Stop);
        QCOMPARE(wire.depart().size(), 1);
    }

    void busyIsAskedAgain_data()
    {
        QTest::addColumn<Effect>("effect");
        QTest::addColumn<quint16>("code");
        QTest::addColumn<int>("answersUntilTheEnd");
        // reference §9: the busy group; five repeats after the first answer, reads only
        for (const int code : {0x2090, 0xD8F1, 0xD8FA, 0xE444, 0xFFF6})
            QTest::addRow("read %04X", code) << Effect::Reads << quint16(code) << 6;
        QTest::newRow("read 2060") << Effect::Reads << quint16(0x2060) << 1;
        QTest::newRow("write FFF6") << Effect::Writes << quint16(0xFFF6) << 1;
        QTest::newRow("start FFF6") << Effect::Starts << quint16(0xFFF6) << 1;
        QTest::newRow("move D8FA") << Effect::Moves << quint16(0xD8FA) << 1;
    }

    void busyIsAskedAgain()
    {
        QFETCH(Effect, effect);
        QFETCH(quint16, code);
        QFETCH(int, answersUntilTheEnd);
        Wire wire;
        wire.order(effect);
        auto packets = wire.depart();
        std::optional<Ending> ending;
        int answers = 0;
        for (; !ending && answers < 20; ++answers) {
            QCOMPARE(packets.size(), 1);
            ending = wire.answer(packets.first(), 0x1F, code);
            if (!ending) {
                QCOMPARE(wire.depart().size(), 0);
                wire.now += 49ms;
                QCOMPARE(wire.depart().size(), 0);
                wire.now += 151ms;
                packets = wire.depart();
            }
        }
        QCOMPARE(answers, answersUntilTheEnd);
        QCOMPARE(ending->reply.error().kind, ErrorKind::Refused);
        QCOMPARE(ending->reply.error().addedStatus, code);
        QVERIFY(wire.exchange.isIdle());
    }

    void theCeilingLeavesNoBurst()
    {
        Policy policy;
        policy.requestsPerSecond = 100;
        policy.window = 8;
        Wire wire {policy};
        for (int i = 0; i < 50; ++i)
            wire.read();
        QCOMPARE(wire.depart().size(), 1);
        wire.now += 250ms; // twenty-five slots went by unused
        int left = 0;
        for (const auto &packet : wire.depart()) {
            QVERIFY(wire.answer(packet));
            ++left;
        }
        QVERIFY(left <= 2);
    }

    void aWithdrawnRequestNeverLeaves()
    {
        Wire wire;
        wire.read();
        wire.depart();
        const Ticket queued = wire.order(Effect::Moves);
        wire.exchange.withdraw(queued);
        QCOMPARE(wire.runUntil(wire.now + 60s), 2); // the two repeats of the read
        QCOMPARE(wire.endings.size(), 1U);
    }

    void nobodyWantsItAnyMore()
    {
        Wire wire;
        wire.exchange.isWanted = [](Ticket ticket) { return ticket != 2; };
        wire.read();
        wire.order(Effect::Moves);
        const Ticket third = wire.read();
        QCOMPARE(wire.runUntil(wire.now + 60s), 6);
        QCOMPARE(wire.endings.back().ticket, third);
    }

    void abandonTellsTheTruth()
    {
        Policy policy = Wire::freePolicy();
        policy.window = 2;
        Wire wire {policy};
        wire.order(Effect::Moves);
        wire.read();
        wire.read(Priority::Background);
        QCOMPARE(wire.depart().size(), 2);
        QMap<Ticket, ErrorKind> kinds;
        for (const Ending &ending : wire.exchange.abandon(wire.now))
            kinds[ending.ticket] = ending.reply.error().kind;
        QCOMPARE(kinds.value(1), ErrorKind::UnknownOutcome);
        QCOMPARE(kinds.value(2), ErrorKind::NoAnswer);
        QCOMPARE(kinds.value(3), ErrorKind::NotSent);
        QVERIFY(wire.exchange.isIdle());
    }

    void whatDidNotLeaveIsNotUnknown()
    {
        Wire wire;
        wire.order(Effect::Moves);
        QVERIFY(wire.exchange.depart(wire.now));
        const auto ending =
            wire.exchange.departureFailed({ErrorKind::Network, 0, 0, QStringLiteral("no route")}, wire.now);
        QVERIFY(ending);
        QCOMPARE(ending->reply.error().kind, ErrorKind::NotSent);
        QVERIFY(wire.exchange.isIdle());
    }
};

QTEST_GUILESS_MAIN(TestExchange)
#include "tst_exchange.moc"
