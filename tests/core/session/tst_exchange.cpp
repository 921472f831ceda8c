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
    /// There is always one more request of a page; what waits behind it still gets its turns.
    void aBusyPageDoesNotStarveTheBackground()
    {
        Wire wire {Policy {}}; // 100 requests a second
        for (int i = 0; i < 50; ++i)
            wire.exchange.submit(protocol::ReadAlarm {1}.request(), Effect::Reads, Priority::Background, wire.now);
        int ofPage = 0;
        int ofBackground = 0;
        for (const Time end = wire.now + 1s; wire.now < end; wire.now += 1ms) {
            wire.read();
            for (const QByteArray &packet : wire.depart()) {
                const bool isOfPage = protocol::parseClientPacket(packet)->command == 0x72;
                ++(isOfPage ? ofPage : ofBackground);
                (void)wire.answer(packet);
            }
        }
        QCOMPARE(ofBackground, 19); // one in each 50 ms, the first after it has waited so long
        QCOMPARE(ofPage + ofBackground, 100);
    }

    void triesByEffect_data()
    {
        QTest::addColumn<Effect>("effect");
        QTest::addColumn<Priority>("priority");
        QTest::addColumn<int>("leastTries");
        QTest::addColumn<int>("mostTries");
        QTest::addColumn<ErrorKind>("error");
        // silence, nothing measured: a read waits 300 ms three times; a stop goes on for 2 s, every 40 ms, and so does
        // the read that goes with it
        QTest::newRow("read") << Effect::Reads << Priority::Page << 3 << 3 << ErrorKind::NoAnswer;
        QTest::newRow("stop") << Effect::Stops << Priority::Stop << 50 << 50 << ErrorKind::NoAnswer;
        QTest::newRow("status of a stop") << Effect::Reads << Priority::Stop << 50 << 50 << ErrorKind::NoAnswer;
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

    /// Whatever the link has done so far: no wait grows, and 60 of 60 arrive where nine of ten packets are lost.
    void stopsArriveThroughHeavyLoss()
    {
        Wire wire;
        std::minstd_rand random {60};
        std::bernoulli_distribution isLost {0.9};
        int arrived = 0;
        for (int i = 0; i < 60; ++i) {
            wire.order(Effect::Stops, Priority::Stop);
            bool hasArrived = false;
            for (const Time end = wire.now + 2s; wire.now < end; wire.now += 40ms) {
                const auto tries = wire.depart();
                QCOMPARE(tries.size(), hasArrived ? 0 : 1);
                if (hasArrived || isLost(random))
                    continue;
                hasArrived = true;
                QVERIFY(wire.answer(tries.first()));
            }
            arrived += hasArrived;
            wire.runUntil(wire.now + 10s);
        }
        QCOMPARE(arrived, 60);
    }

    void nothingGoesBeforeAStop()
    {
        Wire wire;
        wire.read();
        QCOMPARE(wire.depart().size(), 1);
        wire.now += 300ms; // the read is due again
        wire.order(Effect::Stops, Priority::Stop);
        const auto packets = wire.depart();
        QCOMPARE(packets.size(), 2);
        QCOMPARE(protocol::parseClientPacket(packets.first())->command, quint16(0x83));
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

    void anIdRestsWhileAnAnswerCouldCome_data()
    {
        QTest::addColumn<bool>("isAnswered");
        QTest::newRow("answered") << true; // a second copy of the answer may still come
        QTest::newRow("silence") << false;
    }

    void anIdRestsWhileAnAnswerCouldCome()
    {
        QFETCH(bool, isAnswered);
        Policy policy = Wire::freePolicy();
        policy.timeout = 1ms;
        policy.repeats = 0;
        policy.idLinger = 2s;
        policy.window = 8;
        Wire wire {policy, 250};
        std::map<quint8, Time> ended;
        for (int i = 0; i < 1000; ++i) {
            wire.read();
            auto packets = wire.depart();
            if (packets.isEmpty()) {
                wire.now = *wire.exchange.nextDeadline(wire.now);
                packets = wire.depart();
            }
            QCOMPARE(packets.size(), 1);
            const quint8 id = idOf(packets.first());
            if (const auto before = ended.find(id); before != ended.end())
                QVERIFY(wire.now - before->second >= 2s);
            if (isAnswered)
                QVERIFY(wire.answer(packets.first()));
            else
                wire.runUntil(wire.now + 1ms);
            ended[id] = wire.now;
        }
        QCOMPARE(ended.size(), 256U);
    }

    /// 1,000 requests a second are wanted; every answer comes a second time, up to 1.9 s later, and every other write
    /// is lost on its way. Each read must bring its own register, and no lost write may be taken for done.
    void lateDuplicatesAnswerNobodyElse()
    {
        Policy policy = Wire::freePolicy();
        policy.requestsPerSecond = 1000;
        policy.window = 8;
        Wire wire {policy};
        std::minstd_rand random {7};
        std::multimap<Time, QByteArray> inTheAir;
        std::map<Ticket, int> asked; // the register, or -1 for a lost write
        int wrong = 0;
        int falselyDone = 0;
        int ended = 0;
        int isLost = 0;
        const auto submit = [&](int i) {
            if (i % 10)
                asked[wire.exchange.submit({0x79, quint16(i % 1000), 1, protocol::Service::GetSingle, {}},
                    Effect::Reads, Priority::Page, wire.now)] = i % 1000;
            else
                asked[wire.exchange.submit({0x79, 5, 1, protocol::Service::SetSingle, QByteArray(2, '\1')},
                    Effect::Writes, Priority::Control, wire.now)] = -1;
        };
        const auto answerLater = [&](const protocol::ClientPacket &packet) {
            QByteArray payload;
            if (packet.service == protocol::Service::GetSingle)
                payload = QByteArray::number(packet.instance);
            else if (isLost++ % 2)
                return;
            const QByteArray reply = protocol::encode(
                protocol::Reply {{protocol::Division::Robot, true, packet.framing.id, protocol::lastBlock},
                    protocol::replyService(packet.service), 0, 0, 0, payload});
            inTheAir.emplace(wire.now + 2ms, reply);
            inTheAir.emplace(wire.now + std::chrono::milliseconds {int(random() % 1900)}, reply);
        };
        const auto judge = [&](const Ending &ending) {
            const int expected = asked.at(ending.ticket);
            ++ended;
            if (expected >= 0 && ending.reply)
                wrong += ending.reply->payload.toByteArray() != QByteArray::number(expected);
            falselyDone += expected < 0 && ending.reply.has_value();
        };
        constexpr int requests = 4000;
        for (int i = 0; ended < requests; ++i) {
            if (i < requests)
                submit(i);
            while (const auto departure = wire.exchange.depart(wire.now))
                answerLater(*protocol::parseClientPacket(departure->packet));
            wire.now += 1ms;
            while (!inTheAir.empty() && inTheAir.begin()->first <= wire.now) {
                if (const auto ending = wire.exchange.receive(inTheAir.begin()->second, wire.now))
                    judge(*ending);
                inTheAir.erase(inTheAir.begin());
            }
            for (const Ending &ending : wire.exchange.expire(wire.now))
                judge(ending);
        }
        QCOMPARE(wrong, 0);
        QCOMPARE(falselyDone, (isLost + 1) / 2); // those whose own answer came
    }

    void repeatsDoubleToTheDeadline_data()
    {
        QTest::addColumn<int>("gap"); // ms without a packet in either direction
        QTest::addColumn<int>("answered"); // ms after the first try; -1: not
        // tries at 0, 20, 60, 140, 300 and then each time-out of 300 ms; the end is at 900 ms
        QTest::newRow("10 ms") << 10 << 20;
        QTest::newRow("50 ms") << 50 << 60;
        QTest::newRow("61 ms") << 61 << 140;
        QTest::newRow("141 ms") << 141 << 300;
        QTest::newRow("500 ms") << 500 << 600;
        QTest::newRow("900 ms") << 900 << -1;
    }

    void repeatsDoubleToTheDeadline()
    {
        QFETCH(int, gap);
        QFETCH(int, answered);
        Wire wire;
        wire.read();
        const auto first = wire.depart();
        wire.now += 2ms;
        QVERIFY(wire.answer(first.first())); // the link is measured
        wire.read();
        const Time begun = wire.now;
        int after = -1;
        for (; after < 0 && !wire.exchange.isIdle(); wire.now += 1ms) {
            wire.endings = wire.exchange.expire(wire.now);
            const auto packets = wire.depart();
            if (!packets.isEmpty() && wire.now - begun >= std::chrono::milliseconds {gap}
                && wire.answer(packets.first()))
                after = int((wire.now - begun) / 1ms);
        }
        QCOMPARE(after, answered);
    }

    /// 15 of 100 packets are lost in each direction.
    void aLossyLinkFailsHardlyAnyRead()
    {
        Wire wire;
        std::minstd_rand random {20};
        const auto isLost = [&random] { return random() % 100 < 15; };
        constexpr int reads = 5000;
        int failures = 0;
        for (int i = 0; i < reads; ++i) {
            wire.read();
            while (!wire.exchange.isIdle()) {
                for (const QByteArray &packet : wire.depart()) {
                    if (!isLost() && !isLost())
                        QVERIFY(wire.answer(packet));
                }
                failures += int(wire.exchange.expire(wire.now).size());
                wire.now = wire.exchange.nextDeadline(wire.now).value_or(wire.now + 10ms);
            }
        }
        QVERIFY2(failures * 200 < reads, QByteArray::number(failures)); // six tries, of which each fails in 28 of 100
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
        QCOMPARE(wire.exchange.counters().requests, quint64(256 - IdPool::keptForStops));
        QSet<quint8> ids;
        for (std::size_t i = 0; i < IdPool::keptForStops; ++i) {
            wire.order(Effect::Stops, Priority::Stop);
            const auto packets = wire.depart();
            QCOMPARE(packets.size(), 1);
            ids.insert(idOf(packets.first()));
        }
        QCOMPARE(ids.size(), qsizetype(IdPool::keptForStops));
        wire.order(Effect::Stops, Priority::Stop); // even then: the one that has rested longest
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
