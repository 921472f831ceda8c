// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "files/compare.h"

#include <QTest>
#include <random>

using namespace files;
using values::FileName;

namespace {

FileName fileName(const QByteArray &bytes) { return *FileName::create(bytes); }

} // namespace

/// What is said about two backups, two files, two jobs is all that differs and nothing else.
class TestCompare : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void cleansNoise_data();
    void cleansNoise();
    void comparesSets();
    void findsExactlyTheChanges();
    void comparesText();
};

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

QTEST_GUILESS_MAIN(TestCompare)

#include "tst_compare.moc"
