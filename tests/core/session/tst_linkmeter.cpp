// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "session/linkmeter.h"
#include <QTest>

using namespace std::chrono_literals;
using session::LinkMeter;
using session::Time;

class TestLinkMeter : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void nothingIsNotZero()
    {
        const auto statistics = LinkMeter {}.statistics(Time {1h});
        QVERIFY(!statistics.p50 && !statistics.p95 && !statistics.lastAnswerAge);
        QVERIFY(statistics.seconds.empty() && statistics.commands.empty());
    }

    void percentiles()
    {
        LinkMeter meter;
        const Time begin {1h};
        for (int i = 1; i <= 100; ++i) {
            meter.sent(begin, 0x72);
            meter.roundTrip(begin, 0x72, std::chrono::microseconds {i});
        }
        const auto statistics = meter.statistics(begin + 1s);
        QCOMPARE(statistics.p50->count(), 50);
        QCOMPARE(statistics.p95->count(), 95);
        QCOMPARE(statistics.requestsPerSecond, 100);
        QCOMPARE(statistics.loss, 0.0);
    }

    void eachCommandByItself()
    {
        LinkMeter meter;
        const Time begin {1h};
        for (int i = 0; i < 4; ++i)
            meter.sent(begin, 0x72);
        meter.miss(begin, 0x72);
        meter.roundTrip(begin, 0x72, 300us);
        meter.sent(begin, 0x75);
        meter.roundTrip(begin + 2s, 0x75, 2ms);
        const auto commands = meter.statistics(begin + 3s).commands;
        QCOMPARE(commands.size(), 2U);
        QCOMPARE(commands[0].command, quint16(0x72));
        QCOMPARE(commands[0].loss, 0.25);
        QCOMPARE(commands[0].p50->count(), 300);
        QVERIFY(*commands[0].lastAnswerAge == 3s);
        QCOMPARE(commands[1].p95->count(), 2000);
        QVERIFY(*commands[1].lastAnswerAge == 1s);
    }

    void onlyTheNewestAnswersCount()
    {
        LinkMeter meter;
        const Time begin {1h};
        for (int i = 0; i < 1000; ++i)
            meter.roundTrip(begin, 0x72, i < 936 ? 1s : 5us); // the last 64
        QCOMPARE(meter.statistics(begin).commands[0].p95->count(), 5);
    }

    void aMinuteIsAMinute()
    {
        LinkMeter meter;
        const Time begin {1h};
        meter.sent(begin, 0x72);
        meter.miss(begin, 0x72);
        meter.sent(begin + 100s, 0x72);
        const auto statistics = meter.statistics(begin + 101s);
        QCOMPARE(statistics.loss, 0.0);
        QVERIFY(statistics.seconds.size() <= 60U);
        QCOMPARE(statistics.seconds.back().sent, 1);
    }

    void aSilentSecondIsAGap()
    {
        LinkMeter meter;
        const Time begin {1h};
        meter.roundTrip(begin, 0x72, 1ms);
        meter.roundTrip(begin + 2s, 0x72, 3ms);
        const auto seconds = meter.statistics(begin + 3s).seconds;
        QCOMPARE(seconds.size(), 3U);
        QVERIFY(seconds[0].roundTrip && !seconds[1].roundTrip && seconds[2].roundTrip);
    }
};

QTEST_GUILESS_MAIN(TestLinkMeter)
#include "tst_linkmeter.moc"
