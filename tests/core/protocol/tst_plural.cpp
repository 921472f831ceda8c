// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "protocol/plural.h"
#include <QTest>

using namespace protocol;
using Chunks = QList<Chunk>;

/// A range becomes the fewest packets (reference §4.5).
class PluralTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void splits_data();
    void splits();
    void coversEveryRange();
};

void PluralTest::splits_data()
{
    QTest::addColumn<int>("itemSize");
    QTest::addColumn<int>("first");
    QTest::addColumn<int>("last");
    QTest::addColumn<int>("lastOfArea");
    QTest::addColumn<Chunks>("toRead");
    QTest::addColumn<Chunks>("toWrite");
    const auto row = [](const char *name, int size, int first, int last, int end, const Chunks &read,
                         const Chunks &write) { QTest::newRow(name) << size << first << last << end << read << write; };
    row("one register", 2, 5, 5, 999, {{5, 1, 1}}, {{5, 1, 1}});
    row("all registers", 2, 0, 999, 999,
        {{0, 237, 237}, {237, 237, 237}, {474, 237, 237}, {711, 237, 237}, {948, 52, 52}},
        {{0, 237, 237}, {237, 237, 237}, {474, 237, 237}, {711, 237, 237}, {948, 52, 52}});
    row("even bytes", 1, 0, 9, 99, {{0, 10, 10}}, {{0, 10, 10}});
    row("odd bytes", 1, 0, 2, 99, {{0, 4, 3}}, {{0, 2, 2}, {2, 1, 1}});
    row("odd bytes at the end of the area", 1, 97, 99, 99, {{97, 2, 2}, {99, 1, 1}}, {{97, 2, 2}, {99, 1, 1}});
    row("one byte", 1, 7, 7, 99, {{7, 1, 1}}, {{7, 1, 1}});
    row("one byte more than fit", 1, 0, 474, 999, {{0, 474, 474}, {474, 1, 1}}, {{0, 474, 474}, {474, 1, 1}});
    row("475 less one", 1, 0, 472, 999, {{0, 474, 473}}, {{0, 472, 472}, {472, 1, 1}});
    row("odd rest", 1, 0, 476, 999, {{0, 474, 474}, {474, 4, 3}}, {{0, 474, 474}, {474, 2, 2}, {476, 1, 1}});
    row("positions", 52, 0, 9, 127, {{0, 9, 9}, {9, 1, 1}}, {{0, 9, 9}, {9, 1, 1}});
    row("highest instance", 2, 65534, 65535, 65535, {{65534, 2, 2}}, {{65534, 2, 2}});
}

void PluralTest::splits()
{
    QFETCH(int, itemSize);
    QFETCH(int, first);
    QFETCH(int, last);
    QFETCH(int, lastOfArea);
    const PluralRule rule {itemSize};
    const InstanceRange range {quint16(first), quint16(last)};
    QTEST(chunksToRead(rule, range, quint16(lastOfArea)), "toRead");
    QTEST(chunksToWrite(rule, range), "toWrite");
}

/// Nothing is missing, nothing twice, nothing beyond the area, and every count is allowed.
void PluralTest::coversEveryRange()
{
    constexpr quint16 lastOfArea = 1100;
    for (const int itemSize : {1, 2, 4, 52}) {
        const PluralRule rule {itemSize};
        for (int last = 0; last <= lastOfArea; ++last) {
            int next = 0;
            for (const Chunk &chunk : chunksToRead(rule, {0, quint16(last)}, lastOfArea)) {
                QCOMPARE(int(chunk.first), next);
                QVERIFY(chunk.isSingle() || rule.allows(chunk.count));
                QVERIFY(chunk.first + chunk.count - 1 <= lastOfArea);
                next += chunk.wanted;
            }
            QCOMPARE(next, last + 1);
        }
    }
}

QTEST_APPLESS_MAIN(PluralTest)
#include "tst_plural.moc"
