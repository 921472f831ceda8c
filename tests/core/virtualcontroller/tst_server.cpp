// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "protocol/requests.h"
#include "virtualcontroller/alarms.h"
#include "virtualcontroller/server.h"
#include <QNetworkDatagram>
#include <QSet>
#include <QTest>
#include <QUdpSocket>
#include <array>

using namespace virtualcontroller;

namespace {

Options onFreePorts(std::function<Time()> clock = {})
{
    Options options;
    options.port = options.filePort = 0;
    options.clock = std::move(clock);
    return options;
}

/// A socket that asks and waits.
class Client
{
public:
    Client() { m_socket.bind(QHostAddress::LocalHost); }

    void send(quint16 port, const QByteArray &bytes) { m_socket.writeDatagram(bytes, QHostAddress::LocalHost, port); }
    void send(quint16 port, const protocol::Request &request, quint8 id = 7)
    {
        send(port, protocol::encode(request, {protocol::Division::Robot, false, id, 0}));
    }
    /// The next datagram; an invalid one if none comes.
    QNetworkDatagram receive(int timeout = 5000)
    {
        return QTest::qWaitFor([this] { return m_socket.hasPendingDatagrams(); }, timeout) ? m_socket.receiveDatagram()
                                                                                           : QNetworkDatagram {};
    }
    QNetworkDatagram ask(quint16 port, const protocol::Request &request)
    {
        send(port, request);
        return receive();
    }

private:
    QUdpSocket m_socket;
};

const protocol::Request status = protocol::ReadStatus {}.request();

} // namespace

class ServerTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void answersFromTheAddressedPort();
    void saysWhyItCannotStart();
    void showsADemoThatMoves();
    void answersServoOnWithPower_data();
    void answersServoOnWithPower();
    void answersEachClient();
    void answersManyAtOnce();
    void listensAfterABurst();
    void servesFiles();
    void countsWhatArrivesBeforeFaults();
    void keepsSilent();
    void restarts();
    void refusesWithoutExecuting();
    void ignoresWhatIsTooShort();
    void stopsAndStartsAgain();
};

void ServerTest::answersFromTheAddressedPort()
{
    Server server {onFreePorts()};
    QVERIFY(server.start());
    Client client;
    const auto reply = client.ask(server.port(), status);
    QCOMPARE(reply.senderPort(), int(server.port()));
    // reference §1.5: remote, play, one cycle
    QCOMPARE(reply.data().toHex(),
        QByteArray("594552432000080003010107000000803939393939393939"
                   "8100000000000000c200000000000000"));
}

void ServerTest::saysWhyItCannotStart()
{
    Server first {onFreePorts()};
    QVERIFY(first.start());
    Options options = onFreePorts();
    options.filePort = first.filePort();
    Server second {options};
    const auto started = second.start();
    QVERIFY(!started);
    QCOMPARE(started.error().kind, values::ErrorKind::Network);
    QVERIFY(started.error().detail.contains(QString::number(first.filePort())));
    QCOMPARE(second.port(), quint16(0));
    options.address = QStringLiteral("nowhere");
    QCOMPARE(Server {options}.start().error().detail, QStringLiteral("nowhere is not an IP address."));
}

void ServerTest::showsADemoThatMoves()
{
    Time now = 0ms;
    Server server {onFreePorts([&] { return now; })};
    server.setMemory(Memory::demo());
    QVERIFY(server.start());
    Client client;
    const auto position = protocol::ReadPosition {values::ControlGroup::robotCartesian(1)}.request();
    QSet<QByteArray> seen;
    for (now = 0ms; now < 10s; now += 500ms)
        seen.insert(client.ask(server.port(), position).data());
    QVERIFY(seen.size() > 5);
    QCOMPARE(client.ask(server.port(), status).data().last(8).toHex(), QByteArray("cc00000040000000"));
}

/// Reference §0.1 h: the reply comes when power is on, and other requests are answered meanwhile.
void ServerTest::answersServoOnWithPower_data()
{
    QTest::addColumn<bool>("isAlarmRaised");
    QTest::addColumn<quint16>("code");
    QTest::newRow("power comes") << false << quint16(0);
    QTest::newRow("an alarm comes first") << true << quint16(0x3450);
}

void ServerTest::answersServoOnWithPower()
{
    QFETCH(bool, isAlarmRaised);
    QFETCH(quint16, code);
    Time now = 0ms;
    Server server {onFreePorts([&] { return now; })};
    QVERIFY(server.start());
    Client client;
    client.send(server.port(), protocol::ServoOn {}.request(), 7);
    client.send(server.port(), status, 8);
    QCOMPARE(protocol::parseReply(client.receive().data())->framing.id, quint8(8));
    now = 599ms;
    client.send(server.port(), status, 9);
    QCOMPARE(protocol::parseReply(client.receive().data())->framing.id, quint8(9));
    if (isAlarmRaised)
        raiseAlarm(server.memory(), 1000, "MAJOR");
    now = 600ms;
    server.advanceToNow();
    const QByteArray reply = client.receive().data();
    QCOMPARE(protocol::parseReply(reply)->framing.id, quint8(7));
    QCOMPARE(protocol::parseReply(reply)->addedStatus, code);
    QCOMPARE(server.memory().status.isServoOn(), !isAlarmRaised);
}

void ServerTest::answersEachClient()
{
    Server server {onFreePorts()};
    QVERIFY(server.start());
    std::array<Client, 8> clients;
    for (std::size_t number = 0; number < clients.size(); ++number)
        clients[number].send(server.port(), status, quint8(100 + number));
    for (std::size_t number = 0; number < clients.size(); ++number) {
        const QByteArray reply = clients[number].receive().data();
        QCOMPARE(protocol::parseReply(reply)->framing.id, quint8(100 + number));
    }
}

void ServerTest::answersManyAtOnce()
{
    Server server {onFreePorts()};
    QVERIFY(server.start());
    Client client;
    for (int number = 0; number < 50; ++number)
        client.send(server.port(), status, quint8(number));
    for (int number = 0; number < 50; ++number) {
        const QByteArray reply = client.receive().data();
        QCOMPARE(protocol::parseReply(reply)->framing.id, quint8(number));
    }
    QCOMPARE(server.arrived(0x72), 50);
}

/// However many came together and whoever told of them: the next one is heard too.
void ServerTest::listensAfterABurst()
{
    Server server {onFreePorts()};
    QVERIFY(server.start());
    Client client;
    for (int burst = 1; burst <= 40; ++burst) {
        for (int number = 0; number < burst; ++number)
            client.send(server.port(), status);
        for (int number = 0; number < burst; ++number)
            QVERIFY(client.receive().isValid());
        QVERIFY2(client.ask(server.port(), status).isValid(), qPrintable(QString::number(burst)));
        QVERIFY2(client.ask(server.port(), status).isValid(), qPrintable(QString::number(burst)));
    }
}

void ServerTest::servesFiles()
{
    Server server {onFreePorts()};
    QVERIFY(server.start());
    Client client;
    const protocol::Request list {0, 0, 0, protocol::Service::ListFiles, "*.CND"};
    client.send(server.filePort(), protocol::encode(list, {protocol::Division::File, false, 3, 0}));
    const auto reply = client.receive();
    QCOMPARE(reply.senderPort(), int(server.filePort()));
    QCOMPARE(protocol::parseReply(reply.data())->payload,
        QByteArrayView("CUBEINTF.CND\r\nSHOCKLVL.CND\r\nTOOL.CND\r\nUFRAME.CND\r\n"));
    QCOMPARE(server.arrivals().files.at(protocol::Service::ListFiles), 1);
}

void ServerTest::countsWhatArrivesBeforeFaults()
{
    Server server {onFreePorts()};
    server.setFaults(*Faults::parse(u"0x86 request lose; 0x83 reply lose times=1; 0x72 request duplicate"));
    QVERIFY(server.start());
    Client client;
    client.send(server.port(), {0x86, 1, 1, protocol::Service::SetSingle, QByteArray("\1\0\0\0", 4)});
    client.send(server.port(), protocol::HoldOn {}.request());
    client.send(server.port(), status);
    const QByteArray first = client.receive().data();
    QCOMPARE(protocol::parseReply(first)->service, quint8(0x81));
    QCOMPARE(client.receive().data(), first); // a request that arrives twice is answered twice
    QCOMPARE(server.arrived(0x86), 1);
    QCOMPARE(server.arrived(0x83), 1);
    QCOMPARE(server.arrived(0x72), 1);
    QVERIFY(server.memory().status.isHeld()); // its reply alone was lost
}

void ServerTest::keepsSilent()
{
    Time now = 0ms;
    Server server {onFreePorts([&] { return now; })};
    server.setFaults(*Faults::parse(u"0x83 request silence ms=2000 times=1"));
    QVERIFY(server.start());
    Client client;
    client.send(server.port(), protocol::HoldOn {}.request());
    client.send(server.port(), status);
    QTRY_COMPARE(server.arrived(0x72), 1);
    now = 2s;
    client.send(server.port(), status, 99);
    QCOMPARE(protocol::parseReply(client.receive().data())->framing.id, quint8(99)); // and nothing before it
    QVERIFY(!server.memory().status.isHeld());
}

void ServerTest::restarts()
{
    Time now = 0ms;
    Server server {onFreePorts([&] { return now; })};
    server.setFaults(*Faults::parse(u"0x72 request restart ms=1000 times=1"));
    QVERIFY(server.start());
    server.memory().b[0].value = 5;
    Client client;
    client.send(server.port(), status);
    QTRY_COMPARE(server.arrived(0x72), 1);
    now = 1s;
    const protocol::Request read {0x7A, 0, 1, protocol::Service::GetSingle};
    QCOMPARE(client.ask(server.port(), read).data().last(1), QByteArray(1, '\0'));
}

void ServerTest::refusesWithoutExecuting()
{
    Server server {onFreePorts()};
    server.setFaults(*Faults::parse(u"0x83 request refuse code=0x2080"));
    QVERIFY(server.start());
    Client client;
    const QByteArray reply = client.ask(server.port(), protocol::HoldOn {}.request()).data();
    QCOMPARE(protocol::parseReply(reply)->addedStatus, quint16(0x2080));
    QVERIFY(!server.memory().status.isHeld());
}

void ServerTest::ignoresWhatIsTooShort()
{
    Server server {onFreePorts()};
    QVERIFY(server.start());
    Client client;
    client.send(server.port(), "YERC");
    client.send(server.filePort(), "?");
    QTRY_COMPARE(server.arrivals().broken, 2);
    QVERIFY(!client.ask(server.port(), status).data().isEmpty());
}

void ServerTest::stopsAndStartsAgain()
{
    Server server {onFreePorts()};
    QVERIFY(server.start());
    server.stop();
    QCOMPARE(server.port(), quint16(0));
    QVERIFY(server.start());
    Client client;
    QVERIFY(!client.ask(server.port(), status).data().isEmpty());
}

QTEST_GUILESS_MAIN(ServerTest)
#include "tst_server.moc"
