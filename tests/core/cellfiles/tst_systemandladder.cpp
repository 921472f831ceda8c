// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "cellfiles/ladder.h"
#include "cellfiles/logs.h"
#include "cellfiles/systemfile.h"
#include "support/samples.h"
#include <QTest>

using namespace cellfiles;
using protocol::Model;

class SystemAndLadderTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void readsSystems_data();
    void readsSystems();
    void readsHours();
    void readsPanelBox();
    void nulBytes();
    void readsLadder();
    void expandsOperands_data();
    void expandsOperands();
    void readsAlarmTexts();
    void oddLadder();
    void readsLog();
    void translatedLog();
    void cutLog();
    void readsAlarms_data();
    void readsAlarms();
    void miscountedAlarms();
};

namespace {

Ladder ladder(const char *path)
{
    const QByteArray file = samples::read(QString::fromLatin1(path));
    return ladderFrom(file, samples::codec()).value;
}

QStringList written(const LadderInstruction &instruction)
{
    QStringList texts;
    for (const LadderOperand &operand : instruction.writes)
        texts << toString(operand);
    return texts;
}

QDateTime at(const char *text)
{
    return QDateTime::fromString(QString::fromLatin1(text), QStringLiteral("yyyy-MM-dd HH:mm:ss"));
}

} // namespace

void SystemAndLadderTest::readsSystems_data()
{
    QTest::addColumn<QString>("path");
    QTest::addColumn<int>("format");
    QTest::addColumn<QString>("version");
    QTest::addColumn<int>("model");
    QTest::addColumn<QStringList>("mechanisms"); // group, model, mask
    QTest::newRow("YRC1000") << QStringLiteral("yrc1000") << 8 << QStringLiteral("YAS4.50.00A(JP/EN)-00")
                             << int(Model::YRC1000) << QStringList {QStringLiteral("R1 DEMO-R10-A0*(DEMO10) 63")};
    QTest::newRow("YRC1000micro") << QStringLiteral("yrc1000micro") << 8 << QStringLiteral("YBS2.45.00A(JP/EN)-00")
                                  << int(Model::YRC1000micro)
                                  << QStringList {QStringLiteral("R1 DEMO-R4-A0*(DEMO4) 63")};
    QTest::newRow("DX200, two units in one line")
        << QStringLiteral("dx200") << 7 << QStringLiteral("DN2.40.00A(US/PL)-00") << int(Model::DX200)
        << QStringList {
               QStringLiteral("R1 DEMO-R10-A0* 63"), QStringLiteral("B1 RECT-X 1"), QStringLiteral("S1 TURN-1 1")};
    QTest::newRow("DX100, no group names")
        << QStringLiteral("dx100") << 5 << QStringLiteral("DS3.60.00A(US)-00") << int(Model::DX100)
        << QStringList {
               QStringLiteral("R1 DEMO-D7-X0* 127"), QStringLiteral("B1  1"), QStringLiteral("R2 DEMO-D7-Y0* 127")};
    QTest::newRow("FS100") << QStringLiteral("fs100") << 6 << QStringLiteral("FS1.14.00A(JP/US)-00")
                           << int(Model::FS100) << QStringList {QStringLiteral("R1 DEMO-F5-A0* 63")};
}

void SystemAndLadderTest::readsSystems()
{
    QFETCH(QString, path);
    const QByteArray file = samples::read(path + QStringLiteral("/SYSTEM.SYS"));
    const auto parsed = systemFrom(file, samples::codec());
    QCOMPARE(parsed.warnings.count(), 0);
    QTEST(parsed.value.format, "format");
    QTEST(parsed.value.version, "version");
    QTEST(int(parsed.value.generation().value()), "model");
    QCOMPARE(parsed.value.date, at("2024-03-05 15:00:12"));
    QStringList mechanisms;
    for (const Mechanism &mechanism : parsed.value.mechanisms)
        mechanisms << QStringLiteral("%1 %2 %3").arg(mechanism.group, mechanism.model).arg(mechanism.axes);
    QTEST(mechanisms, "mechanisms");
}

void SystemAndLadderTest::readsHours()
{
    using namespace std::chrono_literals;
    const auto system = systemFrom(samples::read(QStringLiteral("yrc1000/SYSTEM.SYS")), samples::codec()).value;
    QVERIFY(system.hoursOf(u"CONTROL POWER", u"TOTAL") == 412h + 33min + 7s);
    QVERIFY(system.hoursOf(u"SERVO POWER", u"R1") == 118h + 4min + 59s);
    QVERIFY(!system.hoursOf(u"SERVO POWER", u"R2"));
    QCOMPARE(system.revisions.size(), 5);
    QCOMPARE(system.applications, QStringList {QStringLiteral("GENERAL")});
}

void SystemAndLadderTest::readsPanelBox()
{
    const auto parsed = panelBoxFrom(samples::read(QStringLiteral("yrc1000/PANELBOX.LOG")), samples::codec());
    QCOMPARE(parsed.value.system.version, QStringLiteral("YAS4.50.00A(JP/EN)-00"));
    QCOMPARE(parsed.value.blocks.size(), 9);
    const auto state = [&](int number) {
        const auto found = std::ranges::find(parsed.value.options, number, &PanelOption::number);
        return found == parsed.value.options.end() ? QString {} : found->state;
    };
    QCOMPARE(state(26), QStringLiteral("7"));
    QCOMPARE(state(46), QStringLiteral("USED"));
    QCOMPARE(state(69), QStringLiteral("NOT USED"));
    QCOMPARE(state(66), QStringLiteral("NOT USED"));
    const PanelBlock &tracking = parsed.value.blocks.last();
    QVERIFY(tracking.title.startsWith(QStringLiteral("CHANGE TRACKING PARAMETER")));
    QVERIFY(tracking.rows[1].contains(QStringLiteral("2024/03/05 14:02:00 SAFETY FUNC")));
    QVERIFY(parsed.value.blocks[2].rows[2].contains(QStringLiteral("01 0128 0128")));
}

void SystemAndLadderTest::nulBytes()
{
    const auto parsed = systemFrom(samples::read(QStringLiteral("damaged/SYSTEM-nul.SYS")), samples::codec());
    QCOMPARE(parsed.value.version, QStringLiteral("YAS4.50.00A(JP/EN)-00"));
    QCOMPARE(parsed.value.date, at("2024-03-05 15:00:12"));
    QVERIFY(!parsed.warnings.isEmpty());
    QCOMPARE(parsed.warnings.list().first().line, 7);
}

void SystemAndLadderTest::readsLadder()
{
    const QByteArray file = samples::read(QStringLiteral("yrc1000/CIOPRG.LST"));
    const auto parsed = ladderFrom(file, samples::codec());
    QCOMPARE(parsed.warnings.count(), 0);
    const Ladder &read = parsed.value;
    QCOMPARE(read.name, QStringLiteral("DEMO CELL"));
    QCOMPARE(read.application, QByteArray {"GENERAL"});
    QCOMPARE(read.presets.first(), (QList<qint64> {30, 10, 2, 3, 5, 1, 1, 3, 0, 0}));
    QCOMPARE(read.instructions.size(), 39);
    QCOMPARE(read.instructions.first().line, 16);
    QCOMPARE(read.instructions[13].line, 30);
    QCOMPARE(read.instructions[13].text(), QByteArray {"AND #20017"});
    QCOMPARE(read.instructions.first().part, 1);
    QCOMPARE(read.instructions.last().part, 2);
    QStringList all;
    for (const LadderInstruction &instruction : read.instructions)
        all += written(instruction);
    QStringList expected {QStringLiteral("#70025"), QStringLiteral("#40057"), QStringLiteral("#40042"),
        QStringLiteral("#40056"), QStringLiteral("#00010"), QStringLiteral("#30010"), QStringLiteral("M100"),
        QStringLiteral("#70016"), QStringLiteral("M101"), QStringLiteral("#70015"), QStringLiteral("M150")};
    for (int bit = 0; bit < 16; ++bit)
        expected << QStringLiteral("#%1").arg(79780 + bit / 8 * 10 + bit % 8);
    for (int bit = 0; bit < 8; ++bit)
        expected << QStringLiteral("#0004%1").arg(bit);
    for (int bit = 0; bit < 24; ++bit)
        expected << QStringLiteral("#000%1%2").arg(5 + bit / 8).arg(bit % 8);
    QCOMPARE(all, expected);
}

void SystemAndLadderTest::expandsOperands_data()
{
    QTest::addColumn<QByteArray>("instruction");
    QTest::addColumn<int>("reads");
    QTest::addColumn<int>("writes");
    QTest::addColumn<bool>("isUnderstood");
    QTest::newRow("bit") << QByteArray("OUT #00010") << 0 << 1 << true;
    QTest::newRow("group") << QByteArray("GSTR #20040") << 8 << 0 << true;
    QTest::newRow("all groups") << QByteArray("BMOV #20030,510,#00010") << 4080 << 4080 << true;
    QTest::newRow("join") << QByteArray("OR-STR") << 0 << 0 << true;
    QTest::newRow("sum") << QByteArray("ADD M000,M001,M002") << 2 << 1 << true;
    QTest::newRow("four digits") << QByteArray("OUT #3001") << 0 << 0 << false;
    QTest::newRow("bit 8") << QByteArray("OUT #30018") << 0 << 0 << false;
    QTest::newRow("no operand") << QByteArray("OUT") << 0 << 0 << false;
    QTest::newRow("unknown") << QByteArray("XYZZY #30010,5") << 0 << 0 << false;
    QTest::newRow("endless") << QByteArray("BMOV #20030,999999999,#00010") << 8000 << 8000 << true;
}

void SystemAndLadderTest::expandsOperands()
{
    QFETCH(QByteArray, instruction);
    const QByteArray file = "/CIOPRG YAS\r\n//KEY 0\r\nPART 1\r\n" + instruction + "\r\nEND\r\n";
    const auto parsed = ladderFrom(file, samples::codec());
    QCOMPARE(parsed.value.instructions.size(), 1);
    const LadderInstruction &found = parsed.value.instructions.first();
    QTEST(int(found.reads.size()), "reads");
    QTEST(int(found.writes.size()), "writes");
    QTEST(found.isUnderstood, "isUnderstood");
}

void SystemAndLadderTest::readsAlarmTexts()
{
    const Ladder read = ladder("yrc1000/CIOPRG.LST");
    QCOMPARE(read.texts["ALARM1"].value(0), QStringLiteral("AIR PRESSURE LOW"));
    QCOMPARE(read.texts["ALARM1"].value(127), QStringLiteral("GRIPPER NOT REFERENCED"));
    QCOMPARE(read.texts["ALARM2"].value(0), QStringLiteral("DRUCKLUFT FEHLT"));
    QCOMPARE(read.texts["MESSAGE1"].value(3), QStringLiteral("FILL MAGAZINE"));
    QCOMPARE(read.textRows["ALARM1"], 128);
    const Ladder dx100 = ladder("dx100/CIOPRG.LST");
    QVERIFY(dx100.application.isEmpty());
    QVERIFY(dx100.texts["ALARM1"].contains(1));
    QCOMPARE(ladder("dx200/CIOPRG.LST").tag, QByteArray {"DN"});
}

void SystemAndLadderTest::oddLadder()
{
    const QByteArray file = samples::read(QStringLiteral("damaged/CIOPRG-unknown.LST"));
    const auto parsed = ladderFrom(file, samples::codec());
    QCOMPARE(parsed.value.instructions.size(), 4); // kept in their places
    QVERIFY(parsed.value.instructions[0].isUnderstood);
    QCOMPARE(parsed.value.instructions[0].text(), QByteArray {"STR #20010"});
    QCOMPARE(parsed.warnings.count(), 3);
    QCOMPARE(parsed.warnings.list().first().line, 17);
    QCOMPARE(parsed.value.textRows["ALARM1"], 10);
}

void SystemAndLadderTest::readsLog()
{
    const QByteArray file = samples::read(QStringLiteral("yrc1000/LOGDATA.DAT"));
    const auto parsed = logFrom(file, samples::codec());
    QCOMPARE(parsed.warnings.count(), 0);
    const QList<LogEntry> &log = parsed.value;
    QCOMPARE(log.size(), 15);
    QCOMPARE(log[0].date, at("2024-03-05 14:22:07"));
    QCOMPARE(log[0].event, QStringLiteral("STOP"));
    QCOMPARE(log[0].value(u"STOP FACTOR"), QStringLiteral("HOLD"));
    QCOMPARE(log[0].value(u"LINE"), QStringLiteral("0012"));
    QCOMPARE(log[3].event, QStringLiteral("JOB EDIT(P. MOD)"));
    QVERIFY(log[3].fields.last().block.first().endsWith(QStringLiteral("41000")));
    QVERIFY(log[6].fields.last().block[2].contains(QStringLiteral("500.000 --> R1 :X     512.250")));
    QCOMPARE(log[7].value(u"ELEMENT NUMBER"), QStringLiteral("2-1-2"));
    QCOMPARE(log[7].value(u"AFTER EDIT"), QStringLiteral("163250"));
    QCOMPARE(log[10].value(u"PARAMETER KIND"), QStringLiteral("RS"));
    QVERIFY(log[13].isNoise());
    QVERIFY(!log[7].isNoise());
    const auto later = logFrom(samples::read(QStringLiteral("yrc1000-later/LOGDATA.DAT")), samples::codec()).value;
    QCOMPARE(later.size(), 19);
    QVERIFY(later.sliced(4) == log); // matched by content, not by number
}

void SystemAndLadderTest::translatedLog()
{
    const auto parsed = logFrom(samples::read(QStringLiteral("dx200/LOGDATA.DAT")), samples::codec());
    QCOMPARE(parsed.warnings.count(), 0);
    QCOMPARE(parsed.value.size(), 2);
    QCOMPARE(parsed.value[0].date, at("2024-03-05 15:00:12"));
    QCOMPARE(parsed.value[0].event, QStringLiteral("ZAK. ZAPISU PLIKU"));
    QCOMPARE(parsed.value[0].fields[0].value, QStringLiteral("TOOL.CND"));
}

void SystemAndLadderTest::cutLog()
{
    const auto parsed = logFrom(samples::read(QStringLiteral("damaged/LOGDATA-cut.DAT")), samples::codec());
    QCOMPARE(parsed.value.size(), 7);
    QCOMPARE(int(std::ranges::count_if(parsed.value, &LogEntry::isWhole)), 6);
    QVERIFY(!parsed.value[6].isWhole);
    QCOMPARE(parsed.value[3].event, QStringLiteral("JOB EDIT(P. MOD)")); // the order is that of the file
    QCOMPARE(parsed.value[4].event, QStringLiteral("JOB EDIT(DEL)"));
}

void SystemAndLadderTest::readsAlarms_data()
{
    QTest::addColumn<QString>("path");
    QTest::addColumn<QStringList>("records"); // section, code, group, detail, mode, job, line, step, state, date
    QTest::newRow("YRC1000")
        << QStringLiteral("yrc1000/ALMHIST.DAT")
        << QStringList {QStringLiteral("MAJOR 1377 ROBOT1 [SLURBT] PLAY DEMO_MAIN 4 2 STOP 2024/03/01 07:05:09"),
               QStringLiteral("MINOR 4107 ROBOT1 [L] TEACH DEMO_MAIN 4 2 E.STOP 2024/02/11 16:40:00"),
               QStringLiteral("MINOR 4107 ROBOT1 [L] TEACH DEMO_MAIN 4 2 E.STOP 2024/02/11 16:40:00"),
               QStringLiteral("IO_USR 9127   PLAY HOME_ALL 0 0 STOP 2024/03/04 11:12:13"),
               QStringLiteral("OFFLINE 320  [16] TEACH  0 0  2023/12/24 08:00:00")};
    QTest::newRow("DX100, short records, a header twice")
        << QStringLiteral("dx100/ALMHIST.DAT")
        << QStringList {QStringLiteral("MAJOR 1377 ROBOT1 [SLURBT]  DEMO_MAIN 4 2  2024/03/01 07:05"),
               QStringLiteral("MINOR 4107 ROBOT1 [L]  DEMO_MAIN 4 2  2024/02/11 16:40"),
               QStringLiteral("MINOR 4107 ROBOT1 [L]  DEMO_MAIN 4 2  2024/02/11 16:40"),
               QStringLiteral("IO_USR 9001    HOME_ALL 0 0  2024/03/04 11:12"),
               QStringLiteral("OFFLINE 320  [16]   0 0  2023/12/24 08:00")};
}

void SystemAndLadderTest::readsAlarms()
{
    QFETCH(QString, path);
    const QByteArray file = samples::read(path);
    const auto parsed = alarmHistoryFrom(file, samples::codec());
    QCOMPARE(parsed.warnings.count(), 0);
    QStringList records;
    for (const AlarmRecord &record : parsed.value)
        records << QStringLiteral("%1 %2 %3 %4 %5 %6 %7 %8 %9 ")
                       .arg(QString::fromLatin1(record.section))
                       .arg(record.code)
                       .arg(record.group, record.detail, record.mode, record.job)
                       .arg(record.jobLine)
                       .arg(record.step)
                       .arg(record.state)
                + record.date;
    QTEST(records, "records");
}

void SystemAndLadderTest::miscountedAlarms()
{
    const auto parsed =
        alarmHistoryFrom(samples::read(QStringLiteral("damaged/ALMHIST-badcount.DAT")), samples::codec());
    QCOMPARE(parsed.value.size(), 5);
    QCOMPARE(parsed.warnings.count(), 1);
    QCOMPARE(parsed.warnings.list().first().line, 2);
    const auto user = std::ranges::find(parsed.value, QByteArray {"IO_USR"}, &AlarmRecord::section);
    QCOMPARE(user->task, QStringLiteral("TASK#0"));
    const auto polish = alarmHistoryFrom(samples::read(QStringLiteral("dx200/ALMHIST.DAT")), samples::codec());
    QCOMPARE(polish.value.first().code, 1377);
    QCOMPARE(polish.warnings.count(), 0);
}

QTEST_APPLESS_MAIN(SystemAndLadderTest)
#include "tst_systemandladder.moc"
