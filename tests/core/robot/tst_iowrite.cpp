// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "robot/iowrite.h"

#include "core/robot/desk.h"

using namespace robot;
using values::ErrorKind;
using virtualcontroller::Direction;
using virtualcontroller::FaultKind;
using virtualcontroller::Faults;

/// One signal of a group of eight network inputs.
class TestIoWrite : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void aBitIsWritten();
    void aGroupThatChangesMeanwhile();
    void refusalsAndSilence();
};

void TestIoWrite::aBitIsWritten()
{
    Desk desk;
    QVERIFY(desk.live());
    desk.server->memory().io[2701] = 0b1000'0001;
    IoWrite write {*desk.orders, {2701, 3}};
    write.read();
    QTRY_VERIFY(write.step() == IoWrite::Step::Ready);
    QCOMPARE(write.before()->bits, 0b1000'0001);
    QCOMPARE(write.after()->bits, 0b1000'1001);
    write.write();
    QTRY_VERIFY(write.step() == IoWrite::Step::Done);
    QCOMPARE(desk.server->memory().io[2701], 0b1000'1001);
    QCOMPARE(desk.writes(), 1);
    QCOMPARE(desk.records.constLast().subject, QStringLiteral("#27013"));
    write.write(); // done is done
    QVERIFY(write.step() == IoWrite::Step::Done);
}

void TestIoWrite::aGroupThatChangesMeanwhile()
{
    Desk desk;
    QVERIFY(desk.live());
    IoWrite write {*desk.orders, {2701, 3}};
    write.read();
    QTRY_VERIFY(write.step() == IoWrite::Step::Ready);
    desk.server->memory().io[2701] = 0b0000'0100;
    write.write();
    QTRY_VERIFY(write.step() == IoWrite::Step::Changed);
    QCOMPARE(desk.writes(), 0);
    QCOMPARE(write.after()->bits, 0b0000'1100);
    write.write();
    QTRY_VERIFY(write.step() == IoWrite::Step::Done);
    QCOMPARE(desk.server->memory().io[2701], 0b0000'1100);
}

void TestIoWrite::refusalsAndSilence()
{
    Desk desk;
    QVERIFY(desk.live());
    // An output: the page never asks for it, the controller would refuse.
    IoWrite output {*desk.orders, {1001, 0}};
    output.read();
    QTRY_VERIFY(output.step() == IoWrite::Step::Ready);
    output.write();
    QTRY_VERIFY(output.step() == IoWrite::Step::Refused);
    QVERIFY(output.error().kind == ErrorKind::Refused);
    // Without an answer nobody knows.
    IoWrite lost {*desk.orders, {2701, 0}};
    lost.read();
    QTRY_VERIFY(lost.step() == IoWrite::Step::Ready);
    desk.server->setFaults(Faults {{{0x78, Direction::Reply, FaultKind::Lose, 1, 1, 1}}});
    lost.write();
    QTRY_VERIFY(lost.step() == IoWrite::Step::Unknown);
    // Monitor may not.
    desk.access.enter(Level::Monitor);
    IoWrite monitor {*desk.orders, {2701, 0}};
    monitor.read();
    QTRY_VERIFY(monitor.step() == IoWrite::Step::Ready);
    monitor.write();
    QTRY_VERIFY(monitor.step() == IoWrite::Step::Failed);
    QVERIFY(monitor.error().kind == ErrorKind::NotSent);
}

QTEST_GUILESS_MAIN(TestIoWrite)
#include "tst_iowrite.moc"
