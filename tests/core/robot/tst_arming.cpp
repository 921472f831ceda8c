// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "robot/arming.h"
#include <QSignalSpy>
#include <QTest>

using namespace std::chrono_literals;
using namespace robot;
using values::Status;

namespace {

constexpr Time begin {1h};

Situation ready()
{
    Situation situation;
    situation.isLinkUp = true;
    situation.level = Level::Operate;
    situation.status = Status {Status::Data1 {Status::Remote} | Status::Play | Status::OneCycle, {}};
    return situation;
}

using Change = void (*)(Situation &);

} // namespace

class TestArming : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void givesAPermitOnlyWhileArmed()
    {
        Arming arming;
        int calls = 0;
        const auto use = [&](const session::Permit &) { ++calls; };
        QVERIFY(!arming.withPermit(m_robot, use));
        QVERIFY(arming.arm(m_robot, ready(), begin));
        QVERIFY(arming.withPermit(m_robot, use));
        QVERIFY(!arming.withPermit(m_other, use));
        arming.drop(Arming::Drop::ByHand);
        QVERIFY(!arming.withPermit(m_robot, use));
        QCOMPARE(calls, 1);
    }

    void needsItsConditions_data()
    {
        QTest::addColumn<Change>("change");
        QTest::newRow("no link") << Change {[](Situation &s) { s.isLinkUp = false; }};
        QTest::newRow("Monitor") << Change {[](Situation &s) { s.level = Level::Monitor; }};
        QTest::newRow("no status") << Change {[](Situation &s) { s.status.reset(); }};
        QTest::newRow("no REMOTE") << Change {[](Situation &s) { s.status->data1.setFlag(Status::Remote, false); }};
        QTest::newRow("no PLAY") << Change {[](Situation &s) { s.status->data1.setFlag(Status::Play, false); }};
        QTest::newRow("TEACH") << Change {[](Situation &s) { s.status->data1.setFlag(Status::Teach); }};
        QTest::newRow("alarm") << Change {[](Situation &s) { s.status->data2.setFlag(Status::Alarm); }};
    }

    void needsItsConditions()
    {
        QFETCH(Change, change);
        Arming arming;
        Situation situation = ready();
        change(situation);
        QVERIFY(!arming.arm(m_robot, situation, begin));
        QVERIFY(!arming.isArmed());
    }

    void drops_data()
    {
        QTest::addColumn<Change>("change");
        QTest::addColumn<int>("reason"); // -1: it stays armed
        const auto row = [](const char *name, Change change, std::optional<Arming::Drop> reason) {
            QTest::newRow(name) << change << (reason ? int(*reason) : -1);
        };
        using Drop = Arming::Drop;
        row("nothing", [](Situation &) {}, {});
        row(
            "link lost", [](Situation &s) { s.isLinkUp = false; }, Drop::CommunicationLost);
        row(
            "access fell back", [](Situation &s) { s.level = Level::Monitor; }, Drop::AccessDropped);
        row("more access", [](Situation &s) { s.level = Level::Engineer; }, {});
        row(
            "alarm", [](Situation &s) { s.status->data2.setFlag(Status::Alarm); }, Drop::Alarm);
        row(
            "REMOTE off", [](Situation &s) { s.status->data1.setFlag(Status::Remote, false); }, Drop::ModeChanged);
        row(
            "PLAY off", [](Situation &s) { s.status->data1.setFlag(Status::Play, false); }, Drop::ModeChanged);
        row(
            "TEACH on", [](Situation &s) { s.status->data1.setFlag(Status::Teach); }, Drop::ModeChanged);
        row("another cycle", [](Situation &s) { s.status->data1 ^= Status::Data1 {Status::OneCycle} | Status::Step; },
            {});
        row("error", [](Situation &s) { s.status->data2.setFlag(Status::Error); }, {});
        row("running", [](Situation &s) { s.status->data1.setFlag(Status::Running); }, {});
        row("held", [](Situation &s) { s.status->data2.setFlag(Status::HeldByPendant); }, {});
        row("a late status", [](Situation &s) { s.status.reset(); }, {});
    }

    void drops()
    {
        QFETCH(Change, change);
        QFETCH(int, reason);
        Arming arming;
        QVERIFY(arming.arm(m_robot, ready(), begin));
        QSignalSpy changes {&arming, &Arming::changed};
        QSignalSpy drops {&arming, &Arming::dropped};
        Situation situation = ready();
        change(situation);
        arming.follow(m_other, situation); // somebody else's news
        QVERIFY(arming.isArmed(m_robot));
        arming.follow(m_robot, situation);
        QCOMPARE(arming.isArmed(m_robot), reason < 0);
        QCOMPARE(lastReason(drops), reason);
        QCOMPARE(changes.count(), reason < 0 ? 0 : 1);
        arming.follow(m_robot, ready());
        QCOMPARE(arming.isArmed(m_robot), reason < 0); // it never comes back by itself
    }

    void dropsWhenIdle()
    {
        Arming arming;
        QSignalSpy drops {&arming, &Arming::dropped};
        QVERIFY(arming.arm(m_robot, ready(), begin));
        arming.tick(begin + 59s);
        QVERIFY(arming.isArmed());
        arming.noteActivity(begin + 59s);
        arming.tick(begin + 118s);
        QVERIFY(arming.isArmed());
        arming.tick(begin + 119s);
        QVERIFY(!arming.isArmed());
        QCOMPARE(lastReason(drops), int(Arming::Drop::Idle));
    }

    void dropsAfterAStandstill_data()
    {
        using ms = std::chrono::milliseconds;
        QTest::addColumn<ms>("passed");
        QTest::addColumn<ms>("awake");
        QTest::addColumn<ms>("wall");
        QTest::addColumn<bool>("isArmed");
        QTest::newRow("in time") << ms {100} << ms {100} << ms {100} << true;
        QTest::newRow("a long paint") << ms {340} << ms {340} << ms {340} << true;
        QTest::newRow("stopped") << ms {400} << ms {400} << ms {400} << false;
        QTest::newRow("asleep") << ms {300} << ms {10} << ms {300} << false;
        QTest::newRow("the clock was set") << ms {100} << ms {100} << ms {5000} << false;
    }
    void dropsAfterAStandstill()
    {
        QFETCH(std::chrono::milliseconds, passed);
        QFETCH(std::chrono::milliseconds, awake);
        QFETCH(std::chrono::milliseconds, wall);
        QFETCH(bool, isArmed);
        Arming arming;
        QSignalSpy drops {&arming, &Arming::dropped};
        const values::Clocks before = values::Clocks::read();
        QVERIFY(arming.arm(m_robot, ready(), before.passed));
        arming.tick(before);
        arming.tick(values::Clocks {before.passed + passed, before.awake + awake, before.wall + wall});
        QCOMPARE(arming.isArmed(), isArmed);
        QCOMPARE(lastReason(drops), isArmed ? -1 : int(Arming::Drop::Standstill));
    }

    /// The first key after a long absence is no sign that somebody was there.
    void aLateKeyIsTooLate()
    {
        Arming arming;
        QSignalSpy drops {&arming, &Arming::dropped};
        QVERIFY(arming.arm(m_robot, ready(), begin));
        arming.noteActivity(begin + 60s);
        QCOMPARE(lastReason(drops), int(Arming::Drop::Idle));
    }

    void oneControllerOnly()
    {
        Arming arming;
        QVERIFY(arming.arm(m_robot, ready(), begin));
        QSignalSpy changes {&arming, &Arming::changed};
        QVERIFY(arming.arm(m_other, ready(), begin));
        QVERIFY(!arming.isArmed(m_robot));
        QVERIFY(arming.isArmed(m_other));
        QCOMPARE(changes.count(), 2);
    }

private:
    /// -1 if nothing was dropped.
    static int lastReason(const QSignalSpy &drops)
    {
        return drops.isEmpty() ? -1 : int(drops.constLast().at(1).value<Arming::Drop>());
    }

    QObject m_robot;
    QObject m_other;
};

QTEST_GUILESS_MAIN(TestArming)
#include "tst_arming.moc"
