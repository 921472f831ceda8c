// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "inform/job.h"
#include "support/jobs.h"

#include <QDir>
#include <QTest>
#include <random>

using namespace inform;

/// Jobs are read, and every byte of any file is kept.
class TestJob : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void readsSamples_data();
    void readsSamples();
    void readsHeaders();
    void readsPoints_data();
    void readsPoints();
    void readsAliases();
    void readsArguments();
    void keepsEveryByte_data();
    void keepsEveryByte();
    void keepsRandomBytes();
    void knowsLineKinds_data();
    void knowsLineKinds();
    void readsCounts_data();
    void readsCounts();
    void judgesNames_data();
    void judgesNames();
    void callsOtherJobs_data();
    void callsOtherJobs();
    void takesOneJobOfSeveral();
    void bearsSize_data();
    void bearsSize();
};

void TestJob::readsSamples_data()
{
    QTest::addColumn<int>("last"); // line number of END
    QTest::addColumn<int>("steps");
    QTest::addColumn<QList<int>>("counts");
    const auto row = [](const char *name, int last, int steps, const QList<int> &counts) {
        QTest::newRow(name) << last << steps << counts;
    };
    row("MINIMAL", 1, 0, {0, 0, 0, 0, 0, 0});
    row("OLDNX", 8, 3, {3, 0, 0, 0, 0, 0});
    row("PULSE6", 16, 10, {10, 0, 0, 0, 0, 0});
    row("POSTYPES", 9, 7, {2, 0, 0, 5, 0, 0});
    row("RELUSER", 10, 5, {3, 0, 0, 1, 0, 0});
    row("R1B1", 7, 2, {3, 3, 0, 0, 0, 0});
    row("COORD-S1", 8, 5, {6, 0, 6, 0, 0, 1});
    row("TWO-ROBOTS", 10, 2, {4, 0, 2, 0, 0, 0});
    row("R1B1S1", 8, 3, {1, 1, 1, 2, 1, 1});
    row("SJIS-COMM", 7, 1, {1, 0, 0, 0, 0, 0});
    row("ALIASES", 14, 1, {0, 0, 0, 1, 0, 0});
    row("ARGS-SUB", 15, 0, {0, 0, 0, 0, 0, 0});
    row("MAIN-FLOW", 29, 0, {0, 0, 0, 0, 0, 0});
    row("STRUCT", 31, 0, {0, 0, 0, 0, 0, 0});
    row("IO-ALL", 26, 0, {0, 0, 0, 0, 0, 0});
    row("MATH-POS", 27, 0, {0, 0, 0, 0, 0, 0});
    row("MACRO-GRIP", 10, 0, {0, 0, 0, 0, 0, 0});
    row("CONVEYOR", 10, 5, {5, 0, 0, 0, 0, 0});
    row("ARC-WELD", 19, 6, {7, 0, 0, 0, 0, 0});
    row("SPOT-GUN", 15, 4, {4, 0, 0, 0, 0, 0});
}

void TestJob::readsSamples()
{
    QFETCH(int, last);
    QFETCH(int, steps);
    QFETCH(QList<int>, counts);
    const QString name = QString::fromLatin1(QTest::currentDataTag());
    const Job job = parse(testdata::job(name + QStringLiteral(".JBI")));
    QVERIFY(job.isJob);
    QCOMPARE(QString::fromLatin1(job.name), name);
    QCOMPARE(job.lineCount() - 1, last);
    QCOMPARE(job.word(0), "NOP");
    QCOMPARE(job.word(last), "END");
    QCOMPARE(job.steps(), steps);
    QVERIFY(job.announced.has_value());
    QCOMPARE(QList<int>(job.announced->begin(), job.announced->end()), counts);
    QVERIFY(job.counted() == *job.announced);
    for (const Line &line : job.lines)
        QVERIFY(line.kind != LineKind::Foreign);
    for (const Token &token : job.tokens)
        QVERIFY(token.kind != TokenKind::Unknown);
}

void TestJob::readsHeaders()
{
    const Job relative = parse(testdata::job(QStringLiteral("RELUSER.JBI")));
    QCOMPARE(relative.comment, "RELATIVE TO FIXTURE 3");
    QCOMPARE(relative.date, "2026/03/02 10:15");
    QCOMPARE(relative.attributes, (QByteArrayList {"SC", "RW", "RJ"}));
    QCOMPARE(relative.frame, "USER 3");
    QCOMPARE(relative.groups, QList<QByteArrayList> {{"RB1"}});
    QCOMPARE(parse(testdata::job(QStringLiteral("OLDNX.JBI"))).frame, "USER 1"); // three slashes
    QCOMPARE(parse(testdata::job(QStringLiteral("POSTYPES.JBI"))).folder, "DEMO");
    const Job two = parse(testdata::job(QStringLiteral("TWO-ROBOTS.JBI")));
    QVERIFY((two.groups == QList<QByteArrayList> {{"RB1", "ST1"}, {"RB2"}}));
    QVERIFY(parse(testdata::job(QStringLiteral("STRUCT.JBI"))).groups.isEmpty());
    QVERIFY((parse(testdata::job(QStringLiteral("ALIASES.JBI"))).locals == LocalCounts {1, 2, 2, 0, 0, 1, 0, 0}));
    QCOMPARE(parse(testdata::job(QStringLiteral("SJIS-COMM.JBI"))).comment,
        "\x8C\xB4\x93_\x95\x9C\x8B\x41\x83v\x83\x8D\x83O\x83\x89\x83\x80");
}

void TestJob::readsPoints_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<QByteArray>("point");
    QTest::addColumn<QByteArray>("frame"); // type, tool, user frame
    QTest::addColumn<QByteArray>("form"); // the first five fields
    QTest::addColumn<QList<double>>("values");
    const auto row = [](const char *name, const char *point, const char *frame, const char *form,
                         const QList<double> &values) {
        QTest::addRow("%s %s", name, point)
            << QString::fromLatin1(name) << QByteArray(point) << QByteArray(frame) << QByteArray(form) << values;
    };
    row("OLDNX", "C00002", "USER 2 1", "1,0,0,0,1", {240.5, -35.25, 80, 180, 0, -170});
    row("PULSE6", "C00005", "PULSE 3 ", "", {20990, 6040, -41200, 171, -23010, -30});
    row("PULSE6", "C00009", "PULSE 0 ", "", {0, 0, 0, 0, 0, 0});
    row("POSTYPES", "C00001", "BASE 1 ", "1,0,0,0,0", {810, 120.5, 640.25, 180, -5.5, 0});
    row("POSTYPES", "P003", "PULSE 1 ", "", {0, -30000, -30000, 0, -45000, 0});
    row("POSTYPES", "P004", "ROBOT 1 ", "0,0,0,0,0", {700, 0, 500, 180, 0, 0});
    row("POSTYPES", "P00006", "USER 7 6", "1,0,0,0,1", {0, 0, 50, 180, 0, 170});
    row("POSTYPES", "P00010", "TOOL 1 ", "1,0,0,0,1", {0, 0, -100, 0, 0, 0});
    row("COORD-S1", "EC00001", "ANGLE 0 ", "", {15});
    row("COORD-S1", "EX002", "ANGLE 0 ", "", {90});
    row("TWO-ROBOTS", "C00003", "PULSE 1 ", "", {6500, -43000, -33000, 0, -23000, 0});
    row("TWO-ROBOTS", "EC00001", "PULSE 0 ", "", {10000, -20000});
    row("R1B1S1", "BP060", "BASE 6 ", "", {1250});
    row("R1B1S1", "EX060", "ANGLE 6 ", "", {12.5});
    row("R1B1S1", "P060", "USER 6 10", "1,0,0,0,0", {10, 0, 2.5, 180, 0, 0});
}

void TestJob::readsPoints()
{
    QFETCH(QString, name);
    QFETCH(QByteArray, point);
    QFETCH(QByteArray, frame);
    QFETCH(QByteArray, form);
    QFETCH(QList<double>, values);
    const Job job = parse(testdata::job(name + QStringLiteral(".JBI")));
    const Point *found = job.point(point);
    QVERIFY(found);
    QCOMPARE(
        QByteArrayList({found->type.toByteArray(), found->tool.toByteArray(), found->user.toByteArray()}).join(' '),
        frame);
    QCOMPARE(found->form.first(std::min<qsizetype>(found->form.size(), 9)).toByteArray(), form);
    QCOMPARE(found->numbers(), values);
    QCOMPARE(found->isBeyondLimit, false);
    const Job limited = parse(testdata::job(QStringLiteral("RELUSER.JBI")));
    QVERIFY(limited.point("C00002")->isBeyondLimit);
    QVERIFY(!limited.point("P00020")->isBeyondLimit);
}

void TestJob::readsAliases()
{
    const Job job = parse(testdata::job(QStringLiteral("ALIASES.JBI")));
    const QList<Alias> expected {{"D012", "TOTAL"}, {"LI000", "Mode"}, {"LI001", "Speed_1"}, {"LD000", "Width"},
        {"LD001", "Offset_X"}, {"LP000", "Pnt_A"}};
    QVERIFY(job.aliasList == expected);
}

void TestJob::readsArguments()
{
    const Job job = parse(testdata::job(QStringLiteral("ARGS-SUB.JBI")));
    QCOMPARE(job.arguments.size(), 8);
    QVERIFY((job.arguments.first(4) == QList<Argument> {{"D", "DISTANCE"}, {"B", "COUNT"}, {"S", "UNIT"}, {"", ""}}));
    const Job odd =
        parse("/JOB\r\n//ARGINFO\r\n///ARGTYPE I,,,,,,,\r\n///COMMENT\r\nC00000=1\r\n\r\n\r\n\r\n\r\n\r\n\r\n"
              "\r\n//INST\r\nNOP\r\nEND\r\n");
    QCOMPARE(odd.arguments[0].comment, "C00000=1"); // text, no position
    QVERIFY(odd.points.empty());
    QCOMPARE(odd.lineCount(), 2);
}

void TestJob::keepsEveryByte_data()
{
    QTest::addColumn<QByteArray>("content");
    const QByteArray sample = testdata::job(QStringLiteral("POSTYPES.JBI"));
    QTest::addRow("LF") << QByteArray(sample).replace("\r\n", "\n");
    QTest::addRow("no final newline") << sample.chopped(2);
    QTest::addRow("half a final newline") << sample.chopped(1);
    QTest::addRow("CR alone") << QByteArray(sample).replace("\r\n", "\r");
    QTest::addRow("mixed") << QByteArray("NOP\n\r\n\r\r\n\n\n\rEND");
    QTest::addRow("undecodable") << QByteArray("/JOB\r\n//NAME \xFF\xFE\x80\x00\r\n\x8A\r\n", 22);
    QTest::addRow("empty") << QByteArray();
    QTest::addRow("one newline") << QByteArray("\n");
    for (const QString &folder : {QStringLiteral(":/demo"), QStringLiteral(PENDESK_TEST_DATA "/jobs"),
             QStringLiteral(PENDESK_TEST_DATA "/jobs/broken"), QStringLiteral(PENDESK_TEST_DATA "/jobs/cases")}) {
        for (const QString &name : QDir {folder}.entryList(QDir::Files)) {
            QFile file {folder + u'/' + name};
            QVERIFY(file.open(QIODevice::ReadOnly));
            QTest::addRow("%s", qPrintable(file.fileName())) << file.readAll();
        }
    }
}

void TestJob::keepsEveryByte()
{
    QFETCH(QByteArray, content);
    QCOMPARE(print(parse(content)), content);
}

void TestJob::keepsRandomBytes()
{
    std::mt19937 random {9};
    const QByteArray alphabet {"\r\n\n /*'=,:CPNOJB\xFF\x8A\0", 21};
    for (int run = 0; run < 2000; ++run) {
        QByteArray content;
        while (random() % 60 != 0)
            content += alphabet[qsizetype(random() % 21)];
        for (const char *start : {"", "/JOB\n//POS\n", "//INST\n", "//ALIAS\n", "//ARGINFO\n///COMMENT\n"})
            QCOMPARE(print(parse(start + content)), start + content);
    }
}

void TestJob::knowsLineKinds_data()
{
    QTest::addColumn<int>("index");
    QTest::addColumn<int>("kind");
    QTest::addRow("text before the sections") << 0 << int(LineKind::Foreign);
    QTest::addRow("header") << 1 << int(LineKind::Header);
    QTest::addRow("position") << 2 << int(LineKind::Entry);
    QTest::addRow("no position") << 3 << int(LineKind::Foreign);
    QTest::addRow("label") << 5 << int(LineKind::Label);
    QTest::addRow("comment") << 6 << int(LineKind::Comment);
    QTest::addRow("blank") << 7 << int(LineKind::Blank);
    QTest::addRow("instruction") << 8 << int(LineKind::Instruction);
    QTest::addRow("comment, commented out") << 9 << int(LineKind::Comment);
    QTest::addRow("jump to a label") << 10 << int(LineKind::Instruction);
    QTest::addRow("end of a text file") << 11 << int(LineKind::Foreign);
}

void TestJob::knowsLineKinds()
{
    QFETCH(int, index);
    QFETCH(int, kind);
    const Job job = parse("HELLO\n//POS\nC00000=1\n=1\n//INST\n*L\n'C\n \nNOP\nCOMM 'TEXT\nJUMP *L\n\x1a");
    QCOMPARE(int(job.lines[std::size_t(index)].kind), kind);
    QVERIFY(!job.isJob);
    QCOMPARE(job.lineCount(), 5);
    QVERIFY((job.labels() == QList<Mark> {{"L", 0}}));
}

void TestJob::readsCounts_data()
{
    QTest::addColumn<QByteArray>("line");
    QTest::addColumn<QList<int>>("counts"); // empty: unknown
    QTest::addRow("six") << QByteArray("///NPOS 1,2,3,4,5,6") << QList<int> {1, 2, 3, 4, 5, 6};
    QTest::addRow("blanks") << QByteArray("///NPOS 1, 2") << QList<int> {1, 2, 0, 0, 0, 0};
    QTest::addRow("four, of old") << QByteArray("///NPOS 7,0,0,1") << QList<int> {7, 0, 0, 1, 0, 0};
    QTest::addRow("seven") << QByteArray("///NPOS 1,2,3,4,5,6,7") << QList<int> {};
    QTest::addRow("no number") << QByteArray("///NPOS 1,x") << QList<int> {};
    QTest::addRow("negative") << QByteArray("///NPOS -1") << QList<int> {};
    QTest::addRow("nothing") << QByteArray("///NPOS") << QList<int> {};
    QTest::addRow("missing") << QByteArray("///TOOL 0") << QList<int> {};
}

void TestJob::readsCounts()
{
    QFETCH(QByteArray, line);
    QFETCH(QList<int>, counts);
    const auto announced = parse("/JOB\r\n//POS\r\n" + line + "\r\n").announced;
    QCOMPARE(announced ? QList<int>(announced->begin(), announced->end()) : QList<int> {}, counts);
}

void TestJob::judgesNames_data()
{
    QTest::addColumn<QByteArray>("name");
    QTest::addColumn<bool>("isGood");
    QTest::addRow("letters") << QByteArray("WELD_A-12") << true;
    QTest::addRow("digit in front") << QByteArray("1A") << true;
    QTest::addRow("! and &") << QByteArray("A!&") << true;
    QTest::addRow("32 bytes") << QByteArray(32, 'A') << true;
    QTest::addRow("33 bytes") << QByteArray(33, 'A') << false;
    QTest::addRow("nothing") << QByteArray() << false;
    QTest::addRow("blank") << QByteArray("A B") << false;
    QTest::addRow("colon") << QByteArray("A:B") << false;
    QTest::addRow("bracket") << QByteArray("A[B") << false;
    QTest::addRow("bracket as second byte") << QByteArray("\x83\x8F\x81[\x83N") << true; // Shift-JIS, three characters
    QTest::addRow("half-width kana") << QByteArray("\xB6\xB0") << true;
    QTest::addRow("control") << QByteArray("A\x07") << false;
}

void TestJob::judgesNames()
{
    QFETCH(QByteArray, name);
    QTEST(isJobName(name), "isGood");
}

void TestJob::callsOtherJobs_data()
{
    QTest::addColumn<QString>("calls"); // line and job
    QTest::addRow("MAIN-FLOW") << QStringLiteral("4 R1B1, 5 COORD-S1, 15 PULSE6, 16 RELUSER, 19 IO-ALL, 24 MINIMAL");
    QTest::addRow("RELUSER") << QStringLiteral("8 RELUSER2");
    QTest::addRow("ALIASES") << QStringLiteral("8 ARGS-SUB");
    for (const char *none : {"MINIMAL", "OLDNX", "PULSE6", "POSTYPES", "R1B1", "COORD-S1", "TWO-ROBOTS", "R1B1S1",
             "SJIS-COMM", "ARGS-SUB", "STRUCT", "IO-ALL", "MATH-POS", "MACRO-GRIP", "CONVEYOR", "ARC-WELD", "SPOT-GUN"})
        QTest::addRow("%s", none) << QString();
}

void TestJob::callsOtherJobs()
{
    QStringList found;
    for (const Mark &mark :
        parse(testdata::job(QString::fromLatin1(QTest::currentDataTag()) + QStringLiteral(".JBI"))).calls())
        found << QStringLiteral("%1 %2").arg(mark.line).arg(QString::fromLatin1(mark.name));
    QTEST(found.join(QStringLiteral(", ")), "calls");
}

void TestJob::takesOneJobOfSeveral()
{
    const QByteArray one = testdata::job(QStringLiteral("MINIMAL.JBI"));
    const Job job = parse(one + testdata::job(QStringLiteral("PULSE6.JBI")));
    QCOMPARE(job.jobs, 2);
    QCOMPARE(job.name, "MINIMAL");
    QCOMPARE(job.lineCount(), 2);
    QVERIFY(job.points.empty());
}

void TestJob::bearsSize_data()
{
    QTest::addColumn<QByteArray>("content");
    QTest::addColumn<int>("lines");
    QTest::addRow("a million lines") << "//INST\n" + QByteArray("NOP\n").repeated(1000000) << 1000000;
    QTest::addRow("10 MB in one line") << "//INST\nMOVJ " + QByteArray("C00000 ").repeated(1500000) << 1;
    QTest::addRow("10 MB of quotes") << "//INST\nMSG " + QByteArray(10000000, '"') << 1;
    QTest::addRow("10 MB of brackets") << "//INST\nSET B[" + QByteArray(10000000, '[') << 1;
    QTest::addRow("10,000 labels") << "//INST\n" + QByteArray("*ABCDEFG\n").repeated(10000) << 10000;
}

void TestJob::bearsSize()
{
    QFETCH(QByteArray, content);
    QFETCH(int, lines);
    const Job job = parse(content);
    QCOMPARE(job.lineCount(), lines);
    QVERIFY(print(job) == content);
}

QTEST_GUILESS_MAIN(TestJob)

#include "tst_job.moc"
