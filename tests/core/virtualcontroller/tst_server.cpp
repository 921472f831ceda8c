// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "protocol/requests.h"
#include "virtualcontroller/server.h"
#include <QNetworkDatagram>
#include <QTest>
#include <QUdpSocket>

using namespace virtualcontroller;

class ServerTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void answersFromTheAddressedPort();
    void saysWhenAPortIsTaken();
    void showsADemoThatMoves();

private:
    static Options onFreePorts(std::function<Time()> clock = {})
    {
        Options options;
        options.port = options.filePort = 0;
        options.clock = std::move(clock);
        return options;
    }
    /// The reply to `request` from the port it was sent to; an empty one if none came.
    static QNetworkDatagram ask(QUdpSocket &client, quint16 port, const protocol::Request &request)
    {
        client.writeDatagram(
            protocol::encode(request, {protocol::Division::Robot, false, 7, 0}), QHostAddress::LocalHost, port);
        return QTest::qWaitFor([&] { return client.hasPendingDatagrams(); }) ? client.receiveDatagram()
                                                                             : QNetworkDatagram {};
    }
};

void ServerTest::answersFromTheAddressedPort()
{
    Server server {onFreePorts()};
    QVERIFY(server.start());
    QUdpSocket client;
    QVERIFY(client.bind(QHostAddress::LocalHost));
    const auto reply = ask(client, server.port(), protocol::ReadStatus {}.request());
    QCOMPARE(reply.senderPort(), int(server.port()));
    // reference §1.5: remote, play, one cycle
    QCOMPARE(reply.data().toHex(),
        QByteArray("594552432000080003010107000000803939393939393939"
                   "8100000000000000c200000000000000"));
}

void ServerTest::saysWhenAPortIsTaken()
{
    Server first {onFreePorts()};
    QVERIFY(first.start());
    Options options = onFreePorts();
    options.filePort = first.filePort();
    Server second {options};
    const auto started = second.start();
    QVERIFY(!started);
    QVERIFY(started.error().detail.contains(QString::number(first.filePort())));
    QCOMPARE(second.port(), quint16(0));
}

void ServerTest::showsADemoThatMoves()
{
    Time now = 0ms;
    Server server {onFreePorts([&] { return now; })};
    server.memory() = Memory::demo();
    QVERIFY(server.start());
    QUdpSocket client;
    QVERIFY(client.bind(QHostAddress::LocalHost));
    const auto ask75 = protocol::ReadPosition {values::ControlGroup::robotCartesian(1)};
    QSet<QByteArray> seen;
    for (now = 0ms; now < 10s; now += 500ms)
        seen.insert(ask(client, server.port(), ask75.request()).data());
    QVERIFY(seen.size() > 5);
    const auto status = ask(client, server.port(), protocol::ReadStatus {}.request()).data();
    QCOMPARE(status.last(8).toHex(), QByteArray("cc00000040000000"));
}

QTEST_GUILESS_MAIN(ServerTest)
#include "tst_server.moc"
