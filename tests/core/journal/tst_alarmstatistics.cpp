// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "journal/alarmstatistics.h"
#include <QTest>
#include <ctime>

using namespace journal;
using namespace std::chrono_literals;

namespace {

values::AlarmWithTexts entry(quint32 code, const QByteArray &time)
{
    values::AlarmWithTexts one;
    one.alarm.code = code;
    one.alarm.time = values::FixedText<16> {time};
    return one;
}

} // namespace

class TestAlarmStatistics : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase()
    {
        qputenv("TZ", "CET-1CEST,M3.5.0,M10.5.0/3"); // the zone of this computer, where 2026/03/29 has no 02:30
        tzset();
    }

    void meanTimeBetween_data()
    {
        QTest::addColumn<QByteArrayList>("times"); // the oldest first
        QTest::addColumn<int>("minutes"); // -1: cannot be told
        QTest::newRow("one") << QByteArrayList {"2026/01/01 08:00"} << -1;
        QTest::newRow("an hour apart") << QByteArrayList {"2026/01/01 08:00", "2026/01/01 09:00"} << 60;
        QTest::newRow("one hour, two hours")
            << QByteArrayList {"2026/01/01 08:00", "2026/01/01 09:00", "2026/01/01 11:00"} << 90;
        QTest::newRow("in one minute") << QByteArrayList {"2026/01/01 08:00", "2026/01/01 08:00"} << 0;
        QTest::newRow("clock never set") << QByteArrayList {"1970/01/01 00:05", "1970/01/01 00:25"} << 20;
        QTest::newRow("clock set between")
            << QByteArrayList {"1970/01/01 00:05", "2026/01/01 08:00", "2026/01/01 08:10"} << 10;
        QTest::newRow("clock set back between")
            << QByteArrayList {"2026/01/01 08:00", "2025/12/31 08:00", "2025/12/31 08:30"} << 30;
        QTest::newRow("no date") << QByteArrayList {"2026/01/01 08:00", "????", "2026/01/01 09:00"} << -1;
        QTest::newRow("over the hour that a summer time skips")
            << QByteArrayList {"2026/03/29 01:30", "2026/03/29 03:30"} << 120;
        QTest::newRow("in the hour that a summer time skips")
            << QByteArrayList {"2026/03/29 01:30", "2026/03/29 02:30"} << 60;
    }

    void meanTimeBetween()
    {
        QFETCH(const QByteArrayList, times);
        QFETCH(const int, minutes);
        AlarmTally tally;
        for (const QByteArray &time : times)
            tally.add(entry(4416, time));
        const auto found = topCodes({tally}, 10);
        QCOMPARE(found.size(), 1);
        QCOMPARE(found.first().count, int(times.size()));
        QCOMPARE(found.first().meanBetween.has_value(), minutes >= 0);
        QCOMPARE(found.first().meanBetween.value_or(-1min).count(), minutes);
    }

    void theMostFrequentComesFirst()
    {
        QList<AlarmTally> tallies;
        for (const auto &[code, count] : {std::pair {7U, 1}, {5U, 2}, {9U, 2}, {1U, 1}}) {
            tallies += AlarmTally {};
            for (int i = 0; i < count; ++i)
                tallies.last().add(entry(code, "2026/01/01 08:00"));
        }
        QList<quint32> codes;
        for (const auto &one : topCodes(tallies, 3))
            codes += one.code;
        QCOMPARE(codes, (QList<quint32> {5, 9, 1}));
        QCOMPARE(topCodes({}, 10).size(), 0);
    }

    /// One code in two lists: the counts and the times between add up, and the newest entry says name and time. From
    /// one list to the other no time passes.
    void listsAreAddedUp()
    {
        AlarmTally major;
        major.add(entry(4416, "2026/01/01 08:00"));
        major.add(entry(4416, "2026/01/01 09:00"));
        major.newest = 7;
        AlarmTally minor;
        minor.add(entry(4416, "2026/01/01 10:00"));
        minor.add(entry(4416, "2026/01/01 10:30"));
        minor.newest = 3;
        const auto found = topCodes({major, minor}, 10);
        QCOMPARE(found.size(), 1);
        QCOMPARE(found[0].count, 4);
        QVERIFY(found[0].meanBetween == 45min);
        QCOMPARE(found[0].last.time(), QTime(9, 0));
    }
};

QTEST_APPLESS_MAIN(TestAlarmStatistics)
#include "tst_alarmstatistics.moc"
