// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "session/transfer.h"
#include <QTest>

using namespace std::chrono_literals;
using namespace session;
using protocol::lastBlock;
using protocol::Reply;
using protocol::Service;
using values::ErrorKind;

namespace {

constexpr quint8 id = 3;

/// A transfer and what its controller answers, with a clock that stands until it is moved.
class Wire
{
public:
    explicit Wire(const protocol::Request &request, const QByteArray &upload = {})
        : m_retransmission {policy.timeout / 2, policy.repeatFloor},
          m_service {request.service},
          transfer {request, id, policy, m_retransmission, upload}
    {
    }

    /// The controller sends a block, or acknowledges one.
    Transfer::Step answer(quint32 block, const QByteArray &payload = {})
    {
        const Reply reply {
            {protocol::Division::File, true, id, block}, protocol::replyService(m_service), 0, 0, 0, payload};
        return transfer.receive(reply, now);
    }

    /// Nobody answers: what is sent until the end, and how it ends.
    std::pair<QByteArrayList, ErrorKind> silence()
    {
        QByteArrayList packets;
        for (;;) {
            now = transfer.deadline();
            const auto step = transfer.expire(now);
            if (!step.packet.isEmpty())
                packets << step.packet;
            if (step.end)
                return {packets, step.end->error().kind};
        }
    }

    FilePolicy policy;
    Time now {1h};

private:
    Retransmission m_retransmission;
    Service m_service;

public:
    Transfer transfer;
};

values::FileName name(const char *text) { return *values::FileName::create(text); }

} // namespace

/// One file service without a socket and without a clock.
class TestTransfer : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void silenceAfterTheRequest_data()
    {
        QTest::addColumn<QByteArray>("service");
        QTest::addColumn<int>("repeats");
        QTest::addColumn<ErrorKind>("error");
        QTest::newRow("list") << QByteArray("list") << 1 << ErrorKind::NoAnswer;
        QTest::newRow("save") << QByteArray("save") << 1 << ErrorKind::NoAnswer;
        QTest::newRow("load") << QByteArray("load") << 0 << ErrorKind::NoAnswer; // nothing of it was sent
        QTest::newRow("delete") << QByteArray("delete") << 0 << ErrorKind::UnknownOutcome;
    }

    void silenceAfterTheRequest()
    {
        QFETCH(QByteArray, service);
        QFETCH(int, repeats);
        QFETCH(ErrorKind, error);
        const auto request = service == "list" ? protocol::listFiles("*.JBI")
            : service == "save"                ? protocol::saveFile(name("A.JBI"))
            : service == "load"                ? protocol::loadFile(name("A.JBI"))
                                               : protocol::deleteFile(name("A.JBI"));
        Wire wire {request, service == "load" ? QByteArray("NOP\r\n") : QByteArray {}};
        const QByteArray sent = wire.transfer.start(wire.now);
        const auto [packets, kind] = wire.silence();
        QCOMPARE(packets, QByteArrayList(repeats, sent));
        QCOMPARE(kind, error);
    }

    void aBlockIsRepeatedOnceByItsNumber()
    {
        Wire wire {protocol::loadFile(name("A.JBI")), QByteArray(1000, 'x')};
        (void)wire.transfer.start(wire.now);
        const QByteArray first = wire.answer(0).packet;
        QCOMPARE(protocol::parseClientPacket(first)->framing.block, 1U);
        const auto [packets, kind] = wire.silence();
        QCOMPARE(packets, QByteArrayList {first});
        QCOMPARE(kind, ErrorKind::NoAnswer); // the last block was not sent, so nothing was taken over
    }

    void theLastBlockMayHaveArrived()
    {
        Wire wire {protocol::loadFile(name("A.JBI")), QByteArray(10, 'x')};
        (void)wire.transfer.start(wire.now);
        (void)wire.answer(0);
        const auto [packets, kind] = wire.silence();
        QCOMPARE(packets.size(), 1);
        QCOMPARE(kind, ErrorKind::UnknownOutcome);
    }

    void endlessTransfersEnd_data()
    {
        QTest::addColumn<QByteArray>("what");
        QTest::addColumn<qsizetype>("limit");
        QTest::newRow("list") << QByteArray("*.JBI") << protocol::listLimit;
        QTest::newRow("job") << QByteArray("A.JBI") << protocol::jobLimit;
        QTest::newRow("file") << QByteArray("ALL.PRM") << protocol::fileLimit;
    }

    /// No block is marked as the last one.
    void endlessTransfersEnd()
    {
        QFETCH(QByteArray, what);
        QFETCH(qsizetype, limit);
        Wire wire {what.startsWith('*') ? protocol::listFiles(what) : protocol::saveFile(name(what.constData()))};
        (void)wire.transfer.start(wire.now);
        const QByteArray block(479, 'x');
        quint32 number = 1;
        auto step = wire.answer(number, block);
        while (!step.end && number < lastBlock)
            step = wire.answer(++number, block);
        QVERIFY(step.end && step.packet.isEmpty()); // and it is not acknowledged
        QCOMPARE(step.end->error().kind, ErrorKind::Malformed);
        QVERIFY(wire.transfer.bytesDone() <= limit);
        QVERIFY(wire.transfer.bytesDone() > limit - 479);
    }

    void anEmptyBlockIsNone()
    {
        Wire wire {protocol::saveFile(name("A.JBI"))};
        (void)wire.transfer.start(wire.now);
        QVERIFY(!wire.answer(1, "NOP").end);
        const auto step = wire.answer(2);
        QVERIFY(step.end && step.packet.isEmpty());
        QCOMPARE(step.end->error().kind, ErrorKind::Malformed);
    }

    void anEmptyFileIsEmpty()
    {
        Wire wire {protocol::saveFile(name("A.DAT"))};
        (void)wire.transfer.start(wire.now);
        const auto step = wire.answer(1 | lastBlock);
        QVERIFY(step.end && *step.end);
        QCOMPARE(**step.end, QByteArray {});
    }

    void gettingNowhereEnds_data()
    {
        QTest::addColumn<int>("bytes"); // in each block, of which one comes every 2 s
        QTest::addColumn<bool>("ends");
        QTest::newRow("a byte at a time") << 1 << true; // 30 in a minute
        QTest::newRow("slow, and yet") << 100 << false; // 3,000 in a minute
    }

    void gettingNowhereEnds()
    {
        QFETCH(int, bytes);
        QFETCH(bool, ends);
        Wire wire {protocol::saveFile(name("A.JBI"))};
        (void)wire.transfer.start(wire.now);
        std::optional<values::Result<QByteArray>> end;
        for (quint32 number = 1; number <= 100 && !end; ++number) {
            wire.now += 2s;
            end = wire.answer(number, QByteArray(bytes, 'x')).end;
        }
        QCOMPARE(end.has_value(), ends);
    }
};

QTEST_GUILESS_MAIN(TestTransfer)
#include "tst_transfer.moc"
