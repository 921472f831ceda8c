// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "robot/controller.h"
#include "robot/diagnosis.h"
#include "robot/orders.h"
#include "session/session.h"
#include "session/udptransport.h"
#include "virtualcontroller/server.h"
#include <QSignalSpy>
#include <QTest>
#include <QUdpSocket>

using namespace std::chrono_literals;
using namespace robot;
using values::ErrorKind;
using virtualcontroller::Server;

namespace {

virtualcontroller::Options onAnyPort(quint16 port = 0)
{
    virtualcontroller::Options options;
    options.port = port;
    options.filePort = 0;
    return options;
}

settings::Profile profileOf(quint16 port, quint16 filePort = 1)
{
    settings::Profile profile;
    profile.name = QStringLiteral("Test");
    profile.host = QStringLiteral("127.0.0.1");
    profile.port = port;
    profile.filePort = filePort;
    profile.readTimeout = 100ms;
    return profile;
}

/// The way in for HOLD.
struct Door {
    explicit Door(Controller &controller) : orders {controller, access, arming} { }

    AccessRules rules;
    Access access {rules};
    Arming arming;
    Orders orders;
};

int holdsIn(QUdpSocket &socket)
{
    int holds = 0;
    while (socket.hasPendingDatagrams()) {
        QByteArray datagram(64, '\0');
        datagram.resize(socket.readDatagram(datagram.data(), datagram.size()));
        holds += protocol::parseClientPacket(datagram)->command == 0x83;
    }
    return holds;
}

} // namespace

class TestController : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void readsWhatTheControllerHolds()
    {
        Server server {onAnyPort()};
        QVERIFY(server.start());
        Controller controller {profileOf(server.port())};
        const auto interest = controller.poller().want({topics::masterJob, topics::basePosition, topics::pulsePosition,
            topics::baseAxisNames, topics::pulseAxisNames});
        controller.open();
        QCOMPARE(controller.linkState(), LinkState::Checking);
        QTRY_COMPARE(controller.linkState(), LinkState::Monitoring);
        for (const Topic topic : topics::overview)
            QTRY_COMPARE(controller.state().freshness(topic), Freshness::Live);
        const RobotState &state = controller.state();
        QCOMPARE(*state.status().value, server.memory().status);
        QCOMPARE(state.baseAxisNames().value->names[0].bytes(), QByteArrayView("X"));
        QCOMPARE(state.pulseAxisNames().value->names[0].bytes(), QByteArrayView("S"));
        QVERIFY(state.basePosition().value->type == values::PositionType::Base);
        QVERIFY(controller.statistics().p50.has_value());
    }

    void aTopicNobodyWantsIsNotRead()
    {
        Server server {onAnyPort()};
        QVERIFY(server.start());
        Controller controller {profileOf(server.port())};
        controller.open();
        auto interest = controller.poller().want({topics::masterJob});
        QTRY_COMPARE(controller.state().freshness(topics::masterJob), Freshness::Live);
        QCOMPARE(controller.state().freshness(topics::basePosition), Freshness::Unknown);
        interest.reset();
        QTRY_COMPARE(controller.state().freshness(topics::masterJob), Freshness::Stale);
        QCOMPARE(controller.state().freshness(topics::status), Freshness::Live);
    }

    void aLostLinkMakesEverythingStaleAndComesBack()
    {
        auto server = std::make_unique<Server>(onAnyPort());
        QVERIFY(server->start());
        const quint16 port = server->port();
        Controller controller {profileOf(port)};
        controller.open();
        QTRY_COMPARE(controller.linkState(), LinkState::Monitoring);
        server.reset();
        QTRY_COMPARE(controller.linkState(), LinkState::Lost);
        QCOMPARE(controller.state().freshness(topics::status), Freshness::Stale);
        QCOMPARE(controller.state().freshness(topics::systemInformation), Freshness::Stale);
        QVERIFY(controller.state().status().value);
        Server again {onAnyPort(port)};
        QVERIFY(again.start());
        QTRY_COMPARE(controller.linkState(), LinkState::Monitoring);
        QCOMPARE(controller.timesLost(), 1);
        QCOMPARE(controller.state().freshness(topics::status), Freshness::Live);
    }

    void aSilentPortIsCheckedUntilItAnswers()
    {
        QUdpSocket reserved;
        QVERIFY(reserved.bind(QHostAddress::LocalHost, 0));
        const quint16 port = reserved.localPort();
        Controller controller {profileOf(port)};
        controller.open();
        QTRY_VERIFY(controller.trouble());
        QCOMPARE(controller.trouble()->kind, ErrorKind::NoAnswer);
        QCOMPARE(controller.linkState(), LinkState::Checking);
        QCOMPARE(controller.state().freshness(topics::status), Freshness::Unknown);
        reserved.close();
        Server server {onAnyPort(port)};
        QVERIFY(server.start());
        QTRY_COMPARE(controller.linkState(), LinkState::Monitoring);
        QVERIFY(!controller.trouble());
    }

    void anUnknownNameIsSaid()
    {
        auto profile = profileOf(10040);
        profile.host = QStringLiteral("no-such-controller.invalid");
        Controller controller {profile};
        controller.open();
        QTRY_VERIFY_WITH_TIMEOUT(controller.trouble(), 20000);
        QCOMPARE(controller.trouble()->kind, ErrorKind::Network);
        Door door {controller};
        door.orders.hold(); // nowhere to send it: that is said, not kept quiet
        QCOMPARE(controller.holdState().word, HoldWord::Unconfirmed);
    }

    void aShortTimeoutIsNoLostLink()
    {
        Server server {onAnyPort()};
        QVERIFY(server.start());
        auto profile = profileOf(server.port());
        profile.readTimeout = 20ms; // three of them are shorter than the pause between two status reads
        Controller controller {profile};
        int reads = 0;
        connect(&controller.state(), &RobotState::changed, this,
            [&](const TopicRange &range) { reads += range.contains(topics::status); });
        controller.open();
        QTRY_VERIFY(reads >= 15);
        QCOMPARE(controller.linkState(), LinkState::Monitoring);
        QCOMPARE(controller.timesLost(), 0);
    }

    /// Before the link was looked at for the first time there was no standstill that could excuse it.
    void aLinkThatDiesAtOnceIsLost()
    {
        auto server = std::make_unique<Server>(onAnyPort());
        QVERIFY(server->start());
        Controller controller {profileOf(server->port())};
        connect(&controller, &Controller::linkStateChanged, this, [&] {
            if (controller.linkState() == LinkState::Monitoring)
                server->setFaults(*virtualcontroller::Faults::parse(u"any reply lose"));
        });
        controller.open();
        QTRY_COMPARE(controller.linkState(), LinkState::Lost);
        QCOMPARE(controller.timesLost(), 1);
    }

    void aStandstillOfOursIsNoLostLink()
    {
        Server server {onAnyPort()};
        QVERIFY(server.start());
        Controller controller {profileOf(server.port())};
        controller.open();
        QTRY_COMPARE(controller.linkState(), LinkState::Monitoring);
        QThread::sleep(2); // a long paint: nobody was asked meanwhile
        QCoreApplication::processEvents();
        QTRY_COMPARE(controller.state().freshness(topics::status), Freshness::Live);
        QCOMPARE(controller.timesLost(), 0);
    }

    void holdIsConfirmedByTheStatus()
    {
        Server server {onAnyPort()};
        QVERIFY(server.start());
        Controller controller {profileOf(server.port())};
        Door door {controller};
        door.orders.hold(); // no link yet: nothing happens
        QCOMPARE(controller.holdState().word, HoldWord::None);
        controller.open();
        door.orders.hold(); // while checking
        QCOMPARE(controller.holdState().word, HoldWord::Asked);
        QTRY_VERIFY(controller.holdFacts().order->progress == HoldOrder::Progress::Confirmed);
        QVERIFY(server.memory().status.data2 & values::Status::HeldByCommand);
    }

    void holdWithoutAnAnswerIsNeverCalledConfirmed()
    {
        QUdpSocket silent;
        QVERIFY(silent.bind(QHostAddress::LocalHost, 0));
        Controller controller {profileOf(silent.localPort())};
        Door door {controller};
        controller.open();
        door.orders.hold();
        QTRY_COMPARE(controller.holdState().word, HoldWord::Unconfirmed);
        QVERIFY(holdsIn(silent) >= 7); // every 40 ms for 2 s, on a computer that may be busy
    }

    /// Nobody hears of HOLD before its packet has left.
    void firstThePacketThenTheWords()
    {
        QUdpSocket silent;
        QVERIFY(silent.bind(QHostAddress::LocalHost, 0));
        Controller controller {profileOf(silent.localPort())};
        Door door {controller};
        controller.open();
        QList<int> sentBefore;
        const auto look = [&] {
            (void)silent.waitForReadyRead(1000);
            sentBefore << holdsIn(silent);
        };
        connect(&controller, &Controller::holdOrderChanged, &silent, look, Qt::SingleShotConnection);
        door.orders.hold();
        QCOMPARE(sentBefore, QList<int> {1});
    }

    /// Release, a new start, a lost link, a controller that restarts: nothing of the last HOLD stays under the button.
    void nothingOldIsSaid()
    {
        auto server = std::make_unique<Server>(onAnyPort());
        QVERIFY(server->start());
        const quint16 port = server->port();
        Controller controller {profileOf(port)};
        Door door {controller};
        controller.open();
        QTRY_COMPARE(controller.linkState(), LinkState::Monitoring);
        door.orders.hold();
        QTRY_COMPARE(controller.holdState().word, HoldWord::HeldByCommand);
        server->memory().status.data2.setFlag(values::Status::HeldByCommand, false); // whoever did that
        QTRY_COMPARE(controller.holdState().word, HoldWord::Released);
        QTRY_COMPARE(controller.holdState().word, HoldWord::None);
        server->memory().status.data2.setFlag(values::Status::HeldByPendant);
        QTRY_COMPARE(controller.holdState().word, HoldWord::HeldByPendant);
        server->memory().status.data2.setFlag(values::Status::HeldByPendant, false);
        door.orders.hold();
        QTRY_COMPARE(controller.holdState().word, HoldWord::HeldByCommand);
        server.reset();
        QTRY_COMPARE(controller.holdState().word, HoldWord::None); // nobody knows
        Server again {onAnyPort(port)};
        QVERIFY(again.start());
        QTRY_COMPARE(controller.linkState(), LinkState::Monitoring);
        QCOMPARE(controller.holdState().word, HoldWord::None);
    }

    void holdArrivesThroughHeavyLoss()
    {
        Server server {onAnyPort()};
        QVERIFY(server.start());
        Controller controller {profileOf(server.port())};
        Door door {controller};
        controller.open();
        QTRY_COMPARE(controller.linkState(), LinkState::Monitoring);
        server.setFaults(*virtualcontroller::Faults::parse(u"seed=3; 0x83 request lose p=0.9; 0x83 reply lose p=0.9"));
        door.orders.hold();
        QTRY_VERIFY(server.memory().status.data2 & values::Status::HeldByCommand);
        QTRY_COMPARE(controller.holdState().word, HoldWord::HeldByCommand);
    }

    void servoOffIsConfirmedByTheStatus()
    {
        Server server {onAnyPort()};
        QVERIFY(server.start());
        server.memory().status.data2.setFlag(values::Status::ServoOn);
        session::UdpTransport transport {QHostAddress {QHostAddress::LocalHost}, server.port()};
        session::Session session {transport, {}};
        auto *order = new StopOrder {Stop::ServoOff, session, this};
        QSignalSpy finished {order, &StopOrder::finished};
        order->start();
        QTRY_COMPARE(finished.count(), 1);
        QVERIFY(finished.first().first().value<StopOrder::Outcome>() == StopOrder::Outcome::Confirmed);
        QVERIFY(!server.memory().status.isServoOn());
    }

    void closingForgets()
    {
        Server server {onAnyPort()};
        QVERIFY(server.start());
        Controller controller {profileOf(server.port())};
        connect(&controller, &Controller::linkStateChanged, this, [&] {
            if (controller.linkState() == LinkState::Monitoring)
                controller.close(); // from inside a handler of its own session
        });
        controller.open();
        QSignalSpy states {&controller, &Controller::linkStateChanged};
        QTRY_COMPARE(states.count(), 2);
        QCOMPARE(controller.linkState(), LinkState::Disconnected);
        QVERIFY(!controller.state().status().value);
        QCOMPARE(controller.state().freshness(topics::status), Freshness::Unknown);
    }

    void diagnosis_data()
    {
        QTest::addColumn<QByteArray>("noise"); // what the port answers; empty for silence, "sim" for a controller
        QTest::addColumn<QString>("outcomes"); // P passed, F failed, S skipped
        QTest::newRow("silent") << QByteArray {} << QStringLiteral("PPFSS");
        QTest::newRow("not HSES") << QByteArray {"hello"} << QStringLiteral("PPFSS");
        QTest::newRow("controller, no files") << QByteArray {"sim"} << QStringLiteral("PPPPF");
    }

    void diagnosis()
    {
        QFETCH(QByteArray, noise);
        QFETCH(QString, outcomes);
        Server server {onAnyPort()};
        QUdpSocket silent;
        QVERIFY(server.start() && silent.bind(QHostAddress::LocalHost, 0));
        connect(&silent, &QUdpSocket::readyRead, this, [&] {
            QHostAddress peer;
            quint16 port = 0;
            char request = 0;
            silent.readDatagram(&request, 1, &peer, &port);
            if (!noise.isEmpty())
                silent.writeDatagram(noise, peer, port);
        });
        Diagnosis diagnosis {profileOf(noise == "sim" ? server.port() : silent.localPort())};
        QSignalSpy finished {&diagnosis, &Diagnosis::finished};
        diagnosis.start();
        QTRY_COMPARE(finished.count(), 1);
        QString seen;
        for (const Rung &rung : diagnosis.rungs()) {
            seen += QStringLiteral("PFS")[int(rung.outcome)];
            QVERIFY(!rung.sentence.isEmpty());
            QCOMPARE(rung.remedy.isEmpty(), rung.outcome != Rung::Outcome::Failed);
        }
        QCOMPARE(seen, outcomes);
    }
};

QTEST_GUILESS_MAIN(TestController)
#include "tst_controller.moc"
