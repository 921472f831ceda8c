// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "support/cell.h"
#include <QSignalSpy>

using namespace std::chrono_literals;
using namespace robot;
using journal::Outcome;
using values::ErrorKind;
using values::Result;
using values::Status;
using virtualcontroller::Direction;
using virtualcontroller::FaultKind;
using virtualcontroller::Faults;

namespace {

/// Keeps what a handler was told, and how often.
struct Told {
    int count = 0;
    Result<void> result;

    OrderHandler handler()
    {
        return [this](const Result<void> &told) {
            ++count;
            result = told;
        };
    }
};

} // namespace

class TestOrders : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void sendsOnceAndRecords()
    {
        Cell cell;
        QVERIFY(cell.live());
        Told told;
        const Order order {Act::SelectCycle, {}, QStringLiteral("one cycle"), QStringLiteral("step")};
        cell.orders->send(protocol::SelectCycle {values::CycleMode::Step}, order, this, told.handler());
        QCOMPARE(told.count, 0); // never from inside
        QTRY_COMPARE(told.count, 1);
        QVERIFY(told.result.has_value());
        QVERIFY(cell.server->memory().status.data1 & Status::Step);
        QCOMPARE(cell.server->arrived(0x84), 1);
        QCOMPARE(cell.records.size(), 1);
        const journal::OrderRecord &record = cell.records.constFirst();
        QVERIFY(record.outcome == Outcome::Done);
        QCOMPARE(record.action, QStringLiteral("select-cycle"));
        QCOMPARE(record.controller, QStringLiteral("CELL 4"));
        QCOMPARE(record.level, QStringLiteral("Engineer"));
        QCOMPARE(record.oldValue, QStringLiteral("one cycle"));
        QCOMPARE(record.newValue, QStringLiteral("step"));
        QVERIFY(record.at.timeSpec() == Qt::UTC);
        QVERIFY(!record.host.isEmpty());
    }

    void withholdsWhatAConditionForbids()
    {
        Cell cell;
        QVERIFY(cell.live(Level::Monitor));
        Told told;
        cell.orders->send(protocol::ResetAlarm {}, {Act::ResetAlarm}, this, told.handler());
        QCOMPARE(told.count, 0);
        QTRY_COMPARE(told.count, 1);
        QVERIFY(told.result.error().kind == ErrorKind::NotSent);
        QCOMPARE(cell.server->arrived(0x82), 0);
        QVERIFY(cell.records.constFirst().outcome == Outcome::Withheld);
        QCOMPARE(cell.records.constFirst().reply, QStringLiteral("The access level is Operate or Engineer"));
        QCOMPARE(cell.records.constFirst().level, QStringLiteral("Monitor"));
    }

    void withholdsWithoutALink()
    {
        Cell cell;
        cell.controller->close();
        Told told;
        cell.orders->send(protocol::ResetAlarm {}, {Act::ResetAlarm}, this, told.handler());
        QTRY_COMPARE(told.count, 1);
        QVERIFY(told.result.error().kind == ErrorKind::NotSent);
        int reads = 0;
        cell.orders->read(protocol::ReadStatus {}, this, [&](const Result<Status> &status) {
            ++reads;
            QVERIFY(status.error().kind == ErrorKind::NotSent);
        });
        QCOMPARE(reads, 0);
        QTRY_COMPARE(reads, 1);
    }

    void startsOnlyWhenArmed()
    {
        Cell cell;
        QVERIFY(cell.live());
        Told told;
        cell.orders->send(protocol::StartJob {}, {Act::StartJob}, this, told.handler());
        QTRY_COMPARE(told.count, 1);
        QCOMPARE(cell.records.constLast().reply, QStringLiteral("This controller is armed"));
        QVERIFY(cell.orders->arm());
        cell.server->memory().tasks.front().stack.clear();
        QTRY_VERIFY(cell.orders->obstacle(Act::StartJob) == Condition::JobSet);
        cell.orders->send(protocol::StartJob {}, {Act::StartJob}, this, told.handler());
        QTRY_COMPARE(told.count, 2);
        QCOMPARE(cell.server->arrived(0x86), 0);
        const values::JobSelection job {values::JobName {"HOME"}, 0};
        cell.orders->send(protocol::SelectJob {job}, {Act::SelectJob, QStringLiteral("HOME")}, this, told.handler());
        QTRY_COMPARE(told.count, 3);
        QVERIFY(told.result.has_value());
        QTRY_VERIFY(!cell.orders->obstacle(Act::StartJob));
        cell.orders->send(protocol::StartJob {}, {Act::StartJob, QStringLiteral("HOME")}, this, told.handler());
        QTRY_COMPARE(told.count, 4);
        QVERIFY(told.result.has_value());
        QCOMPARE(cell.server->arrived(0x86), 1);
    }

    void refusalsAreRecorded()
    {
        Cell cell;
        QVERIFY(cell.live());
        Told told;
        const values::JobSelection job {values::JobName {"GONE"}, 0};
        cell.orders->send(protocol::SelectJob {job}, {Act::SelectJob, QStringLiteral("GONE")}, this, told.handler());
        QTRY_COMPARE(told.count, 1);
        QVERIFY(told.result.error().kind == ErrorKind::Refused);
        const journal::OrderRecord &record = cell.records.constFirst();
        QVERIFY(record.outcome == Outcome::Refused);
        QCOMPARE(int(record.added), 0x4040);
        QCOMPARE(record.subject, QStringLiteral("GONE"));
        QVERIFY(!record.reply.isEmpty());
    }

    void aLostReplyIsUnknownAndNeverRepeated()
    {
        Cell cell;
        QVERIFY(cell.armed());
        cell.server->setFaults(Faults {{{0x86, Direction::Reply, FaultKind::Lose}}});
        Told told;
        cell.orders->send(protocol::StartJob {}, {Act::StartJob}, this, told.handler());
        QTRY_COMPARE(told.count, 1);
        QVERIFY(told.result.error().kind == ErrorKind::UnknownOutcome);
        QVERIFY(cell.records.constFirst().outcome == Outcome::Unknown);
        QCOMPARE(cell.server->arrived(0x86), 1);
        QTRY_VERIFY(cell.orders->situation().status->isRunning()); // the status tells the truth
    }

    void aLostLinkMakesWhatIsOpenUnknown()
    {
        Cell cell;
        QVERIFY(cell.armed());
        cell.server->setFaults(Faults {{{0x86, Direction::Reply, FaultKind::Lose}}});
        Told told;
        cell.orders->send(protocol::StartJob {}, {Act::StartJob}, this, told.handler());
        QTRY_COMPARE(cell.server->arrived(0x86), 1);
        cell.controller->close();
        QCOMPARE(told.count, 1);
        QVERIFY(told.result.error().kind == ErrorKind::UnknownOutcome);
        QVERIFY(!cell.orders->isArmed());
        QVERIFY(cell.orders->lastDrop()->reason == Arming::Drop::Disconnected);
        cell.controller->open();
        QTRY_VERIFY(cell.orders->situation().isLinkUp);
        QVERIFY(!cell.orders->isArmed()); // reconnecting resumes reading only
        QCOMPARE(cell.server->arrived(0x86), 1);
        QCOMPARE(told.count, 1);
    }

    void aGoneContextIsNotTold()
    {
        Cell cell;
        QVERIFY(cell.live());
        Told told;
        {
            QObject context;
            cell.orders->send(protocol::ResetAlarm {}, {Act::ResetAlarm}, &context, told.handler());
        }
        QTRY_COMPARE(cell.records.size(), 1); // what was ordered is recorded all the same
        QVERIFY(cell.records.constFirst().outcome == Outcome::Done);
        QCOMPARE(told.count, 0);
    }

    void dyingRecordsWhatIsOpen()
    {
        Cell cell;
        QVERIFY(cell.armed());
        cell.server->setFaults(Faults {{{{}, Direction::Request, FaultKind::Lose}}});
        Told told;
        cell.orders->send(protocol::ResetAlarm {}, {Act::ResetAlarm}, this, told.handler());
        QSignalSpy dropped {&cell.arming, &Arming::dropped};
        cell.orders.reset();
        QCOMPARE(cell.records.size(), 1);
        QVERIFY(cell.records.constFirst().outcome == Outcome::Unknown);
        QVERIFY(!cell.arming.isArmed());
        QVERIFY(dropped.constFirst().at(1).value<Arming::Drop>() == Arming::Drop::Disconnected);
    }

    void readsBack()
    {
        Cell cell;
        QVERIFY(cell.live());
        bool isRead = false;
        cell.orders->read(
            protocol::ReadStatus {}, this, [&](const Result<Status> &status) { isRead = status.has_value(); });
        QVERIFY(!isRead);
        QTRY_VERIFY(isRead);
    }

    void aReadEndsWithTheLink()
    {
        Cell cell;
        QVERIFY(cell.live());
        cell.server->setFaults(Faults {{{0x72, Direction::Reply, FaultKind::Lose}}});
        int count = 0;
        cell.orders->read(protocol::ReadStatus {}, this, [&](const Result<Status> &status) {
            ++count;
            QVERIFY(status.error().kind == ErrorKind::NoAnswer);
        });
        cell.controller->close();
        QCOMPARE(count, 1);
        QCoreApplication::processEvents();
        QCOMPARE(count, 1);
    }

    void stoppingNeedsNoLevel()
    {
        Cell cell;
        QVERIFY(cell.live(Level::Monitor));
        cell.orders->hold();
        cell.orders->hold(); // again: one record
        QTRY_VERIFY(cell.controller->holdState().word == HoldWord::HeldByCommand);
        QCOMPARE(cell.records.size(), 1);
        QCOMPARE(cell.records.constFirst().action, QStringLiteral("hold"));
        QVERIFY(cell.records.constFirst().outcome == Outcome::Done);
        Told told;
        cell.orders->servoOff(this, told.handler());
        QTRY_COMPARE(told.count, 1);
        QVERIFY(told.result.has_value());
        QVERIFY(!cell.server->memory().status.isServoOn());
        QCOMPARE(cell.records.constLast().action, QStringLiteral("servo-off"));
    }

    void servoOffWithoutALinkIsUnknown()
    {
        Cell cell;
        QVERIFY(cell.live());
        cell.controller->close();
        Told told;
        cell.orders->servoOff(this, told.handler());
        QCOMPARE(told.count, 0);
        QTRY_COMPARE(told.count, 1);
        QVERIFY(told.result.error().kind == ErrorKind::UnknownOutcome);
    }

    void remembersThePendantLock()
    {
        Cell cell;
        QVERIFY(cell.live());
        QSignalSpy changes {cell.orders.get(), &Orders::pendantLockChanged};
        cell.orders->send(protocol::HlockOn {}, {Act::HlockOn}, this, {});
        QTRY_VERIFY(cell.orders->isPendantLocked());
        QVERIFY(cell.server->memory().interlocks.isPendantLocked);
        cell.access.enter(Level::Monitor); // giving back needs no level
        cell.orders->send(protocol::HlockOff {}, {Act::HlockOff}, this, {});
        QTRY_VERIFY(!cell.orders->isPendantLocked());
        QCOMPARE(changes.count(), 2);
    }

    /// One confirmation, one order, whatever waits in an event queue.
    void theSameOrderIsNotSentTwice()
    {
        Cell cell;
        QVERIFY(cell.armed());
        cell.server->memory().status.data2.setFlag(Status::ServoOn, false);
        Told first;
        Told second;
        for (Told *told : {&first, &second})
            cell.orders->send(protocol::ServoOn {}, {Act::ServoOn}, this, told->handler());
        QTRY_COMPARE(first.count + second.count, 2);
        QVERIFY(first.result.has_value());
        QVERIFY(second.result.error().kind == ErrorKind::NotSent);
        QCOMPARE(cell.server->arrived(0x83), 1);
        Told third; // the first has ended
        cell.orders->send(protocol::ServoOn {}, {Act::ServoOn}, this, third.handler());
        QTRY_COMPARE(third.count, 1);
        QVERIFY(third.result.has_value());
    }

    void othersAreSentBesideIt()
    {
        Cell cell;
        QVERIFY(cell.live());
        const auto begin = [&](const char *file) {
            return cell.orders->begin({Act::Upload, QLatin1String(file)}, this, {});
        };
        Attempt *one = begin("A.JBI");
        QVERIFY(one && !begin("A.JBI") && begin("B.JBI"));
        one->end({});
        QVERIFY(begin("A.JBI"));
    }

    void anotherWayIsCheckedAndRecordedToo()
    {
        Cell cell;
        QVERIFY(cell.live(Level::Operate));
        Told told;
        QVERIFY(!cell.orders->begin({Act::Upload, QStringLiteral("A.JBI")}, this, told.handler()));
        QTRY_COMPARE(told.count, 1);
        cell.access.enter(Level::Engineer);
        Attempt *attempt = cell.orders->begin({Act::Upload, QStringLiteral("A.JBI")}, this, told.handler());
        QVERIFY(attempt);
        attempt->end({});
        QCOMPARE(told.count, 2);
        Attempt *forgotten = cell.orders->begin({Act::DeleteFile, QStringLiteral("A.JBI")}, this, told.handler());
        delete forgotten;
        QVERIFY(cell.records.constLast().outcome == Outcome::Unknown);
        QCOMPARE(cell.records.size(), 3);
    }
};

QTEST_GUILESS_MAIN(TestOrders)
#include "tst_orders.moc"
