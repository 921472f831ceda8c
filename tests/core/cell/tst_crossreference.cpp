// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "cell/calltree.h"
#include "cell/hints.h"

#include <QDir>
#include <QFile>
#include <QTest>

using namespace cell;

namespace {

QByteArray contentOf(const QString &path)
{
    QFile file {path};
    if (!file.open(QIODevice::ReadOnly))
        qFatal("%s cannot be read", qPrintable(path));
    return file.readAll();
}

QList<File> filesIn(const QString &folder)
{
    QList<File> files;
    const QDir dir {QStringLiteral(PENDESK_TEST_DATA "/") + folder};
    for (const QString &name : dir.entryList(QDir::Files, QDir::Name))
        files << File {name.toLatin1(), contentOf(dir.filePath(name))};
    return files;
}

/// The valid jobs, with the macro table that they lack: macro 2 is MACRO-GRIP's own.
const Cell &sampleJobs()
{
    static const Cell cell = cellOf(filesIn(QStringLiteral("jobs")), protocol::TextCodec {});
    return cell;
}

const Cell &sampleCell()
{
    static const Cell cell = cellOf(filesIn(QStringLiteral("cell/yrc1000")), protocol::TextCodec {});
    return cell;
}

QByteArray job(const QByteArray &lines, const QByteArray &positions = {})
{
    return "/JOB\r\n//NAME T\r\n//POS\r\n///NPOS 0,0,0,0,0,0\r\n" + positions
        + "//INST\r\n///DATE 2026/01/01 08:00\r\n///ATTR SC,RW\r\n///GROUP1 RB1\r\nNOP\r\n" + lines + "END\r\n";
}

QByteArray named(QByteArray text, const QByteArray &name) { return text.replace("//NAME T", "//NAME " + name); }

QString wordOf(How how)
{
    static const QStringList words {QStringLiteral("W"), QStringLiteral("R"), QStringLiteral("WAIT"),
        QStringLiteral("CALL"), QStringLiteral("JUMP"), QStringLiteral("START"), QStringLiteral("NAME")};
    return words[int(how)];
}

/// "W MAIN-FLOW 2 as OG#(3)"
QString textOf(const Use &use)
{
    QString text =
        QStringLiteral("%1 %2 %3").arg(wordOf(use.how), QString::fromLatin1(use.place.name)).arg(use.place.line);
    if (!use.through.isEmpty())
        text += QStringLiteral(" as ") + QString::fromLatin1(use.through);
    return use.isMaybe ? QStringLiteral("may ") + text : text;
}

QStringList textsOf(const QList<Use> &uses)
{
    QStringList texts;
    for (const Use &use : uses)
        texts << textOf(use);
    return texts;
}

} // namespace

class TestCrossReference : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void subjectsAreReadAndWritten_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("shown");
        const auto row = [](const char *text, const char *shown) {
            QTest::addRow("%s", text) << QString::fromLatin1(text) << QString::fromLatin1(shown);
        };
        row("b12", "B012");
        row("B012", "B012");
        row("EX 5", "EX005");
        row("M5", "M005");
        row("MREG#(5)", "M005");
        row("IN#(5)", "IN#(5)");
        row("in 5", "IN#(5)");
        row("#00014", "IN#(5)");
        row("OUT#(17)", "OT#(17)");
        row("OT#(17)", "OT#(17)");
        row("#10030", "OT#(17)"); // INFORM reference §5.2
        row("#20010", "#20010");
        row("SOUT#(1)", "#50010");
        row("TOOL 3", "TOOL 3");
        row("TL#(3)", "TOOL 3");
        row("UF#(2)", "UF#(2)");
        row("MJ#(2)", "MJ#(2)");
        row("ASF#(12)", "ASF#(12)");
        row("8021", "8021");
        row("$RV", "$RV");
        row("CLAMP", "CLAMP");
        row("R1B1", "R1B1"); // a job, not R001
    }
    void subjectsAreReadAndWritten()
    {
        QFETCH(QString, text);
        const auto subject = subjectFromText(text);
        QVERIFY(subject);
        QTEST(toString(*subject), "shown");
    }

    void nothingIsNoSubject() { QVERIFY(!subjectFromText(u"  ")); }

    void signalsHaveLogicalNumbers_data()
    {
        QTest::addColumn<QByteArray>("reference");
        QTest::addColumn<QList<int>>("numbers"); // INFORM reference §5.2
        QTest::addRow("IN#(9)") << QByteArray("IN#(9)") << QList<int> {20};
        QTest::addRow("OT#(17)") << QByteArray("OT#(17)") << QList<int> {10030};
        QTest::addRow("SOUT#(1)") << QByteArray("SOUT#(1)") << QList<int> {50010};
        QTest::addRow("IG#(2)") << QByteArray("IG#(2)") << QList<int> {20, 21, 22, 23, 24, 25, 26, 27};
        QTest::addRow("OG#(3)") << QByteArray("OG#(3)")
                                << QList<int> {10030, 10031, 10032, 10033, 10034, 10035, 10036, 10037};
        QTest::addRow("IGH#(5)") << QByteArray("IGH#(5)") << QList<int> {30, 31, 32, 33};
        QTest::addRow("IGH#(6)") << QByteArray("IGH#(6)") << QList<int> {34, 35, 36, 37};
        QTest::addRow("IN#(0)") << QByteArray("IN#(0)") << QList<int> {};
    }
    void signalsHaveLogicalNumbers()
    {
        QFETCH(QByteArray, reference);
        QList<int> numbers;
        for (const Subject &subject : subjectsOf(reference))
            numbers << subject.number;
        QTEST(numbers, "numbers");
    }

    /// Uses in the sample jobs, by the list that came with them.
    void usesInSamples_data()
    {
        QTest::addColumn<QString>("subject");
        QTest::addColumn<QString>("use"); // one of them
        const auto row = [](const char *subject, const char *use) {
            QTest::addRow("%s: %s", subject, use) << QString::fromLatin1(subject) << QString::fromLatin1(use);
        };
        row("OT#(3)", "W OLDNX 3");
        row("IN#(9)", "R OLDNX 7");
        row("IN#(12)", "R PULSE6 15");
        row("TOOL 2", "R OLDNX 5 as C00002");
        row("UF#(1)", "R OLDNX 5 as C00002");
        row("TOOL 3", "R PULSE6 8 as C00005");
        row("TOOL 0", "R PULSE6 15 as C00009");
        row("I007", "R POSTYPES 8");
        row("P003", "may R POSTYPES 8");
        row("P006", "W POSTYPES 7");
        row("P021", "W RELUSER 4");
        row("UF#(3)", "R RELUSER 5");
        row("UF#(3)", "R RELUSER 0 as FRAME");
        row("UF#(4)", "R RELUSER 8");
        row("B003", "R RELUSER 8");
        row("RELUSER2", "CALL RELUSER 8");
        row("P010", "W R1B1 4");
        row("BP010", "W R1B1 4");
        row("EX002", "W COORD-S1 7");
        row("IN#(33)", "WAIT TWO-ROBOTS 3");
        row("8021", "W TWO-ROBOTS 8");
        row("TOOL 6", "R R1B1S1 2 as P060");
        row("UF#(10)", "R R1B1S1 2 as P060");
        row("ARGS-SUB", "CALL ALIASES 8");
        row("$RV", "W ARGS-SUB 10");
        row("OT#(17)", "W MAIN-FLOW 2 as OG#(3)");
        row("OT#(24)", "W MAIN-FLOW 2 as OG#(3)");
        row("COORD-S1", "START MAIN-FLOW 5");
        row("B011", "R MAIN-FLOW 10");
        row("MINIMAL", "JUMP MAIN-FLOW 24");
        row("D007", "may R STRUCT 6");
        row("B023", "W STRUCT 23");
        row("D091", "R STRUCT 29");
        row("OT#(4)", "may W IO-ALL 2");
        row("IN#(18)", "R IO-ALL 5 as IGH#(5)");
        row("IN#(100)", "may WAIT IO-ALL 18");
        row("UF#(9)", "W MATH-POS 14");
        row("TOOL 5", "W MATH-POS 16");
        row("TOOL 1", "R MATH-POS 2");
        row("OT#(200)", "may W MACRO-GRIP 3");
        row("MJ#(2)", "CALL MACRO-GRIP 9");
        row("CV#(1)", "R CONVEYOR 2");
        row("ASF#(12)", "R ARC-WELD 4");
        row("$B002", "R ARC-WELD 10");
        row("GUN#(1)", "R SPOT-GUN 6");
    }
    void usesInSamples()
    {
        QFETCH(QString, subject);
        QFETCH(QString, use);
        static const CrossReference uses {sampleJobs()};
        const QStringList found = textsOf(uses.uses(*subjectFromText(subject)));
        QVERIFY2(found.contains(use), qPrintable(found.join(QStringLiteral("; "))));
    }

    void commentedLinesAreNoUses()
    {
        const CrossReference uses {sampleJobs()};
        for (const Subject &subject : uses.subjects()) {
            for (const Use &use : uses.uses(subject))
                QVERIFY(use.place.name != "PULSE6" || use.place.line != 11);
        }
    }

    /// #00010 is written by the ladder (file line given in the samples' list), named, and nothing else.
    void theLadderIsRead()
    {
        const CrossReference uses {sampleCell()};
        const auto found = textsOf(uses.uses({Subject::Kind::Signal, 10}));
        QVERIFY2(std::ranges::any_of(found, [](const QString &text) { return text.startsWith(u"W CIOPRG.LST"); }),
            qPrintable(found.join(QStringLiteral("; "))));
        QVERIFY(found.contains(QStringLiteral("NAME IONAME.DAT 3")));
        const auto twenty = textsOf(uses.uses({Subject::Kind::Signal, 20017}));
        QVERIFY2(twenty.contains(QStringLiteral("R CIOPRG.LST 30")), qPrintable(twenty.join(QStringLiteral("; "))));
        for (int bit = 0; bit < 8; ++bit) {
            const auto group = uses.uses({Subject::Kind::Signal, 40 + bit});
            QVERIFY(std::ranges::any_of(group, [](const Use &use) { return use.how == How::Writes; }));
        }
        QVERIFY(std::ranges::any_of(
            uses.uses({Subject::Kind::Register, 150}), [](const Use &use) { return use.how == How::Writes; }));
    }

    void namesOfThings_data()
    {
        QTest::addColumn<QString>("subject");
        QTest::addColumn<QString>("name");
        const auto row = [](const char *subject, const char *name) {
            QTest::addRow("%s", subject) << QString::fromLatin1(subject) << QString::fromLatin1(name);
        };
        row("IN#(1)", "CYCLE START");
        row("OT#(4)", "LAMP GREEN");
        row("#20010", "PLC HEARTBEAT");
        row("M559", "TEMP 1");
        row("B007", "MODE");
        row("P029", "PLACE / PLACE HOVER");
        row("TOOL 1", "GRIPPER A");
        row("UF#(1)", "TABLE");
        row("9000", "AIR PRESSURE LOW");
        row("9127", "GRIPPER NOT REFERENCED");
        row("B099", "");
    }
    void namesOfThings()
    {
        QFETCH(QString, subject);
        QTEST(sampleCell().nameOf(*subjectFromText(subject)), "name");
    }

    void theCallTreeOfTheSamples()
    {
        const CallTree tree {sampleJobs()};
        QStringList calls;
        for (const Call &call : tree.callsOf("MAIN-FLOW"))
            calls << QStringLiteral("%1 %2 %3").arg(wordOf(call.how), QString::fromLatin1(call.callee)).arg(call.line);
        const QStringList expected {QStringLiteral("START R1B1 4"), QStringLiteral("START COORD-S1 5"),
            QStringLiteral("CALL PULSE6 15"), QStringLiteral("CALL RELUSER 16"), QStringLiteral("CALL IO-ALL 19"),
            QStringLiteral("JUMP MINIMAL 24")};
        QCOMPARE(calls, expected);
        QCOMPARE(tree.callsOf("RELUSER").size(), qsizetype {1});
        QVERIFY(tree.callsOf("RELUSER").first().isMissing);
        QVERIFY(tree.callsOf("RELUSER").first().isConditional);
        QCOMPARE(tree.callersOf("ARGS-SUB").size(), qsizetype {1});
        QCOMPARE(tree.callsOf("MACRO-GRIP").first().through, QByteArray {"MJ#(2)"});
        const QByteArrayList heads {"ALIASES", "ARC-WELD", "CONVEYOR", "MACRO-GRIP", "MAIN-FLOW", "MATH-POS", "OLDNX",
            "POSTYPES", "R1B1S1", "SJIS-COMM", "SPOT-GUN", "STRUCT", "TWO-ROBOTS"};
        QCOMPARE(tree.heads(), heads);
        QByteArrayList unused = heads;
        unused.removeAll("MACRO-GRIP");
        QCOMPARE(tree.unused(), unused);
    }

    void hints_data()
    {
        QTest::addColumn<QList<QByteArray>>("jobs"); // A, B, ...
        QTest::addColumn<QByteArray>("other"); // MACRO.DAT
        QTest::addColumn<QStringList>("expected"); // kind and subject
        const auto row = [](const char *title, const QList<QByteArray> &jobs, const QStringList &expected,
                             const QByteArray &macros = {}) {
            QTest::addRow("%s", title) << jobs << macros << expected;
        };
        row("missing", {"CALL JOB:B\r\n"}, {QStringLiteral("0 B"), QStringLiteral("5 A")});
        row("two jobs write an output", {"CALL JOB:B\r\nDOUT OT#(1) ON\r\n", "CALL JOB:A\r\nDOUT OT#(1) OFF\r\n"},
            {QStringLiteral("1 OT#(1)")});
        row("one job writes twice", {"CALL JOB:A\r\nDOUT OT#(1) ON\r\nDOUT OT#(1) OFF\r\n"}, {QStringLiteral("5 A")});
        row("never written", {"SET B001 B002\r\nWAIT I003=1\r\nCALL JOB:B\r\n", "CALL JOB:A\r\n"},
            {QStringLiteral("2 B002"), QStringLiteral("2 I003")});
        row("written through an index",
            {"SET B001 B002\r\nSET B[I001] 1\r\nSET I001 0\r\nCALL JOB:B\r\n", "CALL JOB:A\r\n"}, {});
        row("a job that a number names", {"CALL I001\r\nSET I001 1\r\n"}, {});
        row("run by a macro", {"NOP\r\n"}, {}, "//MACRO1 1\r\n///ATTR 0\r\n///JOB1 A\r\n///JOB2\r\n");
    }
    void hints()
    {
        QFETCH(QList<QByteArray>, jobs);
        QFETCH(QByteArray, other);
        QFETCH(QStringList, expected);
        QList<File> files;
        for (qsizetype i = 0; i < jobs.size(); ++i) {
            const QByteArray name(1, char('A' + i));
            files << File {name + ".JBI", named(job(jobs[i]), name)};
        }
        if (!other.isEmpty())
            files << File {"MACRO.DAT", other};
        const Cell cell = cellOf(files, protocol::TextCodec {});
        QStringList found;
        for (const Hint &hint : hintsOf(cell, CrossReference {cell}, CallTree {cell}))
            found << QStringLiteral("%1 %2").arg(int(hint.kind)).arg(toString(hint.subject));
        QCOMPARE(found, expected);
    }

    void twoVersionsOfAJobAreSaid()
    {
        const Cell cell = cellOf({{"A.JBI", job("")}, {"B.JBI", job("")}}, protocol::TextCodec {});
        QCOMPARE(cell.jobs.size(), std::size_t {1});
        QCOMPARE(cell.doubles, QList<QByteArray> {"B.JBI"});
    }

    void anyBytesWillDo()
    {
        const Cell cell = cellOf({{"A.JBI", QByteArray(300, '\xff')}, {"CIOPRG.LST", "//KEY\n\0\0"}, {"IONAME.DAT", {}},
                                     {"MACRO.DAT", "//MACRO1 x\r\n"}},
            protocol::TextCodec {});
        QVERIFY(!CrossReference {cell}.subjects().contains(Subject {}));
        QVERIFY(!cell.troubles.isEmpty());
    }
};

QTEST_GUILESS_MAIN(TestCrossReference)
#include "tst_crossreference.moc"
