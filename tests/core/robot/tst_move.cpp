// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "robot/move.h"
#include "support/cell.h"

using motion::Wish;
using robot::Move;
using values::AxisWords;
using values::ControlGroup;
using values::Status;
using virtualcontroller::Faults;
using Outcome = Move::Outcome;

namespace {

constexpr quint16 moveCartesian = 0x8A;

/// A controller whose arm stands still, and moves of it.
struct Desk {
    [[nodiscard]] bool open()
    {
        interest = cell.controller->poller().want(
            {robot::topics::basePosition, robot::topics::pulsePosition, robot::topics::status});
        return cell.armed() && QTest::qWaitFor([this] {
            const auto present = robot::presentOf(cell.controller->state(), ControlGroup::robotPulse(1));
            return present.base && present.pulse;
        });
    }
    /// `millimetres` along X from where it stands.
    [[nodiscard]] std::unique_ptr<Move> along(double millimetres, Wish::How how = Wish::How::Straight, int axis = 0)
    {
        const auto present = robot::presentOf(cell.controller->state(), ControlGroup::robotPulse(1));
        Wish wish;
        wish.how = how;
        wish.axes = how == Wish::How::Increment ? AxisWords {0, 0, 0, 0, 0, 0} : present.base->axes;
        wish.axes[axis] += qint32(millimetres * 1000);
        wish.speeds.tool = 50;
        wish.speeds.rotation = 30;
        const auto plan = motion::plan(wish, present, motion::Limits {});
        return plan ? std::make_unique<Move>(*cell.orders, *plan, present) : nullptr;
    }
    [[nodiscard]] AxisWords place() const
    {
        const auto &memory = cell.server->memory();
        return memory.findGroup(ControlGroup::robotPulse(1))->poseAt(memory.now);
    }
    [[nodiscard]] int arrived() const { return cell.server->arrived(moveCartesian); }

    Cell cell;
    robot::Poller::Interest interest;
};

} // namespace

/// A move over sockets, and what became of it.
class TestMove : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void arrives()
    {
        Desk desk;
        QVERIFY(desk.open());
        const AxisWords begin = desk.place();
        const auto move = desk.along(20);
        QVERIFY(move);
        move->start();
        move->start(); // once is all
        QTRY_VERIFY(move->isFinished());
        QVERIFY(move->outcome() == Outcome::Arrived);
        QCOMPARE(desk.place()[0], begin[0] + 20'000);
        QCOMPARE(move->position()->axes[0], begin[0] + 20'000);
        QCOMPARE(desk.arrived(), 1);
        QCOMPARE(desk.cell.records.constLast().action, QStringLiteral("move"));
    }

    /// The angles of an increment are added up in a way that is told nowhere.
    void turnsComeToRest()
    {
        Desk desk;
        QVERIFY(desk.open());
        const auto move = desk.along(5, Wish::How::Increment, 4);
        QVERIFY(move && !move->plan().target);
        move->start();
        QTRY_VERIFY(move->isFinished());
        QVERIFY(move->outcome() == Outcome::Rested);
    }

    void heldOnTheWay()
    {
        Desk desk;
        QVERIFY(desk.open());
        const AxisWords begin = desk.place();
        const auto move = desk.along(90);
        move->start();
        QTRY_VERIFY(desk.place()[0] > begin[0] + 1000);
        desk.cell.orders->hold();
        QTRY_VERIFY(move->isFinished());
        QVERIFY(move->outcome() == Outcome::Stopped);
        QCOMPARE(move->position()->axes[0], desk.place()[0]);
        QVERIFY(desk.cell.server->memory().status.data2 & Status::HeldByCommand); // left on
    }

    void endsOtherwise_data()
    {
        QTest::addColumn<QString>("faults");
        QTest::addColumn<int>("outcome");
        QTest::newRow("refused") << QStringLiteral("0x8A request refuse code=0x2050") << int(Outcome::Refused);
        QTest::newRow("no answer, it moves") << QStringLiteral("0x8A reply lose") << int(Outcome::Unknown);
        QTest::newRow("no answer, it does not") << QStringLiteral("0x8A request lose") << int(Outcome::Unknown);
        QTest::newRow("the line goes dead") << QStringLiteral("any reply lose after=4") << int(Outcome::Unknown);
    }
    void endsOtherwise()
    {
        QFETCH(QString, faults);
        QFETCH(int, outcome);
        Desk desk;
        QVERIFY(desk.open());
        const auto move = desk.along(60);
        QVERIFY(move);
        desk.cell.server->setFaults(*Faults::parse(faults));
        move->start();
        QTRY_VERIFY(move->isFinished());
        QCOMPARE(int(move->outcome()), outcome);
        QVERIFY(desk.arrived() <= 1);
    }

    void withheld()
    {
        Desk desk;
        QVERIFY(desk.open());
        const auto move = desk.along(10);
        desk.cell.arming.drop(robot::Arming::Drop::ByHand);
        move->start();
        QTRY_VERIFY(move->isFinished());
        QVERIFY(move->outcome() == Outcome::Refused);
        QVERIFY(move->error() && move->error()->kind == values::ErrorKind::NotSent);
        QCOMPARE(desk.arrived(), 0);
    }
};

QTEST_GUILESS_MAIN(TestMove)
#include "tst_move.moc"
