// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "motion/follower.h"
#include <QTest>

using namespace std::chrono_literals;
using motion::Follower;
using motion::Time;
using Outcome = Follower::Outcome;
using Reply = motion::StepEngine::Reply;
using values::PositionType;

namespace {

values::Position at(int x, int rz = 0) { return {PositionType::Base, 0, 0, 0, 0, {x, 0, 0, 0, 0, rz}}; }

/// A move to X 100 mm that should take a second, sent at 0.
struct Move {
    Follower follower {at(100'000), Time {}, 1000ms};

    static Time time(int milliseconds) { return Time {std::chrono::milliseconds {milliseconds}}; }
    Outcome reply(Reply reply, int now) { return follower.takeReply(reply, time(now)); }
    Outcome status(bool isRunning, int now) { return follower.takeStatus(isRunning, time(now)); }
    Outcome position(int x, int now) { return follower.takePosition(at(x), time(now)); }
};

} // namespace

/// What became of a move.
class FollowerTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void arrives();
    void stopsOnTheWay();
    void shortMove();
    void startsLate();
    void endsAtOnce_data();
    void endsAtOnce();
    void neverRests();
    void firstOutcomeHolds();
    void places_data();
    void places();
};

void FollowerTest::arrives()
{
    Move move;
    QVERIFY(move.status(false, 10) == Outcome::UnderWay);
    QVERIFY(move.position(0, 10) == Outcome::UnderWay);
    QVERIFY(move.reply(Reply::Accepted, 20) == Outcome::UnderWay);
    QVERIFY(move.status(true, 100) == Outcome::UnderWay);
    QVERIFY(move.position(50'000, 500) == Outcome::UnderWay);
    QVERIFY(move.status(false, 1000) == Outcome::UnderWay);
    QVERIFY(move.position(99'990, 1010) == Outcome::UnderWay);
    QVERIFY(move.position(100'000, 1110) == Outcome::Arrived);
}

void FollowerTest::stopsOnTheWay()
{
    Move move;
    move.reply(Reply::Accepted, 0);
    move.status(true, 100);
    move.status(false, 500); // held
    QVERIFY(move.position(48'000, 510) == Outcome::UnderWay);
    QVERIFY(move.position(50'000, 610) == Outcome::UnderWay); // it slows down
    QVERIFY(move.position(50'000, 710) == Outcome::Stopped);
    QCOMPARE(move.follower.position()->axes[0], 50'000);
}

void FollowerTest::shortMove()
{
    Move move; // nobody sees it run
    move.reply(Reply::Accepted, 0);
    move.status(false, 300);
    move.position(100'000, 310);
    QVERIFY(move.position(100'000, 410) == Outcome::Arrived);
}

void FollowerTest::startsLate()
{
    Move move; // it rests where it was, and has not begun
    move.reply(Reply::Accepted, 0);
    move.status(false, 100);
    move.position(0, 110);
    QVERIFY(move.position(0, 210) == Outcome::UnderWay);
    move.status(true, 240);
    QVERIFY(move.position(0, 250) == Outcome::UnderWay);
}

void FollowerTest::endsAtOnce_data()
{
    QTest::addColumn<int>("what");
    QTest::addColumn<int>("outcome");
    QTest::newRow("refused") << 0 << int(Outcome::Refused);
    QTest::newRow("not answered") << 1 << int(Outcome::Unknown);
    QTest::newRow("link lost") << 2 << int(Outcome::Unknown);
}

void FollowerTest::endsAtOnce()
{
    QFETCH(int, what);
    Move move;
    const Outcome outcome = what == 0 ? move.reply(Reply::Refused, 10)
        : what == 1                   ? move.reply(Reply::Unknown, 10)
                                      : move.follower.loseLink();
    QTEST(int(outcome), "outcome");
}

void FollowerTest::neverRests()
{
    Move move;
    move.reply(Reply::Accepted, 0);
    QVERIFY(move.status(true, 7000) == Outcome::UnderWay); // twice a second, and five
    QVERIFY(move.status(true, 7001) == Outcome::Unknown);
}

void FollowerTest::firstOutcomeHolds()
{
    Move move;
    QVERIFY(move.follower.loseLink() == Outcome::Unknown);
    QVERIFY(move.reply(Reply::Refused, 10) == Outcome::Unknown);
}

void FollowerTest::places_data()
{
    QTest::addColumn<bool>("isSame");
    QTest::addColumn<int>("x");
    QTest::addColumn<int>("rz");
    QTest::newRow("the same") << true << 0 << 0;
    QTest::newRow("0.05 mm") << true << 50 << 0;
    QTest::newRow("0.06 mm") << false << 60 << 0;
    QTest::newRow("0.019 degrees") << true << 0 << 190;
    QTest::newRow("0.03 degrees") << false << 0 << 300;
    QTest::newRow("a whole turn") << true << 0 << 3'600'000;
}

void FollowerTest::places()
{
    QFETCH(int, x);
    QFETCH(int, rz);
    QTEST(motion::isSamePlace(at(0), at(x, rz)), "isSame");
    values::Position pulses = at(0);
    pulses.type = PositionType::Pulse;
    QVERIFY(!motion::isSamePlace(at(0), pulses));
    values::Position near = pulses;
    near.axes[3] = 20;
    QVERIFY(motion::isSamePlace(pulses, near));
    near.axes[3] = 21;
    QVERIFY(!motion::isSamePlace(pulses, near));
    near.axes.resize(7);
    QVERIFY(!motion::isSamePlace(pulses, near));
}

QTEST_GUILESS_MAIN(FollowerTest)

#include "tst_follower.moc"
