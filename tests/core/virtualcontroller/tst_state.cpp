// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "core/virtualcontroller/asking.h"
#include "virtualcontroller/state.h"
#include <QTest>

using namespace virtualcontroller;
using values::AxisWords;

class StateTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void takesEverything();
    void keepsWhatIsNotNamed();
    void takesVariableCounts();
    void explainsMistakes_data();
    void explainsMistakes();
};

void StateTest::takesEverything()
{
    Memory memory;
    const auto applied = applyState(R"({
        "status": {"mode": "play", "remote": false, "servo": true, "cycle": "continuous", "hold": [], "error": true},
        "interlocks": {"editing": true, "homeConfirmed": false},
        "files": {"A.JBI": "/JOB\r\n//NAME A\r\n//INST\r\nNOP\r\n'x\r\nEND\r\n"},
        "job": {"name": "A", "line": 1, "override": 5000, "running": true},
        "positions": {"R1": [1, 2, 3, 4, 5, 6, 7], "S1": [8]},
        "alarms": [{"code": 4416, "data": 2, "type": 3, "name": "LIMIT", "time": "2026/01/31 08:30", "cause": true,
                    "subText": "L", "extra": "[SV#1]"}],
        "histories": {"major": [], "offline": [{"code": 1}, {"code": 2}]},
        "io": {"2701": 5},
        "registers": {"7": 65535},
        "variables": {"B099": 255, "I000": -1, "D001": -70000, "R002": 1.5, "S003": "text",
                      "P004": {"type": 18, "userFrame": 3, "tool": 1, "axes": [1, 2, 3]}, "P000": null,
                      "BP005": {"type": 16, "axes": [9]}, "EX006": {"axes": [1]}},
        "times": {"1": {"start": "2025/03/14 09:26", "seconds": 61}},
        "systemInformation": {"11": {"software": "X 1.0", "model": "ARM", "parameters": "2.0"}},
        "encoderTemperatures": {"1": [30, 31]}, "converterTemperatures": {"2": 44}
    })",
        memory);
    QVERIFY2(applied, applied ? "" : qPrintable(applied.error().detail));
    QCOMPARE(quint32(memory.status.data1.toInt()), 0x4CU); // continuous, running, play
    QCOMPARE(quint32(memory.status.data2.toInt()), 0x70U); // alarm, error, servo
    QVERIFY(memory.interlocks.isEditing && !memory.interlocks.isHomeConfirmed);
    const auto job = memory.executingJob(memory.tasks.front());
    QCOMPARE(job, (values::ExecutingJob {values::JobName {"A"}, 1, 0, 5000}));
    QCOMPARE(memory.findGroup({1})->pulsesAt({}), (AxisWords {1, 2, 3, 4, 5, 6, 7}));
    QCOMPARE(memory.findGroup({21})->pulsesAt({}), (AxisWords {8}));
    QCOMPARE(memory.alarms.size(), std::size_t(1));
    QCOMPARE(memory.alarms[0].alarm.alarm.data, (values::AlarmData {2, values::AlarmDataType::AxesSlurbt}));
    QVERIFY(memory.alarms[0].hasCause);
    QVERIFY(memory.histories[values::AlarmHistoryClass::Major].empty());
    QCOMPARE(memory.histories[values::AlarmHistoryClass::Offline][1].alarm.code, 2U);
    QCOMPARE(int(memory.io[2701]), 5);
    QCOMPARE(int(memory.registers[7].value), 65535);
    QCOMPARE(int(memory.b[99].value), 255);
    QCOMPARE(memory.i[0].value, qint16(-1));
    QCOMPARE(memory.d[1].value, -70000);
    QCOMPARE(memory.r[2].value, 1.5F);
    QCOMPARE(memory.s[3].value.bytes(), QByteArrayView("text"));
    QVERIFY(memory.p[4]->position.type == values::PositionType::User);
    QCOMPARE(memory.p[4]->position.axes, (AxisWords {1, 2, 3, 0, 0, 0, 0, 0}));
    QVERIFY(!memory.p[0]);
    QVERIFY(memory.bp[5]->type == values::PositionType::Base);
    QVERIFY(memory.ex[6]);
    QCOMPARE(memory.times[1].elapsed, Time {61s});
    QCOMPARE(memory.systemInformation[11].model.bytes(), QByteArrayView("ARM"));
    QCOMPARE(memory.encoderTemperatures[1].celsius[1], 31);
    QCOMPARE(memory.converterTemperatures[2].celsius(), 44);
}

void StateTest::keepsWhatIsNotNamed()
{
    Memory memory;
    memory.b[5].value = 3;
    QVERIFY(applyState(R"({"variables": {"B006": 4}})", memory));
    QCOMPARE(int(memory.b[5].value), 3);
    QCOMPARE(int(memory.b[6].value), 4);
    QVERIFY(memory.status.isRemote());
    QVERIFY(memory.files.contains("WELD_A12.JBI"));
}

/// More variables than the standard ones (reference §0.1 l).
void StateTest::takesVariableCounts()
{
    Memory memory;
    QVERIFY(applyState(R"({"variableCounts": {"variables": 250, "positionVariables": 256},
        "variables": {"B249": 7, "P255": {"type": 0}}})",
        memory));
    QCOMPARE(int(memory.b[249].value), 7);
    QVERIFY(memory.p[255]);
    QCOMPARE(memory.i[0].value, qint16(120)); // what was there stays
    QCOMPARE(ask(memory, {0x7A, 249, 1, protocol::Service::GetSingle, {}}).payload, QByteArray(1, 7));
    QCOMPARE(ask(memory, {0x7A, 250, 1, protocol::Service::GetSingle, {}}).code, quint16(0xA001));
}

void StateTest::explainsMistakes_data()
{
    QTest::addColumn<QByteArray>("json");
    QTest::addColumn<QString>("start");
    const auto row = [](const char *json, const char *start) {
        QTest::newRow(json) << QByteArray(json) << QString::fromLatin1(start);
    };
    row("", "The state is not a JSON object");
    row("[]", "The state is not a JSON object");
    row(R"({"colour": 1})", "colour is not a key");
    row(R"({"status": 1})", "status is not an object");
    row(R"({"status": {"mode": "auto"}})", "status.mode is none of play, teach");
    row(R"({"status": {"remote": 1}})", "status.remote is neither true nor false");
    row(R"({"status": {"hold": ["nobody"]}})", "status.hold[0] is none of");
    row(R"({"variables": {"B000": 256}})", "variables.B000 is not a whole number from 0 to 255");
    row(R"({"variables": {"B100": 1}})", "variables.B100 is not a variable of this controller");
    row(R"({"variables": {"X000": 1}})", "variables.X000 is not a variable like");
    row(R"({"variables": {"B": 1}})", "variables.B is not a variable like");
    row(R"({"variables": {"P000": {"tool": 64}}})", "variables.P000.tool is not");
    row(R"({"variables": {"P000": {"axes": [1,2,3,4,5,6,7,8,9]}}})", "variables.P000.axes has more");
    row(R"({"variables": {"I000": 1.5}})", "variables.I000 is not a whole number");
    row(R"({"positions": {"X1": [1]}})", "positions has no control group X1");
    row(R"({"positions": {"R9": [1]}})", "positions has no control group R9");
    row(R"({"positions": {"R1": 1}})", "positions.R1 is not a list");
    row(R"({"variableCounts": {"variables": 0}})", "variableCounts.variables is not a whole number");
    row(R"({"job": {"name": "NONE"}})", "job names a job that is not there");
    row(R"({"alarms": [{"code": 1}, {"code": 0}]})", "alarms[1].code is not");
    row(R"({"io": {"0": 1}})", "io.0 is not an I/O group");
    row(R"({"registers": {"1000": 1}})", "registers.1000 is not a register");
    row(R"({"times": {"1": {"start": "yesterday"}}})", "times.1.start is not a time");
    row(R"({"systemInformation": {"R1": {}}})", "systemInformation.R1 is not named by a number");
    row(R"({"systemInformation": {"11": {"model": "12345678901234567"}}})", "systemInformation.11.model is not a text");
}

void StateTest::explainsMistakes()
{
    QFETCH(QByteArray, json);
    QFETCH(QString, start);
    Memory memory;
    const auto status = memory.status;
    const auto applied = applyState(json, memory);
    QVERIFY(!applied);
    QCOMPARE(applied.error().kind, values::ErrorKind::BadInput);
    QVERIFY2(applied.error().detail.startsWith(start), qPrintable(applied.error().detail));
    QCOMPARE(memory.status, status);
}

QTEST_GUILESS_MAIN(StateTest)
#include "tst_state.moc"
