// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "journal/activealarms.h"
#include "values/utc.h"
#include <QTest>

using namespace journal;
using values::AlarmWithTexts;

namespace {

AlarmWithTexts raised(quint32 code, const char *time = "2026/01/12 08:30")
{
    AlarmWithTexts one;
    one.alarm.code = code;
    one.alarm.time = values::FixedText<16> {QByteArrayView {time}};
    return one;
}

QList<AlarmWithTexts> inSlots(QList<AlarmWithTexts> alarms)
{
    alarms.resize(values::activeAlarmCount);
    return alarms;
}

QDateTime second(int number) { return values::utc({2026, 1, 12}, {9, 0}).addSecs(number); }

const QString cell = QStringLiteral("CELL 4");

} // namespace

/// A letter a state: U unacknowledged, A acknowledged, C cleared unacknowledged, - not listed.
class TestActiveAlarms : public QObject
{
    Q_OBJECT

private:
    static char stateOf(const ActiveAlarms &alarms, quint32 code)
    {
        for (const auto &entry : alarms.entries()) {
            if (entry.sighting.alarm.alarm.code == code)
                return "UAC?"[int(entry.sighting.state)];
        }
        return '-';
    }

private Q_SLOTS:
    /// A step is what the slots hold ('.' nothing, '1' alarm 1, '2' both with 2 the newer, '#' four others) or 'a' for
    /// a person who acknowledges alarm 1.
    void statesOfOneAlarm_data()
    {
        QTest::addColumn<QByteArray>("steps");
        QTest::addColumn<QByteArray>("states"); // of alarm 1, after each step
        QTest::newRow("comes and goes") << QByteArray("1.") << QByteArray("UC");
        QTest::newRow("acknowledged while active") << QByteArray("1a1.") << QByteArray("UAA-");
        QTest::newRow("acknowledged after it went") << QByteArray("1.a") << QByteArray("UC-");
        QTest::newRow("acknowledged twice") << QByteArray("1aa.") << QByteArray("UAA-");
        QTest::newRow("comes again unacknowledged") << QByteArray("1.1") << QByteArray("UCU");
        QTest::newRow("comes again after all was well") << QByteArray("1a.1") << QByteArray("UA-U");
        QTest::newRow("missed once while the list moves") << QByteArray("2o2") << QByteArray("UUU");
        QTest::newRow("missed twice") << QByteArray("2oo") << QByteArray("UUC");
        QTest::newRow("pushed out of four full slots") << QByteArray("1###") << QByteArray("UUUU");
        QTest::newRow("pushed out, then seen to be gone") << QByteArray("1##oo") << QByteArray("UUUUC");
    }

    void statesOfOneAlarm()
    {
        QFETCH(const QByteArray, steps);
        QFETCH(const QByteArray, states);
        ActiveAlarms alarms {cell};
        QByteArray seen;
        for (int i = 0; i < steps.size(); ++i) {
            switch (steps[i]) {
            case '.': alarms.take(inSlots({}), second(i)); break;
            case '1': alarms.take(inSlots({raised(1)}), second(i)); break;
            case '2': alarms.take(inSlots({raised(2), raised(1)}), second(i)); break;
            case 'o': alarms.take(inSlots({raised(2)}), second(i)); break;
            case '#': alarms.take(inSlots({raised(6), raised(5), raised(4), raised(3)}), second(i)); break;
            case 'a': alarms.acknowledge({raised(1)}); break;
            }
            seen += stateOf(alarms, 1);
        }
        QCOMPARE(seen, states);
    }

    void firstSeenAndCountGoOn()
    {
        ActiveAlarms alarms {cell};
        alarms.take(inSlots({raised(1)}), second(0));
        alarms.take(inSlots({raised(1)}), second(5));
        QCOMPARE(alarms.entries().first().sighting.count, 1u);
        QCOMPARE(alarms.entries().first().sighting.lastSeen, second(5));
        alarms.take(inSlots({}), second(6));
        const auto changes = alarms.take(inSlots({raised(1)}), second(7));
        QCOMPARE(changes.came.size(), 1);
        QCOMPARE(changes.came.first().count, 2u);
        QCOMPARE(changes.came.first().firstSeen, second(0));
        QCOMPARE(changes.came.first().controller, cell);
    }

    /// Between two readings it was reset and came again: the controller's time tells.
    void anotherTimeIsAnotherOccurrence()
    {
        ActiveAlarms alarms {cell};
        alarms.take(inSlots({raised(1)}), second(0));
        alarms.acknowledge({raised(1)});
        const auto changes = alarms.take(inSlots({raised(1, "2026/01/12 08:31")}), second(1));
        QCOMPARE(changes.came.size(), 1);
        QCOMPARE(stateOf(alarms, 1), 'U');
        QCOMPARE(alarms.entries().first().sighting.count, 2u);
    }

    void oneAlarmInTwoSlotsIsTheNewerOne()
    {
        ActiveAlarms alarms {cell};
        const auto both = inSlots({raised(1, "2026/01/12 08:31"), raised(1)});
        QCOMPARE(alarms.take(both, second(0)).came.size(), 1);
        QCOMPARE(alarms.take(both, second(1)).came.size(), 0);
        QCOMPARE(alarms.entries().size(), 1);
    }

    void theNewestIsFirst()
    {
        ActiveAlarms alarms {cell};
        alarms.take(inSlots({raised(2), raised(1)}), second(0));
        QCOMPARE(alarms.entries()[0].sighting.alarm.alarm.code, 2u);
        alarms.take(inSlots({raised(3), raised(2), raised(1)}), second(1));
        QCOMPARE(alarms.entries()[0].sighting.alarm.alarm.code, 3u);
        QCOMPARE(alarms.entries()[2].sighting.alarm.alarm.code, 1u);
    }

    void acknowledgementSurvivesARestart()
    {
        ActiveAlarms before {cell};
        const auto came = before.take(inSlots({raised(1), raised(2)}), second(0)).came;
        const auto kept = before.acknowledge({raised(1)}).toKeep;
        QList<Sighting> stored {kept.first(), came.first()};
        QCOMPARE(stored.last().alarm.alarm.code, 2u);

        ActiveAlarms restored {cell};
        restored.restore(stored);
        QCOMPARE(restored.take(inSlots({raised(1), raised(2)}), second(60)).came.size(), 0);
        QCOMPARE(stateOf(restored, 1), 'A');
        QCOMPARE(stateOf(restored, 2), 'U');

        ActiveAlarms late {cell}; // the store answers after the first round
        late.take(inSlots({raised(1), raised(2)}), second(60));
        late.restore(stored);
        QCOMPARE(stateOf(late, 1), 'A');
        QCOMPARE(late.entries().first().sighting.count, 1u);
        QCOMPARE(late.entries().first().sighting.firstSeen, second(0));
    }

    void aFloodStaysBounded()
    {
        ActiveAlarms alarms {cell};
        for (int i = 0; i < 3000; ++i) {
            const quint32 code = quint32(1 + 4 * i);
            alarms.take({raised(code + 3), raised(code + 2), raised(code + 1), raised(code)}, second(i));
            QVERIFY(alarms.entries().size() <= ActiveAlarms::mostListed);
        }
        QCOMPARE(alarms.entries().first().sighting.alarm.alarm.code, quint32(1 + 4 * 2999 + 3));
    }
};

QTEST_APPLESS_MAIN(TestActiveAlarms)
#include "tst_activealarms.moc"
