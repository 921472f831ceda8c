// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "inform/references.h"
#include "support/jobs.h"

#include <QTest>

using namespace inform;

namespace {

QString nameOf(const Reference &reference)
{
    QString name = QString::fromLatin1(reference.name);
    if (reference.isAny)
        name.prepend(QStringLiteral("any "));
    if (!reference.element.isEmpty())
        name += QStringLiteral(" element ") + QString::fromLatin1(reference.element);
    return name;
}

QString listOf(const Job &job, int line, bool (*isWanted)(Access))
{
    QStringList names;
    for (const Reference &each : references(job, line)) {
        if (isWanted(each.access))
            names << nameOf(each);
    }
    return names.join(QStringLiteral(", "));
}

} // namespace

/// What each line reads and writes.
class TestReferences : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void refers_data();
    void refers();
    void refersInLines_data();
    void refersInLines();
};

void TestReferences::refers_data()
{
    QTest::addColumn<QString>("job");
    QTest::addColumn<int>("line");
    QTest::addColumn<QString>("reads"); // and calls
    QTest::addColumn<QString>("writes");
    const auto row = [](const char *job, int line, const char *reads, const char *writes) {
        QTest::addRow("%s %d", job, line)
            << QString::fromLatin1(job) << line << QString::fromLatin1(reads) << QString::fromLatin1(writes);
    };
    row("MINIMAL", 0, "", "");
    row("MINIMAL", 1, "", "");
    row("OLDNX", 3, "", "OT#(3)");
    row("OLDNX", 5, "C00002", "");
    row("OLDNX", 7, "IN#(9)", "");
    row("PULSE6", 8, "C00005", "");
    row("PULSE6", 11, "", ""); // COMM
    row("PULSE6", 15, "C00009, IN#(12)", "");
    row("POSTYPES", 5, "P010", "");
    row("POSTYPES", 7, "P005", "P006");
    row("POSTYPES", 8, "I007, any P", "");
    row("RELUSER", 4, "", "P021 element 3");
    row("RELUSER", 5, "P021, UF#(3)", "");
    row("RELUSER", 8, "RELUSER2, UF#(4), B003", "");
    row("R1B1", 3, "C00002, BC00002", "$PX011");
    row("R1B1", 4, "$PX001", "P010, BP010");
    row("R1B1", 5, "IN#(4)", "");
    row("COORD-S1", 2, "C00001, EC00001", "");
    row("COORD-S1", 5, "C00004, EC00004", "$PX021");
    row("COORD-S1", 7, "D010", "EX002 element 1");
    row("TWO-ROBOTS", 2, "C00002, EC00001, C00003", "");
    row("TWO-ROBOTS", 3, "IN#(33)", "");
    row("TWO-ROBOTS", 8, "", "alarm 8021");
    row("R1B1S1", 2, "P060, BP060, EX060", "");
    row("R1B1S1", 4, "LD000", "BP060 element 1");
    row("R1B1S1", 5, "EX060 element 1", "LD001");
    row("SJIS-COMM", 2, "C00000", "");
    row("SJIS-COMM", 3, "", "OT#(25)");
    row("SJIS-COMM", 6, "", "");
    row("ALIASES", 3, "LD000", "LD001");
    row("ALIASES", 8, "ARGS-SUB, LD001", "");
    row("ALIASES", 12, "LD001", "LP000 element 1");
    row("ARGS-SUB", 1, "IARG#(1)", "LD000");
    row("ARGS-SUB", 8, "LD000, LB000", "LD000");
    row("ARGS-SUB", 10, "LD000", "$RV");
    row("MAIN-FLOW", 2, "", "OG#(3)");
    row("MAIN-FLOW", 5, "COORD-S1, IN#(40)", "");
    row("MAIN-FLOW", 10, "B011", "");
    row("STRUCT", 6, "LI000, any D, B020", "");
    row("STRUCT", 23, "", "B021, B022, B023, B024");
    row("STRUCT", 29, "D090, D091", "D091");
    row("IO-ALL", 2, "I010", "any OT#");
    row("IO-ALL", 5, "IGH#(5)", "B032");
    row("IO-ALL", 18, "I014, any IN#", "");
    row("MATH-POS", 2, "P030, UF#(2), TL#(1)", "P031");
    row("MATH-POS", 14, "P036, P037, P038", "UF#(9)");
    row("MATH-POS", 16, "P039", "TL#(5)");
    row("MACRO-GRIP", 3, "LI000, LB000", "any OT#");
    row("MACRO-GRIP", 4, "parameter", "LD000");
    row("MACRO-GRIP", 9, "MJ#(2), LI000", "");
    row("CONVEYOR", 2, "CV#(1)", "");
    row("CONVEYOR", 5, "", "OT#(5)");
    row("CONVEYOR", 7, "C00003, CV#(1)", "");
    row("ARC-WELD", 4, "ASF#(12)", "");
    row("ARC-WELD", 7, "D050", "");
    row("ARC-WELD", 10, "$B002", "B050");
    row("SPOT-GUN", 6, "GUN#(1)", "");
    row("SPOT-GUN", 10, "sensor 1", "$B006");
    row("SPOT-GUN", 11, "$B006", "B060");
}

void TestReferences::refers()
{
    QFETCH(QString, job);
    QFETCH(int, line);
    const Job parsed = parse(testdata::job(job + QStringLiteral(".JBI")));
    QTEST(listOf(parsed, line, [](Access access) { return access != Access::Writes; }), "reads");
    QTEST(listOf(parsed, line, [](Access access) { return access == Access::Writes; }), "writes");
}

/// Forms of reference §5 to §7 that the samples do not have.
void TestReferences::refersInLines_data()
{
    QTest::addColumn<QByteArray>("line");
    QTest::addColumn<QString>("reads");
    QTest::addColumn<QString>("writes");
    const auto row = [](const char *line, const char *reads, const char *writes) {
        QTest::addRow("%s", line) << QByteArray(line) << QString::fromLatin1(reads) << QString::fromLatin1(writes);
    };
    row("EDTLCK COMM DOUT OT#(1) ON", "", "");
    row("EDTLCK \t DOUT OT#(1) B002", "B002", "OT#(1)");
    row("SET B[LB001] 3", "LB001", "any B");
    row("ADD P010 P011", "P010, P011", "P010");
    row("CLEAR B003 10", "", "B003, B004, B005, B006, B007, B008, B009, B010, B011, B012");
    row("CLEAR D000 ALL", "", "D000, any D");
    row("TIMER T=I012", "I012", "");
    row("CALL JOB:X ARGFB012 ARGF-3 ARGF\"B013\"", "X, B012", "");
    row("MOVL P[B001] V=I002 UNTIL IN#(B003)=ON", "B001, any P, I002, B003, any IN#", "");
    row("MOVL C00001 V=9.0 SRCH RIN#(1)=ON T=0.10 DIS=15.0", "C00001, RIN#(1)", "$B002, $PX002, $PX003");
    row("SET R001  EXPRESS ( R002 + R003 ) / -I003", "R002, R003, I003", "R001");
    row("SETE TL#(2) (1) D001", "D001", "TL#(2) element 1");
    row("SETE P001 (B004) 100", "B004", "P001 element B004");
    row("GETFILE D042 WEV#(2) (6)", "WEV#(2) element 6", "D042");
    row("JUMP JOB:NEXT UF#(B001) IF B002=1", "NEXT, B001, any UF#, B002", "");
    row("FOR LI000 START= 0 TO B009", "B009", "LI000");
    row("MSG \"B001 IN#(1)\"", "", "");
    row("MOVJ C00001 VJ=5.00  //B001", "C00001", "");
    row("PALLETON B001 OT#(2)", "B001, OT#(2)", ""); // a word that is not in the table
}

void TestReferences::refersInLines()
{
    QFETCH(QByteArray, line);
    const Job job = parse("/JOB\r\n//INST\r\n///GROUP1 RB1\r\nNOP\r\n" + line + "\r\nEND\r\n");
    QTEST(listOf(job, 1, [](Access access) { return access != Access::Writes; }), "reads");
    QTEST(listOf(job, 1, [](Access access) { return access == Access::Writes; }), "writes");
}

QTEST_GUILESS_MAIN(TestReferences)

#include "tst_references.moc"
