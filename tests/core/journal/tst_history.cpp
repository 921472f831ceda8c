// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "journal/history.h"
#include "values/utc.h"
#include <QRandomGenerator>
#include <QTest>

using namespace journal;
using values::AlarmWithTexts;
using List = QList<AlarmWithTexts>;

namespace {

AlarmWithTexts entry(quint32 code, const QByteArray &time, const char *name = "")
{
    AlarmWithTexts one;
    one.alarm.code = code;
    one.alarm.time = values::FixedText<16> {time};
    one.alarm.name = values::FixedText<32> {QByteArrayView {name}};
    return one;
}

/// "1a 1a 2b": codes 1, 1, 2 at the minutes a, a, b.
List listOf(const char *text)
{
    List list;
    for (const QByteArray &word : QByteArray(text).simplified().split(' ')) {
        if (!word.isEmpty())
            list += entry(word.chopped(1).toUInt(), QByteArray("2026/01/01 08:0") + word.back());
    }
    return list;
}

/// What a controller with this list answers, entry by entry, until the rule says that it is enough.
List readUntilEnough(const List &atController, const List &known)
{
    List read;
    for (const AlarmWithTexts &one : atController.first(std::min<qsizetype>(atController.size(), 100))) {
        read += one;
        if (isEnough(read, known))
            break;
    }
    return read;
}

List newest(const List &list) { return list.first(std::min<qsizetype>(list.size(), 100)); }

qsizetype inNewestMinute(const List &list)
{
    return std::ranges::count_if(
        list, [&](const AlarmWithTexts &one) { return one.alarm.time == list.first().alarm.time; });
}

} // namespace

class TestHistory : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void readingStopsWhereNothingIsInDoubt_data()
    {
        QTest::addColumn<QByteArray>("atController"); // the newest first; a letter is a minute, z the newest
        QTest::addColumn<QByteArray>("known");
        QTest::addColumn<int>("readCount");
        QTest::addColumn<int>("newEntries");

        const auto row = [](const char *name, const char *atController, const char *known, int read, int isNew) {
            QTest::newRow(name) << QByteArray(atController) << QByteArray(known) << read << isNew;
        };
        row("nothing known, nothing there", "", "", 0, 0);
        row("nothing known", "3z 2y 1x", "", 3, 3);
        row("nothing new", "3z 2y 1x", "3z 2y 1x", 2, 0);
        row("one new", "4z 3y 2x 1w", "3y 2x 1w", 3, 1);
        row("an equal one in the same minute", "3y 3y 2x 1w", "3y 2x 1w", 3, 1);
        row("two more equal ones", "3y 3y 3y 3y 2x", "3y 3y 2x", 5, 2);
        row("equal and nothing new", "3y 3y 2x", "3y 3y 2x", 3, 0);
        row("all in one minute: to the end", "1z 1z 1z", "1z 1z", 3, 1);
        row("a new one within the minute of a pair", "5z 1z 2z 1y", "1z 2z 1y", 4, 1);
        row("the pair again", "1z 2z 1z 2z 9a", "1z 2z 9a", 5, 2);
        row("the clock went back", "7a 3z 2y", "3z 2y", 3, 1);
        row("the clock went back before", "7a 3z 2y", "7a 3z 2y", 2, 0);
        row("cleared at the controller", "", "3z 2y", 0, 0);
        row("cleared, then a new one", "4z", "3y 2x", 1, 1);
    }

    void readingStopsWhereNothingIsInDoubt()
    {
        QFETCH(const QByteArray, atController);
        QFETCH(const QByteArray, known);
        QFETCH(const int, readCount);
        QFETCH(const int, newEntries);

        const List read = readUntilEnough(listOf(atController.data()), listOf(known.data()));
        QCOMPARE(read.size(), readCount);
        QCOMPARE(newCount(read, listOf(known.data())), newEntries);
    }

    void aNameInAnotherLanguageIsTheSameEntry()
    {
        QVERIFY(isSameEntry(entry(1325, "2026/01/09 14:22", "ENCODER"), entry(1325, "2026/01/09 14:22", "GEBER")));
        QVERIFY(!isSameEntry(entry(1325, "2026/01/09 14:22"), entry(1325, "2026/01/09 14:23")));
        auto other = entry(1325, "2026/01/09 14:22");
        other.alarm.data.value = 2;
        QVERIFY(!isSameEntry(entry(1325, "2026/01/09 14:22"), other));
    }

    void theTopIsReadAgainToSeeThatNothingMoved_data()
    {
        QTest::addColumn<QByteArray>("read");
        QTest::addColumn<int>("expected");
        QTest::newRow("empty") << QByteArray("") << 0;
        QTest::newRow("one") << QByteArray("1z") << 1;
        QTest::newRow("different") << QByteArray("2z 1z") << 2;
        QTest::newRow("a run and one more") << QByteArray("1z 1z 1z 2y 1x") << 4;
        QTest::newRow("all equal") << QByteArray("1z 1z") << 2;
    }

    void theTopIsReadAgainToSeeThatNothingMoved()
    {
        QFETCH(const QByteArray, read);
        QFETCH(const int, expected);
        QCOMPARE(checkCount(listOf(read.data())), expected);
    }

    /// Whatever happens at a controller whose clock runs, the kept history is what happened, each entry once.
    void theKeptHistoryIsWhatHappened_data()
    {
        QTest::addColumn<quint32>("seed");
        for (quint32 seed = 1; seed <= 300; ++seed)
            QTest::addRow("%u", seed) << seed;
    }

    void theKeptHistoryIsWhatHappened()
    {
        QFETCH(const quint32, seed);
        QRandomGenerator random {seed};
        List happened; // the newest first, for ever
        List kept;
        int minute = 0;
        const int codes = 1 + random.bounded(3); // few codes: many equal entries
        for (int reading = 0; reading < 40; ++reading) {
            // As long as the list reaches down to another minute than the newest kept, nothing is in doubt.
            const int room = 100 - int(inNewestMinute(kept));
            const int burst = std::min(random.bounded(8) == 0 ? random.bounded(100) : random.bounded(6), room - 1);
            for (int i = 0; i < burst; ++i) {
                minute += random.bounded(4) == 0 ? 1 : 0;
                const auto clock = values::utc({2026, 1, 1}, {8, 0}).addSecs(60 * minute);
                const auto time = clock.toString(QStringLiteral("yyyy/MM/dd HH:mm")).toLatin1();
                happened.prepend(entry(1 + random.bounded(codes), time));
            }
            minute += random.bounded(2); // a minute may go on after a reading
            const List read = readUntilEnough(newest(happened), newest(kept));
            kept = read.first(newCount(read, newest(kept))) + kept;
            QVERIFY2(kept == happened, qPrintable(QStringLiteral("reading %1").arg(reading)));
        }
    }
};

QTEST_APPLESS_MAIN(TestHistory)
#include "tst_history.moc"
