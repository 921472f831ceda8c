// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "robot/controller.h"
#include "virtualcontroller/alarms.h"
#include "virtualcontroller/server.h"

#include <QTest>

using namespace robot;
using virtualcontroller::Memory;
using virtualcontroller::Server;

namespace {

settings::Profile profileOf(const Server &server, protocol::Model model = protocol::Model::YRC1000)
{
    settings::Profile profile;
    profile.host = QStringLiteral("127.0.0.1");
    profile.port = server.port();
    profile.model = model;
    profile.requestsPerSecond = 1000;
    return profile;
}

Freshness freshness(const Controller &controller, Kind kind, int number)
{
    return controller.state().freshness({kind, quint16(number)});
}

} // namespace

/// Reads items over real sockets from a virtual controller.
class TestPoller : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void itemsArriveTogether();
    void anItemThatIsRefusedStandsAlone();
    void aWholeAreaIsRefused();
    void numbersShiftedOnTheWire();
    void shortStringsOfOldModels();
    void alarmsWithoutTextsOnOldControllers();
    void alarmsAreReadOnTheEdge();
    void manyReadsDoNotDelayTheStatus();
    void factsAreAskedOnceForTheLink();
    void factsWaitForWhatIsWatched();
    void pointsAreReadOnce();

private:
    Server &serve(const virtualcontroller::Settings &settings = {}, const QString &faults = {});

    std::unique_ptr<Server> m_server;
};

Server &TestPoller::serve(const virtualcontroller::Settings &settings, const QString &faults)
{
    m_server = std::make_unique<Server>(virtualcontroller::Options {.port = 0, .filePort = 0});
    m_server->setMemory(Memory {settings});
    m_server->setFaults(*virtualcontroller::Faults::parse(faults));
    [&] { QVERIFY(m_server->start()); }();
    return *m_server;
}

void TestPoller::itemsArriveTogether()
{
    Controller controller {profileOf(serve())};
    m_server->memory().registers[5] = {123};
    int announcements = 0;
    connect(&controller.state(), &RobotState::changed, this,
        [&](const TopicRange &range) { announcements += range == TopicRange(Kind::Register, 0, 99); });
    const auto interest = controller.poller().want({{Kind::Register, 0, 99}});
    controller.open();
    QTRY_VERIFY(announcements > 0);
    QCOMPARE(controller.state().reading<Kind::Register>(5).value->value, quint16(123));
    QCOMPARE(freshness(controller, Kind::Register, 99), Freshness::Live);
    QCOMPARE(freshness(controller, Kind::Register, 100), Freshness::Unknown);
    QCOMPARE(controller.poller().planSize(), 3); // status, system information, registers
}

/// P001 was never set (reference §4.4), so that no packet with it is answered.
void TestPoller::anItemThatIsRefusedStandsAlone()
{
    Controller controller {profileOf(serve())};
    for (std::size_t i = 0; i < 9; ++i)
        m_server->memory().p[i] = values::PositionVariable {};
    m_server->memory().p[1].reset();
    const auto interest = controller.poller().want({{Kind::PositionVariable, 0, 8}});
    controller.open();
    QTRY_COMPARE(freshness(controller, Kind::PositionVariable, 1), Freshness::Refused);
    for (const int number : {0, 2, 3, 4, 5, 6, 7, 8})
        QTRY_COMPARE(freshness(controller, Kind::PositionVariable, number), Freshness::Live);
    QTRY_COMPARE(controller.poller().planSize(), 2 + 3); // P000, P001, P002 to P008
}

/// The profile says YRC1000, the controller has the external inputs of an FS100: 2001 to 2128 (reference §4.1).
void TestPoller::aWholeAreaIsRefused()
{
    Controller controller {profileOf(serve({.model = protocol::Model::FS100}))};
    const auto interest = controller.poller().want({{Kind::IoGroup, 2125, 2132}});
    controller.open();
    for (const int group : {2129, 2130, 2131, 2132})
        QTRY_COMPARE(freshness(controller, Kind::IoGroup, group), Freshness::Refused);
    for (const int group : {2125, 2126, 2127, 2128})
        QTRY_COMPARE(freshness(controller, Kind::IoGroup, group), Freshness::Live);
}

void TestPoller::numbersShiftedOnTheWire()
{
    auto profile = profileOf(serve({.numbering = protocol::Numbering::FromOne}));
    m_server->memory().b[7] = {77};
    profile.numbering = protocol::Numbering::FromOne;
    Controller controller {profile};
    const auto interest = controller.poller().want({{Kind::ByteVariable, 0, 99}});
    controller.open();
    QTRY_COMPARE(freshness(controller, Kind::ByteVariable, 99), Freshness::Live);
    QCOMPARE(controller.state().reading<Kind::ByteVariable>(7).value->value, quint8(77));
}

void TestPoller::shortStringsOfOldModels()
{
    Controller controller {profileOf(serve({.model = protocol::Model::FS100}), protocol::Model::FS100)};
    m_server->memory().s[3] = values::StringVariable32 {values::FixedText<32> {"PALLET"}};
    const auto interest = controller.poller().want({{Kind::StringVariable, 3, 4}});
    controller.open();
    QTRY_COMPARE(freshness(controller, Kind::StringVariable, 3), Freshness::Live);
    QCOMPARE(controller.state().reading<Kind::StringVariable>(3).value->value.bytes(), QByteArrayView("PALLET"));
}

void TestPoller::alarmsWithoutTextsOnOldControllers()
{
    Controller controller {profileOf(serve({}, u"0x30A request refuse code=0xA000"_qs))};
    const auto interest = controller.poller().want({{Kind::Alarm, 1, 4}});
    controller.open();
    for (int slot = 1; slot <= 4; ++slot)
        QTRY_COMPARE(freshness(controller, Kind::Alarm, slot), Freshness::Live);
}

void TestPoller::alarmsAreReadOnTheEdge()
{
    Controller controller {profileOf(serve())};
    const auto interest = controller.poller().want({{Kind::Alarm, 1, 4}});
    controller.open();
    QTRY_COMPARE(freshness(controller, Kind::Alarm, 1), Freshness::Live);
    QVERIFY(controller.state().reading<Kind::Alarm>(1).value->alarm.isEmpty());
    virtualcontroller::raiseAlarm(m_server->memory(), 4107, "OVERRUN");
    QTRY_COMPARE(controller.state().reading<Kind::Alarm>(1).value->alarm.code, 4107u);
}

/// Forty groups are asked at once, each for 40 ms: 1.6 s, in which the status is due sixteen times.
void TestPoller::manyReadsDoNotDelayTheStatus()
{
    Controller controller {profileOf(serve({}, QStringLiteral("any reply delay ms=40")))};
    controller.open();
    QTRY_VERIFY(controller.linkState() == LinkState::Monitoring);
    const int before = m_server->arrived(0x72);
    const auto interest =
        controller.poller().want({{Kind::AxisNames, 1, 8}, {Kind::AxisNames, 11, 18}, {Kind::AxisNames, 21, 44}});
    for (const int group : {1, 8, 11, 18, 21, 44})
        QTRY_VERIFY(freshness(controller, Kind::AxisNames, group) != Freshness::Unknown);
    const int read = m_server->arrived(0x72) - before;
    QVERIFY2(read >= 8, qPrintable(QString::number(read)));
    QCOMPARE(controller.timesLost(), 0);
}

/// A page that is opened again does not ask again; another link does.
void TestPoller::factsAreAskedOnceForTheLink()
{
    Controller controller {profileOf(serve())};
    controller.open();
    auto interest = controller.poller().want({{Kind::AxisNames, 1, 3}});
    for (const int group : {1, 2, 3})
        QTRY_VERIFY(freshness(controller, Kind::AxisNames, group) != Freshness::Unknown);
    const int before = m_server->arrived(0x74);
    interest = {};
    const int status = m_server->arrived(0x72);
    QTRY_VERIFY(m_server->arrived(0x72) > status + 2);
    interest = controller.poller().want({{Kind::AxisNames, 1, 3}, {Kind::Register, 0, 9}});
    QTRY_COMPARE(freshness(controller, Kind::Register, 9), Freshness::Live);
    QTRY_VERIFY(m_server->arrived(0x72) > status + 6);
    QCOMPARE(m_server->arrived(0x74), before);
    controller.close();
    controller.open();
    QTRY_COMPARE(m_server->arrived(0x74), before + 3);
}

/// Forty names and the following error are wanted at once: it does not wait for the names.
void TestPoller::factsWaitForWhatIsWatched()
{
    Controller controller {profileOf(serve())};
    controller.open();
    QTRY_VERIFY(controller.linkState() == LinkState::Monitoring);
    const auto names = controller.poller().want(
        {{Kind::AxisNames, 1, 8}, {Kind::AxisNames, 11, 18}, {Kind::AxisNames, 21, 44}, {Kind::FollowingError, 1, 1}});
    int namesBefore = -1;
    connect(&controller.state(), &RobotState::changed, this, [&](const TopicRange &range) {
        if (range.contains({Kind::FollowingError, 1}) && namesBefore < 0)
            namesBefore = m_server->arrived(0x74);
    });
    QTRY_VERIFY(namesBefore >= 0);
    QVERIFY2(namesBefore <= 1, qPrintable(QString::number(namesBefore)));
    QTRY_VERIFY(freshness(controller, Kind::AxisNames, 44) != Freshness::Unknown);
}

/// Taught or not, each is told once; asked for again, they are read again.
void TestPoller::pointsAreReadOnce()
{
    Controller controller {profileOf(serve())};
    for (std::size_t i = 0; i < 9; ++i)
        m_server->memory().p[i] = values::PositionVariable {};
    m_server->memory().p[1].reset();
    const auto isTold = [&] {
        for (const int number : {0, 2, 3, 4, 5, 6, 7, 8}) {
            if (!controller.state().reading<Kind::PositionVariable>(number).value)
                return false;
        }
        return freshness(controller, Kind::PositionVariable, 1) == Freshness::Refused;
    };
    const auto asked = [&] { return m_server->arrived(0x307) + m_server->arrived(0x7F); };
    controller.open();
    auto interest = controller.poller().wantOnce({{Kind::PositionVariable, 0, 8}});
    QTRY_VERIFY(isTold());
    const int before = asked();
    const int status = m_server->arrived(0x72);
    QTRY_VERIFY(m_server->arrived(0x72) > status + 10); // a second, in which they would be due twice
    QCOMPARE(asked(), before);
    interest = {};
    interest = controller.poller().wantOnce({{Kind::PositionVariable, 0, 0}});
    QTRY_COMPARE(asked(), before + 1);
}

QTEST_GUILESS_MAIN(TestPoller)

#include "tst_poller.moc"
