// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "files/compare.h"
#include "files/jobdiff.h"
#include "inform/linediff.h"

#include <QTest>
#include <random>

using namespace files;
using inform::diffLines;
using inform::Hunk;
using values::FileName;

namespace {

FileName fileName(const QByteArray &bytes) { return *FileName::create(bytes); }

QByteArrayList letters(const QByteArray &text)
{
    QByteArrayList result;
    for (const char letter : text)
        result << QByteArray(1, letter);
    return result;
}

QByteArrayList applied(const QByteArrayList &older, const QByteArrayList &newer, const QList<Hunk> &blocks)
{
    QByteArrayList result;
    int at = 0;
    for (const Hunk &block : blocks) {
        result += older.sliced(at, block.oldFrom - at) + newer.sliced(block.newFrom, block.newCount);
        at = block.oldFrom + block.oldCount;
    }
    return result + older.sliced(at);
}

/// Length of the longest common subsequence, the slow and sure way.
int commonLength(const QByteArrayList &a, const QByteArrayList &b)
{
    QList<QList<int>> table(a.size() + 1, QList<int>(b.size() + 1, 0));
    for (int i = 1; i <= a.size(); ++i)
        for (int j = 1; j <= b.size(); ++j)
            table[i][j] = a[i - 1] == b[j - 1] ? table[i - 1][j - 1] + 1 : std::max(table[i - 1][j], table[i][j - 1]);
    return table[a.size()][b.size()];
}

const QByteArray job =
    "/JOB\r\n//NAME A\r\n//POS\r\n///NPOS 2,0,0,2,0,0\r\n///TOOL 0\r\n///POSTYPE PULSE\r\n///PULSE\r\n"
    "C00000=0,100,-200,0,0,0\r\nC00001=1,2,3,4,5,6\r\n///POSTYPE BASE\r\n///RECTAN\r\n"
    "P00012=1000.000,50.000,620.000,180.0000,0.0000,0.0000\r\n"
    "P00013=1.000,1.000,1.000,1.0000,1.0000,1.0000\r\n//INST\r\n///DATE 2026/01/12 08:30\r\n"
    "///COMM OLD\r\n///ATTR SC,RW\r\n///GROUP1 RB1\r\nNOP\r\n'START\r\nMOVJ C00000 VJ=25.00\r\n"
    "MOVL C00001 V=100.0\r\nDOUT OT#(1) ON\r\nTIMER T=0.30\r\nCALL JOB:SUB IF B000>=20\r\nEND\r\n";

} // namespace

/// What is said about two backups, two files, two jobs is all that differs and nothing else.
class TestCompare : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void diffsLines_data();
    void diffsLines();
    void diffsShortest();
    void givesUpOnTooMuch();
    void cleansNoise_data();
    void cleansNoise();
    void comparesSets();
    void findsExactlyTheChanges();
    void comparesText();
    void explainsJobs_data();
    void explainsJobs();
    void findsExactlyTheEdits();
};

void TestCompare::diffsLines_data()
{
    QTest::addColumn<QByteArray>("older");
    QTest::addColumn<QByteArray>("newer");
    QTest::addColumn<QList<int>>("blocks"); // four numbers each
    QTest::addRow("equal") << QByteArray("ABC") << QByteArray("ABC") << QList<int> {};
    QTest::addRow("both empty") << QByteArray() << QByteArray() << QList<int> {};
    QTest::addRow("from nothing") << QByteArray() << QByteArray("AB") << QList<int> {0, 0, 0, 2};
    QTest::addRow("to nothing") << QByteArray("AB") << QByteArray() << QList<int> {0, 2, 0, 0};
    QTest::addRow("added in front") << QByteArray("BC") << QByteArray("ABC") << QList<int> {0, 0, 0, 1};
    QTest::addRow("added at the end") << QByteArray("AB") << QByteArray("ABC") << QList<int> {2, 0, 2, 1};
    QTest::addRow("removed") << QByteArray("ABC") << QByteArray("AC") << QList<int> {1, 1, 1, 0};
    QTest::addRow("changed") << QByteArray("ABC") << QByteArray("AXC") << QList<int> {1, 1, 1, 1};
    QTest::addRow("two places") << QByteArray("ABCDE") << QByteArray("AXCE") << QList<int> {1, 1, 1, 1, 3, 1, 3, 0};
    QTest::addRow("all") << QByteArray("AB") << QByteArray("XYZ") << QList<int> {0, 2, 0, 3};
}

void TestCompare::diffsLines()
{
    QFETCH(QByteArray, older);
    QFETCH(QByteArray, newer);
    QFETCH(QList<int>, blocks);
    QList<int> found;
    for (const Hunk &block : diffLines(letters(older), letters(newer)))
        found << block.oldFrom << block.oldCount << block.newFrom << block.newCount;
    QCOMPARE(found, blocks);
}

void TestCompare::diffsShortest()
{
    std::mt19937 random {7};
    for (int run = 0; run < 3000; ++run) {
        QByteArrayList texts[2];
        for (QByteArrayList &text : texts)
            for (auto left = random() % 14; left > 0; --left)
                text << QByteArray(1, "ABCD"[random() % 4]);
        const auto blocks = diffLines(texts[0], texts[1]);
        QCOMPARE(applied(texts[0], texts[1], blocks), texts[1]);
        qsizetype edits = 0;
        for (const Hunk &block : blocks)
            edits += block.oldCount + block.newCount;
        QCOMPARE(edits, texts[0].size() + texts[1].size() - 2 * commonLength(texts[0], texts[1]));
    }
}

void TestCompare::givesUpOnTooMuch()
{
    QByteArrayList older;
    QByteArrayList newer;
    for (int line = 0; line < 60000; ++line) {
        older << "old " + QByteArray::number(line);
        newer << "new " + QByteArray::number(line);
    }
    older.first() = newer.first() = "same";
    const auto blocks = diffLines(older, newer);
    QVERIFY((blocks == QList<Hunk> {{1, 59999, 1, 59999}}));
}

void TestCompare::cleansNoise_data()
{
    QTest::addColumn<QString>("rule");
    QTest::addColumn<QByteArray>("older");
    QTest::addColumn<QByteArray>("newer");
    QTest::addColumn<bool>("isNoise");
    const auto row = [](const char *title, const char *rule, const char *older, const char *newer, bool isNoise) {
        QTest::newRow(title) << QString::fromLatin1(rule) << QByteArray(older) << QByteArray(newer) << isNoise;
    };
    row("job date", "job-dates", "///DATE 2026/01/01 00:00\r\n", "///DATE 2025/12/31 23:59\r\n", true);
    row("no job date", "job-dates", "///COMM 2026/01/01\r\n", "///COMM 2025/12/31\r\n", false);
    row("job date and line end", "job-dates", "///DATE 1\r\n", "///DATE 2\n", false);
    row("time", "times", "SAVED 2026/01/01 00:00:01,5\n", "SAVED 2025/12/31 23:59:59,5\n", true);
    row("time and more", "times", "SAVED 2026/01/01 00:00,5\n", "SAVED 2025/12/31 23:59,6\n", false);
    row("counter", "counters", "POWER 18:19'02\n", "POWER 1234:56'07\n", true);
    row("no counter", "counters", "POWER 18\n", "POWER 19\n", false);
    row("blank at the end", "blanks", "NOP \t\r\n", "NOP\r\n", true);
    row("blank in front", "blanks", " NOP\r\n", "NOP\r\n", false);
    row("line end", "line-ends", "NOP\r\nEND\r\n", "NOP\nEND", true);
    row("one more line", "line-ends", "NOP\nEND\n", "NOP\nEND\n\n", false);
    row("wrong rule", "blanks", "NOP\r\n", "NOP\n", false);
    row("no rule", "", "NOP \r\n", "NOP\r\n", false);
}

void TestCompare::cleansNoise()
{
    QFETCH(QString, rule);
    QFETCH(QByteArray, older);
    QFETCH(QByteArray, newer);
    QFETCH(bool, isNoise);
    const NoiseFilter filter {QSet<QString> {rule}};
    QCOMPARE(filter.cleanLines(older) == filter.cleanLines(newer), isNoise);
    QCOMPARE(compareText(older, newer, filter).size()
                - std::ranges::count_if(compareText(older, newer, filter), &ComparedLine::isSame)
            == 0,
        isNoise);
}

void TestCompare::comparesSets()
{
    const QByteArray dated = "///DATE 2026/01/01 00:00\r\n";
    FileSet older = fileSetOf({{fileName("SAME.JBI"), "a"}, {fileName("DATED.JBI"), dated}, {fileName("GONE.JBI"), "b"},
        {fileName("CHANGED.JBI"), "c"}, {fileName("UNREAD.JBI"), "d"}, {fileName("A.PRM"), "p"}});
    FileSet newer = fileSetOf({{fileName("SAME.JBI"), "a"}, {fileName("DATED.JBI"), "///DATE 2026/02/01 00:00\r\n"},
        {fileName("NEW.JBI"), "e"}, {fileName("CHANGED.JBI"), "C"}});
    newer.unread.insert(fileName("UNREAD.JBI"));
    newer.unlisted.insert("PRM");
    const QList<FileChange> expected {{fileName("A.PRM"), Change::Unread}, {fileName("CHANGED.JBI"), Change::Changed},
        {fileName("DATED.JBI"), Change::OnlyNoise}, {fileName("GONE.JBI"), Change::Gone},
        {fileName("NEW.JBI"), Change::New}, {fileName("SAME.JBI"), Change::Same},
        {fileName("UNREAD.JBI"), Change::Unread}};
    QVERIFY(compare(older, newer, {}) == expected);
    QCOMPARE(differences(expected), 5);
    QVERIFY(compare(older, newer, NoiseFilter::none())[2].change == Change::Changed);
}

/// Two generated sets of files, changed at random in ways that are known beforehand.
void TestCompare::findsExactlyTheChanges()
{
    std::mt19937 random {9};
    for (int run = 0; run < 50; ++run) {
        std::map<FileName, QByteArray> older;
        std::map<FileName, QByteArray> newer;
        QList<FileChange> expected;
        for (int number = 0; number < 200; ++number) {
            const FileName name = fileName("F" + QByteArray::number(1000 + number) + ".JBI");
            const QByteArray content = "///DATE 1\r\nSET B000 " + QByteArray::number(int(random() % 100)) + "\r\n";
            using enum Change;
            const Change change = std::array {Same, Same, Same, New, Gone, Changed, OnlyNoise}[random() % 7];
            if (change != New)
                older[name] = content;
            if (change == Changed)
                newer[name] = content + "END\r\n";
            else if (change != Gone)
                newer[name] = change == OnlyNoise ? QByteArray(content).replace("DATE 1", "DATE 2") : content;
            expected << FileChange {name, change};
        }
        QVERIFY(compare(fileSetOf(older), fileSetOf(newer), {}) == expected);
    }
}

void TestCompare::comparesText()
{
    const auto lines = compareText("A\r\nB\r\nC\r\nD\r\n", "A\nX\nY\nC\n", {});
    const QList<ComparedLine> expected {{0, 0, "A", "A", true}, {1, 1, "B", "X", false}, {-1, 2, "", "Y", false},
        {2, 3, "C", "C", true}, {3, -1, "D", "", false}};
    QVERIFY(lines == expected);
}

void TestCompare::explainsJobs_data()
{
    QTest::addColumn<QByteArray>("before");
    QTest::addColumn<QByteArray>("after");
    QTest::addColumn<QStringList>("texts");
    const auto row = [](const char *before, const char *after, const QStringList &texts) {
        QTest::newRow(after[0] ? QByteArray(after).simplified().constData() : "removed")
            << QByteArray(before) << QByteArray(after) << texts;
    };
    row("620.000", "623.200", {QStringLiteral("P00012 moved 3.2 mm in Z")});
    row("180.0000,0.0000,0.0000", "180.0000,0.0000,-1.5000", {QStringLiteral("P00012 moved -1.5° in Rz")});
    row("0,100,-200", "0,150,-260", {QStringLiteral("C00000 moved 50 pulses in L, -60 pulses in U")});
    row("1,2,3,4,5,6", "1,2,3,4,5", {QStringLiteral("C00001 changed: 1,2,3,4,5,6 → 1,2,3,4,5")});
    row("V=100.0", "V=150.0", {QStringLiteral("V 100.0 → 150.0 at line 3")});
    row("OT#(1) ON", "OT#(1) OFF", {QStringLiteral("ON → OFF at line 4")});
    row("TIMER T=0.30", "WAIT IN#(1)=ON", {QStringLiteral("Line 5: TIMER T=0.30 → WAIT IN#(1)=ON")});
    row("TIMER T=0.30\r\n", "", {QStringLiteral("Line 5 removed: TIMER T=0.30")});
    row("END", "DOUT OT#(1) OFF\r\nEND", {QStringLiteral("Line 7 added: DOUT OT#(1) OFF")});
    row("'START", "'BEGIN", {QStringLiteral("Line 1: 'START → 'BEGIN")});
    row("COMM OLD", "COMM N\x83", {QStringLiteral("Comment changed: “OLD” → “N⟨83⟩”")});
    row("SC,RW", "SC,RO", {QStringLiteral("Attributes changed: SC,RW → SC,RO")});
    row("C00001=1,2,3,4,5,6\r\n", "C00002=1,2,3,4,5,6\r\n",
        {QStringLiteral("C00001 removed: 1,2,3,4,5,6"), QStringLiteral("C00002 added: 1,2,3,4,5,6")});
    row("TOOL 0\r\n///POSTYPE PULSE", "TOOL 0\r\n///POSTYPE ROBOT",
        {QStringLiteral("C00000 is taught otherwise: PULSE TOOL 0 → ROBOT TOOL 0"),
            QStringLiteral("C00001 is taught otherwise: PULSE TOOL 0 → ROBOT TOOL 0")});
    row("2026/01/12", "2026/01/13", {});
    row("\r\n", "\n", {});
    row("1000.000", "1000.0", {});
}

void TestCompare::explainsJobs()
{
    QFETCH(QByteArray, before);
    QFETCH(QByteArray, after);
    QFETCH(QStringList, texts);
    QVERIFY(job.contains(before));
    QStringList found;
    const protocol::TextCodec codec {protocol::Encoding::Utf8};
    for (const JobEdit &edit : diffJobs(parseJob(job), parseJob(QByteArray(job).replace(before, after)), {}))
        found << explain(edit, codec);
    QCOMPARE(found, texts);
}

/// A generated job, edited at random in ways whose report is known beforehand.
void TestCompare::findsExactlyTheEdits()
{
    std::mt19937 random {12};
    for (int run = 0; run < 300; ++run) {
        QList<JobEdit> expected;
        QByteArray positions[2];
        for (int number = 0; number < 40; ++number) {
            const QByteArray name = "P" + QByteArray::number(number).rightJustified(5, '0');
            QByteArrayList values;
            for (int axis = 0; axis < 6; ++axis)
                values << QByteArray::number(int(random() % 2000)) + (axis < 3 ? ".000" : ".0000");
            positions[0] += name + '=' + values.join(',') + "\r\n";
            if (random() % 10 == 0) {
                const int axis = int(random() % 6);
                const QByteArray older = values.join(',');
                const double by = 0.5 + double(random() % 100);
                values[axis] = QByteArray::number(values[axis].toDouble() + by, 'f', axis < 3 ? 3 : 4);
                expected << JobEdit {EditKind::PositionMoved, name, -1, older, values.join(','), false, {{axis, by}}};
            }
            positions[1] += name + '=' + values.join(',') + "\r\n";
        }
        QByteArray lines[2] {"NOP\r\n", "NOP\r\n"};
        int newLine = 1;
        for (int number = 1; number < 60; ++number, ++newLine) {
            const QByteArray start = "MOVL P" + QByteArray::number(number) + " V=";
            const QByteArray older = start + QByteArray::number(number) + ".0";
            lines[0] += older + "\r\n";
            const auto dice = number % 3 ? 99 : random() % 8; // edits are never side by side
            if (dice == 0) {
                lines[1] += start + "999.0\r\n";
                expected << JobEdit {
                    EditKind::OperandChanged, "V", newLine, QByteArray::number(number) + ".0", "999.0"};
            } else if (dice == 1) {
                expected << JobEdit {EditKind::LineRemoved, {}, number, older, {}};
                --newLine;
            } else {
                lines[1] += older + "\r\n";
            }
            if (dice == 2) {
                lines[1] += "TIMER T=" + QByteArray::number(number) + "\r\n";
                expected << JobEdit {EditKind::LineAdded, {}, ++newLine, {}, "TIMER T=" + QByteArray::number(number)};
            }
        }
        const auto text = [&](int version) {
            return "/JOB\r\n//NAME A\r\n//POS\r\n///POSTYPE BASE\r\n///RECTAN\r\n" + positions[version]
                + "//INST\r\n///DATE " + QByteArray::number(version) + "\r\n" + lines[version] + "END\r\n";
        };
        const auto found = diffJobs(parseJob(text(0)), parseJob(text(1)), {});
        QVERIFY2(found == expected, qPrintable(QString::number(run)));
    }
}

QTEST_GUILESS_MAIN(TestCompare)

#include "tst_compare.moc"
