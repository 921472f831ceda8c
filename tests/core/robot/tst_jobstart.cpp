// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "robot/jobstart.h"
#include "support/cell.h"

using namespace std::chrono_literals;
using robot::JobStart;
using values::ErrorKind;
using values::Status;
using virtualcontroller::Direction;
using virtualcontroller::FaultKind;
using virtualcontroller::Faults;
using Phase = JobStart::Phase;

namespace {

QList<int> phasesOf(Cell &cell, JobStart &start)
{
    QList<int> phases;
    QObject::connect(&start, &JobStart::phaseChanged, cell.orders.get(), [&] { phases << int(start.phase()); });
    start.start();
    if (!QTest::qWaitFor([&] { return start.isFinished(); }, 8000))
        return {};
    return phases;
}

} // namespace

class TestJobStart : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void runs()
    {
        Cell cell;
        QVERIFY(cell.armed());
        JobStart start {*cell.orders, QStringLiteral("WELD_A12")};
        const QList<int> phases = phasesOf(cell, start);
        QCOMPARE(phases, (QList<int> {int(Phase::Waiting), int(Phase::Running)}));
        QCOMPARE(cell.server->arrived(0x86), 1);
        QCOMPARE(cell.records.constLast().subject, QStringLiteral("WELD_A12"));
    }

    void acceptedButNotRunning()
    {
        Cell cell;
        QVERIFY(cell.armed());
        JobStart start {*cell.orders, {}};
        connect(&start, &JobStart::phaseChanged, this, [&] {
            cell.server->memory().isJobRunning = false; // as if it were held up at once
            cell.server->memory().status.data1.setFlag(Status::Running, false);
            cell.server->setFaults(Faults {});
        });
        cell.server->setFaults(Faults {{{.command = 0x72, .kind = FaultKind::Delay, .time = 150ms}}});
        const QList<int> phases = phasesOf(cell, start);
        QCOMPARE(phases, (QList<int> {int(Phase::Waiting), int(Phase::NotRunning)}));
    }

    void refused_data()
    {
        QTest::addColumn<quint16>("code");
        for (const int code : {0x2100, 0x2080, 0x2060, 0x2020, 0x2030, 0x2040, 0x2050, 0x2070, 0x2010, 0x4060, 0x3040,
                 0x3230, 0x3010, 0xFFFE})
            QTest::addRow("0x%04x", code) << quint16(code);
    }

    /// Each code that reference §10.2 names for a start, met by the controller only.
    void refused()
    {
        QFETCH(quint16, code);
        Cell cell;
        QVERIFY(cell.armed());
        cell.server->setFaults(
            Faults {{{.command = 0x86, .direction = Direction::Request, .kind = FaultKind::Refuse, .code = code}}});
        JobStart start {*cell.orders, {}};
        QCOMPARE(phasesOf(cell, start), QList<int> {int(Phase::Refused)});
        QCOMPARE(start.error()->addedStatus, code);
        QCOMPARE(cell.server->arrived(0x86), 1);
        QVERIFY(!cell.server->memory().status.isRunning());
    }

    void withheld()
    {
        Cell cell;
        QVERIFY(cell.live());
        JobStart start {*cell.orders, {}};
        QCOMPARE(phasesOf(cell, start), QList<int> {int(Phase::Refused)});
        QVERIFY(start.error()->kind == ErrorKind::NotSent);
        QCOMPARE(cell.server->arrived(0x86), 0);
    }

    /// The reply is lost after the controller started.
    void unknownAndRunning()
    {
        Cell cell;
        QVERIFY(cell.armed());
        cell.server->setFaults(Faults {{{.command = 0x86, .direction = Direction::Reply}}});
        JobStart start {*cell.orders, {}};
        QCOMPARE(phasesOf(cell, start), (QList<int> {int(Phase::Asking), int(Phase::UnknownRunning)}));
        QCOMPARE(cell.server->arrived(0x86), 1);
    }

    /// The order is lost before the controller could start.
    void unknownAndNotRunning()
    {
        Cell cell;
        QVERIFY(cell.armed());
        cell.server->setFaults(Faults {{{.command = 0x86, .direction = Direction::Request}}});
        JobStart start {*cell.orders, {}};
        QCOMPARE(phasesOf(cell, start), (QList<int> {int(Phase::Asking), int(Phase::UnknownNotRunning)}));
        QCOMPARE(cell.server->arrived(0x86), 1);
        QVERIFY(!cell.server->memory().status.isRunning());
    }

    void unknownForGood()
    {
        Cell cell;
        QVERIFY(cell.armed());
        JobStart start {*cell.orders, {}};
        cell.server->setFaults(Faults {{{.command = 0x86}, {.command = 0x72}}});
        QCOMPARE(phasesOf(cell, start), (QList<int> {int(Phase::Asking), int(Phase::UnknownStatus)}));
        QCOMPARE(cell.server->arrived(0x86), 1);
    }

    /// The person at the pendant turns the key between the click and the order.
    void theModeChangesInBetween()
    {
        Cell cell;
        QVERIFY(cell.armed());
        auto &data1 = cell.server->memory().status.data1;
        data1 = Status::Data1 {Status::Teach} | Status::Continuous;
        JobStart start {*cell.orders, {}};
        QCOMPARE(phasesOf(cell, start), QList<int> {int(Phase::Refused)});
        QVERIFY(!cell.server->memory().status.isRunning());
        QTRY_VERIFY(!cell.orders->isArmed());
    }

    /// 30 % of all packets are lost: whatever becomes of a start, it arrives once at the most.
    void neverTwiceUnderLoss()
    {
        for (quint32 seed = 1; seed <= 8; ++seed) {
            Cell cell;
            QVERIFY(cell.armed());
            cell.server->setFaults(Faults {{{.command = {}, .direction = Direction::Request, .probability = 0.3},
                                               {.command = {}, .probability = 0.3}},
                seed});
            JobStart start {*cell.orders, {}};
            QVERIFY(!phasesOf(cell, start).isEmpty());
            QVERIFY(cell.server->arrived(0x86) <= 1);
            QCOMPARE(cell.records.count(), 1);
        }
    }
};

QTEST_GUILESS_MAIN(TestJobStart)
#include "tst_jobstart.moc"
