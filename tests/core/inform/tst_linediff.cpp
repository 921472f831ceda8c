// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "inform/linediff.h"

#include <QTest>
#include <random>

using namespace inform;

namespace {

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

} // namespace

/// The fewest lines make one text of another.
class TestLineDiff : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void diffsLines_data();
    void diffsLines();
    void diffsShortest();
    void givesUpOnTooMuch();
};

void TestLineDiff::diffsLines_data()
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

void TestLineDiff::diffsLines()
{
    QFETCH(QByteArray, older);
    QFETCH(QByteArray, newer);
    QFETCH(QList<int>, blocks);
    QList<int> found;
    for (const Hunk &block : diffLines(letters(older), letters(newer)))
        found << block.oldFrom << block.oldCount << block.newFrom << block.newCount;
    QCOMPARE(found, blocks);
}

void TestLineDiff::diffsShortest()
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

void TestLineDiff::givesUpOnTooMuch()
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

QTEST_GUILESS_MAIN(TestLineDiff)

#include "tst_linediff.moc"
