// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "virtualcontroller/kinematics.h"
#include "virtualcontroller/memory.h"
#include <QTest>

using namespace virtualcontroller;
using values::AxisWords;
using values::PositionType;

class ProgramTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void readsPositionsAndLines();
    void everyDemoJobIsOne();
    void pulsesAndCartesianWordsBelongTogether();
};

void ProgramTest::readsPositionsAndLines()
{
    const auto job =
        parseProgram("/JOB\r\n//NAME A-1\r\n//POS\r\n///NPOS 2,0,0,1,0,0\r\n///TOOL 3\r\n///POSTYPE PULSE\r\n"
                     "///PULSE\r\nC00000=1,-2,3\r\nC00001=4,5,6\r\n///USER 2\r\n///POSTYPE USER\r\n"
                     "///RECTAN\r\n///RCONF 1,0,0,0,0,0,0,0\r\nP00007=1.5,-2.001,0,180,-0.0001,90.5\r\n"
                     "//INST\r\n///DATE 2026/01/31 08:30\r\n///COMM TEXT\r\n///ATTR SC,RO\r\n"
                     "///GROUP1 RB1\r\nNOP\r\n*TOP\r\nMOVJ C00000 VJ=5.00\r\n'A COMMENT\r\n"
                     "MOVL C00001 V=50.0 PL=0\r\nEND\r\n");
    QVERIFY(job);
    QCOMPARE(job->name, QByteArray("A-1"));
    QVERIFY(job->isReadOnly);
    QCOMPARE(job->positions.at("C00000").axes, (AxisWords {1, -2, 3}));
    QCOMPARE(job->positions.at("C00000").tool, 3U);
    const auto &user = job->positions.at("P00007");
    QVERIFY(user.type == PositionType::User);
    QCOMPARE(user.userFrame, 2U);
    // micrometres and ten-thousandths of a degree (reference §5.1)
    QCOMPARE(user.axes, (AxisWords {1500, -2001, 0, 1'800'000, -1, 905'000}));
    QCOMPARE(job->lines.size(), std::size_t(6));
    QCOMPARE(job->labels.at("*TOP"), 1);
    QCOMPARE(job->lines[4].valueOf("V="), QByteArray("50.0"));
    QCOMPARE(job->lines[4].operand(1), QByteArray("C00001"));
    QCOMPARE(job->stepAt(0), 0);
    QCOMPARE(job->stepAt(2), 1);
    QCOMPARE(job->stepAt(5), 2);
}

void ProgramTest::everyDemoJobIsOne()
{
    int jobs = 0;
    for (const auto &[name, contents] : Memory {}.files) {
        if (!name.endsWith(".JBI"))
            continue;
        ++jobs;
        const auto job = parseProgram(contents);
        QVERIFY2(job, name);
        QCOMPARE(job->name + ".JBI", name);
        QVERIFY2(!QByteArray {contents}.replace("\r\n", "").contains('\n'), name);
    }
    QVERIFY(jobs >= 6);
}

void ProgramTest::pulsesAndCartesianWordsBelongTogether()
{
    const AxisWords pulses {1000, -2000, 3000, -4000, 5000, -6000, 7};
    const AxisWords cartesian {1'090'000, -10'000, 635'000, 1'760'000, 50'000, -60'000, 70};
    QCOMPARE(kinematics::toCartesian(pulses), cartesian);
    QCOMPARE(kinematics::toPulses(cartesian), pulses);
}

QTEST_GUILESS_MAIN(ProgramTest)
#include "tst_program.moc"
