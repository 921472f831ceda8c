// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "traffic/replay.h"

#include <QTest>

using namespace traffic;
using namespace std::chrono_literals;
using protocol::Division;
using protocol::Service;

namespace {

/// Writes down what passed, as a log would.
class Recording
{
public:
    void sent(const QByteArray &bytes, Division division = Division::Robot, Fate fate = Fate::Used)
    {
        add(bytes, Passage::Sent, division, fate);
    }
    void received(const QByteArray &bytes, Division division = Division::Robot, Fate fate = Fate::Used)
    {
        add(bytes, Passage::Received, division, fate);
    }

    QList<Packet> packets;

private:
    void add(const QByteArray &bytes, Passage passage, Division division, Fate fate)
    {
        const auto number = quint64(packets.size() + 1);
        packets << Packet {number, WallTime {number * 2ms}, passage, division, fate, {}, {}, 0, bytes};
    }
};

QByteArray request(quint8 id, quint16 instance)
{
    return protocol::encode(
        protocol::Request {0x7A, instance, 1, Service::GetSingle, {}}, {Division::Robot, false, id, 0});
}

QByteArray reply(quint8 id, char value)
{
    return protocol::encode(
        protocol::Reply {{Division::Robot, true, id, protocol::lastBlock}, 0x8E, 0, 0, 0, QByteArray(1, value)});
}

QByteArray fileRequest(quint8 id, const QByteArray &name)
{
    return protocol::encode(protocol::Request {0, 0, 0, Service::SaveFile, name}, {Division::File, false, id, 0});
}

QByteArray block(quint8 id, quint32 number, const QByteArray &data)
{
    return protocol::encode(protocol::Reply {{Division::File, true, id, number}, 0x96, 0, 0, 0, data});
}

QByteArray acknowledgement(quint8 id, quint32 number)
{
    return protocol::encode(protocol::Request {0, 0, 0, Service::SaveFile, {}}, {Division::File, true, id, number});
}

} // namespace

class TestReplay : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void theSameRequestsGetTheRecordedReplies()
    {
        Recording recording;
        recording.sent(request(1, 5));
        recording.received(reply(1, 'a'));
        recording.sent(request(2, 6));
        recording.received(reply(2, 'x'));
        recording.sent(request(3, 5));
        recording.received(reply(3, 'b'));
        Replay replay {recording.packets};
        QCOMPARE(replay.size(), std::size_t {2});
        QCOMPARE(replay.answer(Division::Robot, request(200, 5))->packet, reply(200, 'a'));
        QCOMPARE(replay.answer(Division::Robot, request(201, 5))->packet, reply(201, 'b'));
        QCOMPARE(replay.answer(Division::Robot, request(202, 5))->packet, reply(202, 'b')); // the last one for ever
        QCOMPARE(replay.answer(Division::Robot, request(203, 6))->packet, reply(203, 'x'));
        QCOMPARE(replay.answer(Division::Robot, request(203, 6))->delay, 2ms);
    }

    void whatWasNeverAskedIsRefused()
    {
        Replay replay {{}};
        const auto answer = replay.answer(Division::Robot, request(9, 5));
        const auto refusal = protocol::parseReply(answer->packet);
        QVERIFY(refusal);
        QCOMPARE(refusal->framing.id, quint8 {9});
        QCOMPARE(refusal->status, quint8 {0x1F});
        QCOMPARE(refusal->addedStatus, quint16 {0x2110});
    }

    void whatWasNeverAnsweredStaysSo()
    {
        Recording recording;
        recording.sent(request(1, 5));
        Replay replay {recording.packets};
        QVERIFY(!replay.answer(Division::Robot, request(2, 5)));
    }

    void whatWasDroppedOrRepeatedIsNoAnswer()
    {
        Recording recording;
        recording.sent(request(1, 5));
        recording.received(reply(1, 's'), Division::Robot, Fate::Stranger);
        recording.sent(request(1, 5), Division::Robot, Fate::Repeat);
        recording.received(reply(1, 'a'));
        recording.received(reply(1, 'd'), Division::Robot, Fate::Duplicate);
        Replay replay {recording.packets};
        QCOMPARE(replay.answer(Division::Robot, request(2, 5))->packet, reply(2, 'a'));
        QCOMPARE(replay.answer(Division::Robot, request(3, 5))->packet, reply(3, 'a'));
    }

    void whatIsNoPacketIsNotAnswered()
    {
        Replay replay {{}};
        QVERIFY(!replay.answer(Division::Robot, "hello"));
        QVERIFY(!replay.answer(Division::File, QByteArray(40, '\0')));
    }

    void aDownloadGoesOnBlockByBlock()
    {
        constexpr quint32 last = protocol::lastBlock;
        Recording recording;
        recording.sent(fileRequest(1, "A.JBI"), Division::File);
        recording.received(block(1, 1, "one"), Division::File);
        recording.sent(acknowledgement(1, 1), Division::File);
        recording.received(block(1, 2 + last, "two"), Division::File);
        recording.sent(acknowledgement(1, 2 + last), Division::File);
        Replay replay {recording.packets};
        QCOMPARE(replay.answer(Division::File, fileRequest(9, "A.JBI"))->packet, block(9, 1, "one"));
        QCOMPARE(replay.answer(Division::File, acknowledgement(9, 1))->packet, block(9, 2 + last, "two"));
        QCOMPARE(replay.answer(Division::File, acknowledgement(9, 1))->packet, block(9, 2 + last, "two")); // a repeat
        QVERIFY(!replay.answer(Division::File, acknowledgement(9, 2 + last))); // nothing follows (reference §7.3)
        QVERIFY(!replay.answer(Division::File, acknowledgement(10, 1))); // nobody's transfer
        QCOMPARE(replay.answer(Division::File, fileRequest(11, "A.JBI"))->packet, block(11, 1, "one"));
    }
};

QTEST_APPLESS_MAIN(TestReplay)
#include "tst_replay.moc"
