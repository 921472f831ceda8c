// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "values/clock.h"
#include <QTest>

using namespace std::chrono_literals;
using values::Clocks;

class TestClock : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void neverRunsBackwards()
    {
        auto last = values::now();
        for (int i = 0; i < 1000; ++i) {
            const auto now = values::now();
            QVERIFY(now >= last);
            last = now;
        }
    }

    void gaps_data()
    {
        using ms = std::chrono::milliseconds;
        QTest::addColumn<ms>("passed");
        QTest::addColumn<ms>("awake");
        QTest::addColumn<ms>("wall");
        QTest::addColumn<bool>("isGap");
        QTest::newRow("in time") << ms {100} << ms {100} << ms {100} << false;
        QTest::newRow("just in time") << ms {350} << ms {350} << ms {350} << false;
        QTest::newRow("stopped") << ms {351} << ms {351} << ms {351} << true;
        QTest::newRow("stopped for 30 s") << ms {30'000} << ms {30'000} << ms {30'000} << true;
        QTest::newRow("slept for 8 h") << ms {28'800'000} << ms {100} << ms {28'800'000} << true;
        QTest::newRow("slept a little") << ms {340} << ms {80} << ms {340} << true;
        QTest::newRow("set forward") << ms {100} << ms {100} << ms {3'600'000} << true;
        QTest::newRow("set back") << ms {100} << ms {100} << ms {-3'600'000} << true;
        QTest::newRow("slewed") << ms {100} << ms {100} << ms {101} << false;
    }
    void gaps()
    {
        QFETCH(std::chrono::milliseconds, passed);
        QFETCH(std::chrono::milliseconds, awake);
        QFETCH(std::chrono::milliseconds, wall);
        QFETCH(bool, isGap);
        const Clocks before = Clocks::read();
        const Clocks after {before.passed + passed, before.awake + awake, before.wall + wall};
        QCOMPARE(values::hasGap(before, after, 350ms, 250ms), isGap);
    }
};

QTEST_APPLESS_MAIN(TestClock)
#include "tst_clock.moc"
