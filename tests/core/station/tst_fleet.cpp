// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "twostations.h"

using robot::Arming;
using robot::Level;
using robot::LinkState;
using station::Station;

namespace {

enum { One, Other };
constexpr int nobody = -1;

} // namespace

class TestFleet : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    /// Level of each, whether each is armed first, what is tried, and who is armed in the end: one at most, always.
    void oneIsArmedAtMost_data()
    {
        QTest::addColumn<int>("levelOfOne");
        QTest::addColumn<int>("levelOfOther");
        QTest::addColumn<QList<int>>("arms"); // in this order
        QTest::addColumn<int>("armed");
        const QList<Level> levels {Level::Monitor, Level::Operate, Level::Engineer};
        const QList<QList<int>> orders {{}, {One}, {Other}, {One, Other}, {Other, One}, {One, Other, One}};
        for (const Level one : levels) {
            for (const Level other : levels) {
                for (const auto &order : orders) {
                    int armed = nobody;
                    for (const int who : order) {
                        if ((who == One ? one : other) != Level::Monitor)
                            armed = who; // Monitor may not arm (and disarms nobody by trying)
                    }
                    QString words = QStringLiteral("%1 %2:").arg(QLatin1String(key(one)), QLatin1String(key(other)));
                    for (const int who : order)
                        words += who == One ? QStringLiteral(" one") : QStringLiteral(" other");
                    QTest::newRow(qPrintable(words)) << int(one) << int(other) << order << armed;
                }
            }
        }
    }

    void oneIsArmedAtMost()
    {
        QFETCH(int, levelOfOne);
        QFETCH(int, levelOfOther);
        QFETCH(QList<int>, arms);
        QFETCH(int, armed);
        TwoStations &two = stations();
        two.one->access.enter(Level(levelOfOne));
        two.other->access.enter(Level(levelOfOther));
        for (const int who : arms) {
            Station &station = who == One ? *two.one : *two.other;
            const bool mayArm = station.access.level() != Level::Monitor;
            QCOMPARE(station.orders.arm(), mayArm);
            QVERIFY(!(two.one->orders.isArmed() && two.other->orders.isArmed()));
        }
        QCOMPARE(two.one->orders.isArmed(), armed == One);
        QCOMPARE(two.other->orders.isArmed(), armed == Other);
        QCOMPARE(two.fleet.armed(), armed == One ? two.one : armed == Other ? two.other : nullptr);
        QVERIFY(int(two.one->access.level()) == levelOfOne); // arming one changes no level of the other
        QVERIFY(int(two.other->access.level()) == levelOfOther);
    }

    void whoeverIsArmedSecondDisarmsTheFirst()
    {
        TwoStations &two = stations();
        two.one->access.enter(Level::Operate);
        two.other->access.enter(Level::Operate);
        QVERIFY(two.one->orders.arm());
        QVERIFY(two.other->orders.arm());
        QVERIFY(two.one->orders.lastDrop()->reason == Arming::Drop::OtherController);
        QVERIFY(!two.other->orders.lastDrop());
    }

    void closingDisarmsAndKeepsTheOther()
    {
        TwoStations two;
        QVERIFY(two.live());
        two.one->access.enter(Level::Operate);
        QVERIFY(two.one->orders.arm());
        QSignalSpy removed {&two.fleet, &station::Fleet::removed};
        two.fleet.close(two.one->id());
        QCOMPARE(removed.count(), 1);
        QVERIFY(!two.fleet.armed());
        QVERIFY(two.one->orders.lastDrop()->reason == Arming::Drop::Disconnected);
        QCOMPARE(two.fleet.stations().size(), 1);
        QVERIFY(two.other->controller.linkState() == LinkState::Monitoring);
        const auto again = two.fleet.open(two.machineOne.profile(QStringLiteral("CELL 1")));
        QVERIFY(again != two.one);
        QVERIFY(again->access.level() == Level::Monitor);
    }

    void theSameControllerIsThereOnce()
    {
        Plant plant;
        const Machine machine;
        const settings::Profile profile = machine.profile(QStringLiteral("CELL 1"));
        const auto first = plant.fleet.open(profile);
        QVERIFY(plant.fleet.open(profile) == first);
        QVERIFY(plant.fleet.add(profile) == first);
        QCOMPARE(plant.fleet.stations().size(), 1);
        settings::Profile changed = first->profile();
        changed.window = 2;
        const auto second = plant.fleet.add(changed);
        QVERIFY(second != first);
        QVERIFY(!first->isOpen());
        QCOMPARE(plant.fleet.stations().size(), 1);
    }

    /// Two profiles of one address are two stations; HSES does not mind two clients.
    void twoProfilesOfOneAddress()
    {
        Plant plant;
        const Machine machine;
        const auto one = plant.fleet.open(machine.profile(QStringLiteral("CELL 1")));
        const auto other = plant.fleet.open(machine.profile(QStringLiteral("CELL 1 again")));
        QVERIFY(one != other);
        QTRY_VERIFY(Plant::isLive(*one) && Plant::isLive(*other));
    }

    void oneThatIsSilentKeepsNobodyWaiting()
    {
        Plant plant;
        Machine machine;
        Machine silent;
        const auto live = plant.fleet.open(machine.profile(QStringLiteral("CELL 1")));
        const settings::Profile gone = silent.profile(QStringLiteral("CELL 2"));
        silent.server.reset();
        const auto dead = plant.fleet.open(gone);
        QTRY_VERIFY(Plant::isLive(*live));
        QVERIFY(dead->controller.linkState() == LinkState::Checking);
    }

    void holdGoesToEveryOneThatHasALink()
    {
        TwoStations two;
        QVERIFY(two.live());
        Machine silent;
        const settings::Profile gone = silent.profile(QStringLiteral("CELL 3"));
        silent.server.reset();
        const auto dead = two.fleet.open(gone);
        const auto closed = two.fleet.add(Machine().profile(QStringLiteral("CELL 4")));
        QSignalSpy recordedOfClosed {&closed->orders, &robot::Orders::recorded};
        QSignalSpy recordedOfDead {&dead->orders, &robot::Orders::recorded};
        two.fleet.holdAll();
        for (const auto &station : {two.one, two.other})
            QTRY_VERIFY(station->state().status().value->data2.testFlag(values::Status::HeldByCommand));
        QTRY_COMPARE(recordedOfDead.count(), 1);
        const auto record = recordedOfDead.constFirst().constFirst().value<journal::OrderRecord>();
        QVERIFY(record.outcome == journal::Outcome::Unknown); // said, and never "confirmed"
        QCOMPARE(recordedOfClosed.count(), 0);
        const auto &outcomes = two.fleet.holdOutcomes();
        QCOMPARE(outcomes.size(), std::size_t(3)); // whoever is open was asked
        QTRY_VERIFY(outcomes.at(two.one->id()) == journal::Outcome::Done);
        QTRY_VERIFY(outcomes.at(two.other->id()) == journal::Outcome::Done);
        QVERIFY(outcomes.at(dead->id()) == journal::Outcome::Unknown);
    }

    /// When the first one is told, the packet of the last has left.
    void everyHoldLeavesBeforeAnybodyIsTold()
    {
        TwoStations two;
        QVERIFY(two.live());
        const auto sentOf = [](const station::Station &station) {
            return station.controller.statistics().counters.requests;
        };
        const auto before = std::pair {sentOf(*two.one), sentOf(*two.other)};
        QList<bool> hadLeft;
        for (const auto &station : {two.one, two.other})
            connect(&station->controller, &robot::Controller::holdOrderChanged, this, [&] {
                if (hadLeft.isEmpty())
                    hadLeft << (sentOf(*two.one) > before.first) << (sentOf(*two.other) > before.second);
            });
        two.fleet.holdAll();
        for (const auto &station : {two.one, two.other})
            station->controller.disconnect(this);
        QCOMPARE(hadLeft, (QList {true, true}));
    }

    void inTheBackgroundItIsReadOnceASecond()
    {
        TwoStations two;
        QVERIFY(two.live());
        two.one->controller.setPace(robot::Pace::Watched);
        const int before = two.machineOther.server->arrived(0x72);
        QSignalSpy watched {&two.one->state(), &robot::RobotState::changed};
        const int beforeOne = two.machineOne.server->arrived(0x72);
        QTRY_VERIFY(two.machineOther.server->arrived(0x72) >= before + 2); // one to two seconds
        QVERIFY(
            two.machineOne.server->arrived(0x72) - beforeOne > 2 * (two.machineOther.server->arrived(0x72) - before));
        QVERIFY(two.other->state().freshness(robot::topics::status) == robot::Freshness::Live);
    }

private:
    /// At rest and disarmed, with both links up.
    TwoStations &stations()
    {
        if (!m_two) {
            m_two = std::make_unique<TwoStations>();
            if (!m_two->live())
                qFatal("no link");
        }
        m_two->arming.drop(Arming::Drop::ByHand);
        return *m_two;
    }

    std::unique_ptr<TwoStations> m_two;
};

QTEST_GUILESS_MAIN(TestFleet)
#include "tst_fleet.moc"
