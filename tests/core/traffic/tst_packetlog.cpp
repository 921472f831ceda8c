// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "traffic/packetlog.h"

#include <QTest>

using namespace traffic;
using protocol::Division;
using protocol::Service;

namespace {

QByteArray request(quint8 id, quint16 instance = 1)
{
    return protocol::encode(
        protocol::Request {0x72, instance, 0, Service::GetAll, {}}, {Division::Robot, false, id, 0});
}

QByteArray reply(quint8 id, const QByteArray &payload = QByteArray(8, '\1'))
{
    return protocol::encode(protocol::Reply {{Division::Robot, true, id, protocol::lastBlock}, 0x81, 0, 0, 0, payload});
}

PacketLog::Note sent(Division division = Division::Robot)
{
    return {WallTime {}, Passage::Sent, division, {}, {0x7F000001, 10040}};
}

PacketLog::Note received(Fate fate = Fate::Used)
{
    return {WallTime {}, Passage::Received, Division::Robot, {}, {0x7F000001, 10040}, fate};
}

} // namespace

class TestPacketLog : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void aReplyKnowsItsRequest()
    {
        PacketLog log;
        const quint64 first = log.note(sent(), request(7));
        log.note(sent(), request(8));
        const quint64 answer = log.note(received(), reply(7));
        QCOMPARE(log.packet(answer)->partner, first);
        QCOMPARE(log.packet(answer)->bytes, reply(7));
        QCOMPARE(log.packet(answer)->fate, Fate::Used);
    }

    void theSameBytesAgainAreARepeat()
    {
        PacketLog log;
        const quint64 first = log.note(sent(), request(7));
        const quint64 again = log.note(sent(), request(7));
        QCOMPARE(log.packet(again)->fate, Fate::Repeat);
        QCOMPARE(log.packet(again)->partner, first);
        const quint64 answer = log.note(received(), reply(7));
        QCOMPARE(log.packet(answer)->partner, first);
    }

    void anIdThatCameRoundBelongsToTheLatest()
    {
        PacketLog log;
        log.note(sent(), request(7, 1));
        const quint64 second = log.note(sent(), request(7, 2));
        QCOMPARE(log.packet(second)->fate, Fate::Used);
        QCOMPARE(log.packet(log.note(received(), reply(7)))->partner, second);
    }

    void thePortsHaveIdsOfTheirOwn()
    {
        PacketLog log;
        log.note(sent(Division::File), request(7));
        QCOMPARE(log.packet(log.note(received(), reply(7)))->partner, quint64 {0});
    }

    void whatWasDroppedSaysWhy()
    {
        PacketLog log;
        log.note(sent(), request(7));
        const quint64 stranger = log.note(received(Fate::Stranger), reply(7));
        QCOMPARE(log.packet(stranger)->partner, quint64 {0});
        const quint64 late = log.note(received(), reply(7));
        log.setFate(late, Fate::Late);
        QCOMPARE(log.packet(late)->fate, Fate::Late);
        QCOMPARE(log.packet(late)->partner, quint64 {0});
        const quint64 twice = log.note(received(), reply(7));
        log.setFate(twice, Fate::Duplicate);
        QCOMPARE(log.packet(twice)->partner, quint64 {1});
    }

    void shortAndLongDatagramsAreKept_data()
    {
        QTest::addColumn<qsizetype>("size");
        QTest::addColumn<qsizetype>("kept");
        for (const qsizetype size : {0, 1, 11, 12, 31, 32, 511, 2047, 2048})
            QTest::addRow("%d bytes", int(size)) << size << size;
        QTest::addRow("more than any packet") << qsizetype {65507} << qsizetype {2048};
    }
    void shortAndLongDatagramsAreKept()
    {
        QFETCH(qsizetype, size);
        QFETCH(qsizetype, kept);
        PacketLog log;
        const QByteArray bytes(size, 'x');
        QCOMPARE(log.packet(log.note(received(Fate::Malformed), bytes))->bytes, bytes.left(kept));
    }

    void theOldestGo_data()
    {
        QTest::addColumn<std::size_t>("packets");
        QTest::addColumn<std::size_t>("bytes");
        QTest::addColumn<int>("size");
        QTest::addColumn<std::size_t>("least"); ///< That must still be here after 100,000.
        QTest::addRow("by number") << std::size_t {1000} << std::size_t {1 << 20} << 40 << std::size_t {1000};
        QTest::addRow("one alone") << std::size_t {1} << std::size_t {1 << 20} << 40 << std::size_t {1};
        QTest::addRow("by bytes") << std::size_t {1000} << std::size_t {64 * 1024} << 500 << std::size_t {120};
        QTest::addRow("an odd size") << std::size_t {20000} << std::size_t {10007} << 101 << std::size_t {90};
    }
    void theOldestGo()
    {
        QFETCH(std::size_t, packets);
        QFETCH(std::size_t, bytes);
        QFETCH(int, size);
        QFETCH(std::size_t, least);
        PacketLog log {{packets, bytes}};
        const auto content = [size](quint64 number) {
            QByteArray text = QByteArray::number(number);
            return text + QByteArray(size - text.size(), '.');
        };
        for (quint64 number = 1; number <= 100'000; ++number)
            QCOMPARE(log.note(received(Fate::Malformed), content(number)), number);
        QCOMPARE(log.end(), quint64 {100'001});
        QVERIFY2(log.size() >= least && log.size() <= packets, qPrintable(QString::number(log.size())));
        QCOMPARE(log.packets().size(), qsizetype(log.size()));
        for (const Packet &packet : log.packets())
            QCOMPARE(packet.bytes, content(packet.number));
        QVERIFY(!log.packet(log.first() - 1));
        QVERIFY(!log.packet(log.end()));
    }

    void aRequestThatIsGoneIsNobodysPartner()
    {
        PacketLog log {{2, 1 << 16}};
        log.note(sent(), request(1));
        log.note(sent(), request(2));
        const quint64 answer = log.note(received(), reply(1)); // pushes its request out
        QCOMPARE(log.packet(answer)->partner, quint64 {0});
        QCOMPARE(log.size(), std::size_t {2});
    }

    void clearingForgetsAll()
    {
        PacketLog log;
        log.note(sent(), request(1));
        log.clear();
        QVERIFY(log.packets().isEmpty());
        QCOMPARE(log.packet(log.note(received(), reply(1)))->partner, quint64 {0});
    }
};

QTEST_APPLESS_MAIN(TestPacketLog)
#include "tst_packetlog.moc"
