// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "inform/check.h"
#include "support/jobs.h"

#include <QTest>

using namespace inform;

namespace {

QString latin1(QByteArrayView bytes) { return QString::fromLatin1(bytes); }

/// A job of these lines between NOP and END, with two points.
QByteArray jobOf(const QByteArray &lines)
{
    return "/JOB\r\n//NAME A\r\n//POS\r\n///NPOS 2,0,0,0,0,0\r\n///TOOL 0\r\n///POSTYPE PULSE\r\n///PULSE\r\n"
           "C00000=0,0,0,0,0,0\r\nC00001=0,0,0,0,0,0\r\n//INST\r\n///DATE 2026/01/12 08:30\r\n///ATTR SC,RW\r\n"
           "///GROUP1 RB1\r\n///LVARS 1,0,0,0,0,0,0,0\r\nNOP\r\nMOVJ C00000 VJ=5.00\r\nCOMM MOVJ C00001 VJ=5.00\r\n"
        + lines + "END\r\n";
}

} // namespace

/// What is found in jobs before they are sent (reference §10.1).
class TestCheck : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void passesSamples_data();
    void passesSamples();
    void findsOneFault_data();
    void findsOneFault();
    void checksLines_data();
    void checksLines();
    void bearsSize_data();
    void bearsSize();
};

void TestCheck::passesSamples_data()
{
    QTest::addColumn<QString>("name");
    for (const char *name : {"MINIMAL", "OLDNX", "PULSE6", "POSTYPES", "RELUSER", "R1B1", "COORD-S1", "TWO-ROBOTS",
             "R1B1S1", "SJIS-COMM", "ALIASES", "ARGS-SUB", "MAIN-FLOW", "STRUCT", "IO-ALL", "MATH-POS", "MACRO-GRIP",
             "CONVEYOR", "ARC-WELD", "SPOT-GUN"})
        QTest::newRow(name) << QString::fromLatin1(name);
}

void TestCheck::passesSamples()
{
    QFETCH(QString, name);
    for (const Finding &finding : check(parse(testdata::job(name + QStringLiteral(".JBI")))))
        QFAIL(qPrintable(explain(finding, latin1)));
}

void TestCheck::findsOneFault_data()
{
    QTest::addColumn<int>("fault");
    QTest::addColumn<int>("fileLine");
    QTest::addColumn<int>("jobLine");
    QTest::addColumn<bool>("isError");
    const auto row = [](const char *name, Fault fault, int fileLine, int jobLine, bool isError = true) {
        QTest::newRow(name) << int(fault) << fileLine << jobLine << isError;
    };
    using enum Fault;
    row("broken/LF-ENDINGS", LineFeeds, 1, -1);
    row("broken/NO-NOP", NoNop, 14, 0);
    row("broken/NO-END", NoEnd, 16, 2);
    row("broken/COUNT-HIGH", WrongPointCount, 4, -1);
    row("broken/COUNT-KIND", WrongPointCount, 4, -1);
    row("broken/C-UNDEFINED", PointUndefined, 17, 3);
    row("broken/C-UNUSED", PointUnused, 9, -1);
    row("broken/C-TWICE", PointTwice, 9, -1);
    row("broken/NO-LABEL", NoLabel, 17, 3);
    row("broken/LABEL-TWICE", LabelTwice, 18, 4);
    row("broken/NO-ENDIF", NotClosed, 17, 3);
    row("broken/FIVE-AXES", WrongAxisCount, 9, -1);
    row("broken/NAME-OF-THIRTY-THREE-CHARACTERS-X", BadName, 2, -1);
    row("broken/UNKNOWN-WORD", UnknownWord, 17, 3, false); // it may belong to an option
    row("broken/NO-STATION", GroupLacksAxes, 10, 1);
    row("cases/BROKEN", NoInstruction, 11, 2);
    row("cases/DUPC", PointTwice, 9, -1);
    row("cases/JUNK", NoPosition, 9, -1);
    row("cases/MIDEND", EndInside, 10, 1);
    row("cases/NOLABEL", NoLabel, 10, 1);
    row("cases/NONPOS", NoPointCount, 0, -1);
    row("cases/NPOSCLS", WrongPointCount, 4, -1);
    row("cases/BOM", ByteOrderMark, 1, -1);
    row("cases/CTRLZ", ControlZ, 12, -1);
    row("cases/UTF16", Utf16, 0, -1);
    row("cases/CRONLY", CarriageReturns, 1, -1);
}

void TestCheck::findsOneFault()
{
    QFETCH(int, fault);
    QFETCH(bool, isError);
    const auto findings =
        check(parse(testdata::job(QString::fromLatin1(QTest::currentDataTag()) + QStringLiteral(".JBI"))));
    QStringList texts;
    for (const Finding &finding : findings)
        texts << explain(finding, latin1);
    QVERIFY2(findings.size() == 1, qPrintable(texts.join(u'\n')));
    const Finding &finding = findings.first();
    QCOMPARE(int(finding.fault), fault);
    QTEST(finding.fileLine, "fileLine");
    QTEST(finding.jobLine, "jobLine");
    QCOMPARE(finding.isError(), isError);
    QVERIFY(!reason(finding).isEmpty());
}

void TestCheck::checksLines_data()
{
    QTest::addColumn<QByteArray>("job");
    QTest::addColumn<QString>("texts");
    QTest::addColumn<bool>("isError");
    const auto row = [](const char *title, const QByteArray &job, const char *texts, bool isError = true) {
        QTest::newRow(title) << job << QString::fromUtf8(texts) << isError;
    };
    const QByteArray good = jobOf({});
    const auto with = [&good](
                          const char *before, const char *after) { return QByteArray(good).replace(before, after); };
    row("good", good, "", false);
    row("a jump out of a structure", jobOf("IFTHENEXP B000=1\r\n\t JUMP *OUT\r\nENDIF\r\n*OUT\r\n"), "", false);
    row("a label with a blank", jobOf("JUMP *A B IF IN#(1)=ON\r\n*A B\r\n"), "", false);
    row("a label that a variable says", jobOf("JUMP LABEL: B001\r\n"), "", false);
    row("a label that a number says", jobOf("JUMP LABEL: 7\r\n"), "Line 3 (18 in the file): There is no label *7.");
    row("commented out", jobOf("COMM JUMP *GONE\r\nCOMM IFTHENEXP B000=1\r\n"), "", false);
    row("locked", jobOf("EDTLCK JUMP *GONE\r\n"), "Line 3 (18 in the file): There is no label *GONE.");
    row("ENDIF alone", jobOf("ENDIF\r\n"), "Line 3 (18 in the file): ENDIF stands outside of what it belongs to.");
    row("ELSE in WHILE", jobOf("WHILEEXP B000=1\r\nELSE\r\nENDWHILE\r\n"),
        "Line 4 (19 in the file): ELSE stands outside of what it belongs to.");
    row("crossed", jobOf("IFTHENEXP B000=1\r\nFOR LB000 START= 0 TO 3\r\nENDIF\r\nNEXT LB000\r\n"),
        "Line 5 (20 in the file): ENDIF stands outside of what it belongs to.");
    row("eleven deep", jobOf(QByteArray("IFTHENEXP B000=1\r\n").repeated(11) + QByteArray("ENDIF\r\n").repeated(11)),
        "Line 13 (28 in the file): Structures are nested more than 10 deep.", false);
    row("VJ out of range", jobOf("SPEED VJ=100.01\r\n"), "Line 3 (18 in the file): VJ=100.01 is out of range.", false);
    row("VJ at the end of its range", jobOf("SPEED VJ=100.00\r\n"), "", false);
    row("nine arguments", jobOf("CALL JOB:X" + QByteArray(" ARGF1").repeated(9) + "\r\n"),
        "Line 3 (18 in the file): There are more than 8 arguments.");
    row("local beyond", jobOf("SET LB000 1\r\nSET LB001 1\r\n"),
        "Line 4 (19 in the file): LB001 is beyond what ///LVARS provides.", false);
    row("long comment", jobOf("'" + QByteArray(33, 'A') + "\r\n"),
        "Line 3 (18 in the file): A comment or message is longer than 32 bytes.", false);
    row("long label", jobOf("*ABCDEFGHI\r\n"), "Line 3 (18 in the file): The label *ABCDEFGHI is longer than 8 bytes.",
        false);
    row("empty line", jobOf("\r\n"), "Line 18 of the file: There is an empty line among the instructions.", false);
    row("control character", jobOf("'\x07\r\n"), "Line 18 of the file: There is a control character.");
    row("Shift-JIS", jobOf("'\x94\x9C\r\nMSG \"\x83[\"\r\nCALL JOB:\x83\x8F\x81[\x83N\r\n"), "", false);
    row("Shift-JIS elsewhere", jobOf("TIMER \x94\x9C\r\n"),
        "Line 3 (18 in the file): There are characters beyond ASCII outside of comments and texts.", false);
    row("point in two places", jobOf("MOVL C00000 V=5.0\r\n"),
        "Line 1 (16 in the file): C00000 is named in two places.", false);
    row("no group", with("///GROUP1 RB1\r\n", ""),
        "Line 8 of the file, named by line 1: There are taught points (C), and the job has no control group.");
    row("value that is none", with("C00001=0,0,0,0,0,0", "C00001=0,0,0,0,0,X"),
        "Line 9 of the file: C00001 has a value that is no number.");
    row("layout", with("///PULSE", "///RECTAN"),
        "Line 8 of the file: The line ///PULSE, ///RECTAN or ///ANGLE before C00000 does not fit its ///POSTYPE.\n"
        "Line 9 of the file: The line ///PULSE, ///RECTAN or ///ANGLE before C00001 does not fit its ///POSTYPE.",
        false);
    row("relative without a frame", with("SC,RW", "SC,RW,RJ"),
        "The job is relative, and no frame is given.\nLine 8 of the file: C00000 is in pulses, and the job is "
        "relative.\n"
        "Line 9 of the file: C00001 is in pulses, and the job is relative.",
        false);
    row("frame without relative", with("///GROUP1", "////FRAME USER 1\r\n///GROUP1"),
        "A frame is given, and the attribute RJ is missing.", false);
    row("unknown pseudo instruction", with("///ATTR", "///NEW 1\r\n///ATTR"),
        "Line 12 of the file: ///NEW is no known pseudo instruction.", false);
    row("text in front", "HELLO\r\n" + good, "Line 1 of the file: There is text that belongs to no section.");
    row("several jobs", good + good, "The file holds more than one job.", false);
    row("no last line end", good.chopped(2), "Line 18 of the file: The last line does not end.", false);
    row("LF in one line", with("NOP\r\n", "NOP\n"), "Line 15 of the file: Lines end in LF alone.");
    row("no job", "HELLO\r\n", "This is no job: it does not have the line /JOB.");
}

void TestCheck::checksLines()
{
    QFETCH(QByteArray, job);
    QStringList texts;
    bool isError = false;
    for (const Finding &finding : check(parse(job))) {
        texts << explain(finding, latin1);
        isError = isError || finding.isError();
    }
    QTEST(texts.join(u'\n'), "texts");
    QTEST(isError, "isError");
}

void TestCheck::bearsSize_data()
{
    QTest::addColumn<QByteArray>("lines");
    QTest::newRow("20,000 lines") << QByteArray("SET B001 1\r\n").repeated(20000);
    QTest::newRow("one long line") << "MOVJX " + QByteArray("P001 ").repeated(100000) + "\r\n";
    QTest::newRow("brackets in brackets") << "SETX " + QByteArray("B[").repeated(1000000) + "\r\n";
    QTest::newRow("10,000 labels") << QByteArray("*ABCDEFG\r\nJUMP *NO\r\n").repeated(10000);
    QTest::newRow("10,000 structures") << QByteArray("WHILEEXP B000=1\r\n").repeated(10000);
}

void TestCheck::bearsSize()
{
    QFETCH(QByteArray, lines);
    QVERIFY(!check(parse(jobOf(lines))).isEmpty());
}

QTEST_GUILESS_MAIN(TestCheck)

#include "tst_check.moc"
