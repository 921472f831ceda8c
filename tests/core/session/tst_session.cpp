// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "session/session.h"
#include "session/udptransport.h"
#include <QSignalSpy>
#include <QTest>
#include <QUdpSocket>

using namespace std::chrono_literals;
using namespace session;
using protocol::ReadStatus;
using values::ErrorKind;
using values::Result;
using values::Status;

namespace {

/// A transport whose other end is the test.
class FakeTransport : public Transport
{
    Q_OBJECT

public:
    Result<void> send(QByteArrayView datagram) override
    {
        packets.append(datagram.toByteArray());
        if (isBroken)
            return values::failure(ErrorKind::Network, QStringLiteral("no route"));
        return {};
    }

    void answer(qsizetype index, QByteArrayView payload)
    {
        const auto request = protocol::parseClientPacket(packets.at(index));
        auto framing = request->framing;
        framing.ack = true;
        framing.block = protocol::lastBlock;
        Q_EMIT received(
            protocol::encode(protocol::Reply {framing, protocol::replyService(request->service), 0, 0, 0, payload}));
    }

    QList<QByteArray> packets;
    bool isBroken = false;
};

Policy impatient()
{
    Policy policy;
    policy.timeout = 20ms;
    policy.controlTimeout = 20ms;
    policy.requestsPerSecond = 0;
    return policy;
}

const QByteArray idleStatus = QByteArray::fromHex("C200000000000000"); // reference §3.4: idle, remote, play, one cycle

} // namespace

class TestSession : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void anAnswerReachesItsHandlerOnce()
    {
        FakeTransport transport;
        Session session {transport, {}};
        QList<Result<Status>> results;
        session.send(ReadStatus {}, this, [&](const Result<Status> &status) { results.append(status); });
        QCOMPARE(results.size(), 0);
        transport.answer(0, idleStatus);
        transport.answer(0, idleStatus);
        QCOMPARE(results.size(), 1);
        QVERIFY(results.first()->isRemote() && results.first()->isPlay());
        QCOMPARE(session.statistics().counters.duplicates, quint64(1));
    }

    void aShortAnswerIsMalformed()
    {
        FakeTransport transport;
        Session session {transport, {}};
        std::optional<Result<Status>> result;
        session.send(ReadStatus {}, this, [&](const Result<Status> &status) { result = status; });
        transport.answer(0, idleStatus.first(7));
        QVERIFY(result && !*result);
        QCOMPARE(result->error().kind, ErrorKind::Malformed);
    }

    void theHandlerNeverRunsInsideSend()
    {
        FakeTransport transport;
        transport.isBroken = true;
        Session session {transport, impatient()};
        int calls = 0;
        session.send(protocol::HoldOff {}, this, [&](const Result<void> &reply) {
            ++calls;
            QCOMPARE(reply.error().kind, ErrorKind::NotSent);
        });
        QCOMPARE(calls, 0);
        QTRY_COMPARE(calls, 1);
    }

    void aReadThatCannotLeaveSaysWhy()
    {
        FakeTransport transport;
        transport.isBroken = true;
        Session session {transport, impatient()};
        std::optional<Result<Status>> result;
        session.send(ReadStatus {}, this, [&](const Result<Status> &status) { result = status; });
        QTRY_VERIFY(result);
        QCOMPARE(result->error(), (values::Error {ErrorKind::Network, 0, 0, QStringLiteral("no route")}));
    }

    void aDeadContextIsNeverCalled()
    {
        FakeTransport transport;
        Session session {transport, {}};
        auto context = std::make_unique<QObject>();
        session.send(ReadStatus {}, context.get(), [](const Result<Status> &) { QFAIL("called"); });
        context.reset();
        transport.answer(0, idleStatus);
    }

    void anOrderWithADeadContextDoesNotLeave()
    {
        FakeTransport transport;
        Session session {transport, impatient()};
        auto context = std::make_unique<QObject>();
        session.send(ReadStatus {}, this, [](const Result<Status> &) {});
        session.send(protocol::HoldOff {}, context.get(), [](const Result<void> &) { QFAIL("called"); });
        QCOMPARE(transport.packets.size(), 1);
        context.reset();
        transport.answer(0, idleStatus);
        bool isAnswered = false;
        session.send(ReadStatus {}, this, [&](const Result<Status> &) { isAnswered = true; });
        QCOMPARE(transport.packets.size(), 2);
        transport.answer(1, idleStatus);
        QVERIFY(isAnswered);
    }

    void silenceEndsByEffect()
    {
        FakeTransport transport;
        Session session {transport, impatient()};
        QSignalSpy unknown {&session, &Session::outcomeUnknown};
        std::optional<ErrorKind> read;
        std::optional<ErrorKind> write;
        session.send(ReadStatus {}, this, [&](const Result<Status> &status) { read = status.error().kind; });
        session.send(protocol::HoldOff {}, this, [&](const Result<void> &reply) { write = reply.error().kind; });
        QTRY_VERIFY(read && write);
        QCOMPARE(*read, ErrorKind::NoAnswer);
        QCOMPARE(*write, ErrorKind::UnknownOutcome);
        QCOMPARE(unknown.count(), 1);
        QCOMPARE(transport.packets.size(), 4); // three tries of the read, one of the write
    }

    void abandonTellsFromTheEventLoop()
    {
        FakeTransport transport;
        Session session {transport, {}};
        int calls = 0;
        session.send(ReadStatus {}, this, [&](const Result<Status> &) { ++calls; });
        session.abandon();
        QCOMPARE(calls, 0);
        QTRY_COMPARE(calls, 1);
    }

    void answersOfStrangersAreCountedOnly()
    {
        QUdpSocket controller;
        QVERIFY(controller.bind(QHostAddress::LocalHost, 0));
        UdpTransport transport {QHostAddress {QHostAddress::LocalHost}, controller.localPort()};
        Policy policy;
        policy.requestsPerSecond = 0;
        policy.timeout = 5s; // the answers decide, not the clock
        Session session {transport, policy};
        std::optional<Result<Status>> result;
        session.send(ReadStatus {}, this, [&](const Result<Status> &status) { result = status; });
        QTRY_VERIFY(controller.hasPendingDatagrams());
        QByteArray request(64, '\0');
        QHostAddress peer;
        quint16 port = 0;
        request.resize(controller.readDatagram(request.data(), request.size(), &peer, &port));
        auto framing = protocol::parseClientPacket(request)->framing;
        framing.ack = true;
        const QByteArray reply = protocol::encode(protocol::Reply {framing, 0x81, 0, 0, 0, idleStatus});
        QUdpSocket stranger;
        stranger.writeDatagram(reply, peer, port);
        QTRY_COMPARE(session.statistics().counters.strangers, quint64(1));
        QVERIFY(!result);
        controller.writeDatagram(reply, peer, port);
        QTRY_VERIFY(result);
        QVERIFY(result->has_value());
    }
};

QTEST_GUILESS_MAIN(TestSession)
#include "tst_session.moc"
