// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "asking.h"
#include "virtualcontroller/alarms.h"
#include "virtualcontroller/kinematics.h"
#include "virtualcontroller/script.h"
#include <QTest>

using namespace virtualcontroller;
using values::AxisWords;
using values::CycleMode;
using values::Status;

namespace {

/// A job of these instructions between NOP and END, with C00000 at 10000 pulses of S and C00001 at 0.
void addJob(Memory &memory, const QByteArray &name, const QByteArray &instructions)
{
    memory.files[name + ".JBI"] = "/JOB\r\n//NAME " + name
        + "\r\n//POS\r\n///NPOS 2,0,0,0,0,0\r\n///TOOL 0\r\n///POSTYPE PULSE\r\n///PULSE\r\nC00000=10000,0,0,0,0,0\r\n"
          "C00001=0,0,0,0,0,0\r\n//INST\r\n///DATE 2026/01/31 08:30\r\n///ATTR SC,RW\r\n///GROUP1 RB1\r\nNOP\r\n"
        + instructions + "END\r\n";
}

void begin(Memory &memory, const QByteArray &job)
{
    virtualcontroller::selectJob(memory, 0, job, 0);
    QCOMPARE(ask(memory, order(0x86, 1, 1)).status, quint8(0));
}

quint32 line(const Memory &memory) { return memory.executingJob(memory.tasks.front()).line; }
quint32 step(const Memory &memory) { return memory.executingJob(memory.tasks.front()).step; }
AxisWords pulses(const Memory &memory) { return memory.groups.front().pulsesAt(memory.now); }

} // namespace

class MachineTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void servoPowerComesAfterItsDelay();
    void servoOffForgetsTheOrderToSwitchOn();
    void teachClearsRemote();
    void modesStayConsistent();
    void aJobRunsThroughItsLines();
    void cycleModes_data();
    void cycleModes();
    void holdStopsAMoveWhereItIs();
    void servoOffStopsEverything();
    void movesEndAtTheirTarget_data();
    void movesEndAtTheirTarget();
    void incrementsAdd();
    void aStationMoves();
    void aTargetOutOfReachRaisesAnAlarm();
    void alarmsStopAndAreReset();
    void majorAlarmsSwitchServoOff();
    void alarmHistoriesKeepAHundred();
    void jobsCallJumpWaitAndCount();
    void brokenJobsDoNoHarm_data();
    void brokenJobsDoNoHarm();
    void followingErrorAndTorqueFollowTheMotion();
    void timeNeverGoesBack();
    void countersCount();
    void everyDemoJobRunsToItsEnd();
    void theScriptHappensInTime();
    void wrongScriptsAreExplained_data();
    void wrongScriptsAreExplained();
};

void MachineTest::servoPowerComesAfterItsDelay()
{
    Memory memory;
    QCOMPARE(ask(memory, order(0x83, 2, 1)).status, quint8(0));
    advanceTo(memory, memory.settings.servoDelay - 1ms);
    QVERIFY(!memory.status.isServoOn());
    advanceTo(memory, memory.settings.servoDelay);
    QVERIFY(memory.status.isServoOn());
}

void MachineTest::servoOffForgetsTheOrderToSwitchOn()
{
    Memory memory;
    ask(memory, order(0x83, 2, 1));
    ask(memory, order(0x83, 2, 2), 100ms);
    advanceTo(memory, 10s);
    QVERIFY(!memory.status.isServoOn());
}

void MachineTest::teachClearsRemote()
{
    Memory memory;
    setTeachMode(memory);
    QVERIFY(memory.status.isTeach() && !memory.status.isPlay() && !memory.status.isRemote());
    setRemote(memory, true);
    QVERIFY(!memory.status.isRemote());
    setPlayMode(memory);
    setRemote(memory, true);
    QVERIFY(memory.status.isPlay() && memory.status.isRemote() && !memory.status.isTeach());
}

void MachineTest::modesStayConsistent()
{
    Memory memory;
    QVERIFY(!memory.status.hasContradictoryMode());
    for (const quint32 cycle : {1, 2, 3}) {
        QCOMPARE(ask(memory, order(0x84, 2, cycle)).status, quint8(0));
        QVERIFY(!memory.status.hasContradictoryCycle());
        QCOMPARE(quint32(memory.status.data1.toInt() & 7), 1U << (cycle - 1));
    }
}

void MachineTest::aJobRunsThroughItsLines()
{
    Memory memory = ready();
    memory.settings.lineTime = 10ms;
    // 10000 pulses at 10 % of 60000 pulses a second take 1667 ms
    addJob(memory, "A", "'comment\r\nMOVJ C00000 VJ=10.00\r\nTIMER T=0.50\r\nMOVJ C00001 VJ=100.00\r\n");
    begin(memory, "A");
    QVERIFY(memory.status.isRunning());
    advanceTo(memory, 5ms);
    QCOMPARE(line(memory), 0U);
    QCOMPARE(step(memory), 0U);
    advanceTo(memory, 25ms);
    QCOMPARE(line(memory), 2U); // NOP and the comment took 10 ms each
    QCOMPARE(step(memory), 1U);
    advanceTo(memory, 20ms + 1667ms + 100ms);
    QCOMPARE(line(memory), 3U);
    QCOMPARE(step(memory), 1U);
    QCOMPARE(pulses(memory)[0], 10000);
    advanceTo(memory, 20ms + 1667ms + 500ms + 50ms);
    QCOMPARE(line(memory), 4U);
    QCOMPARE(step(memory), 2U);
    advanceTo(memory, 10s);
    QVERIFY(!memory.status.isRunning());
    QCOMPARE(line(memory), 0U);
    QCOMPARE(pulses(memory)[0], 0);
    QVERIFY(memory.status.isServoOn());
}

void MachineTest::cycleModes_data()
{
    QTest::addColumn<quint32>("mode");
    QTest::addColumn<bool>("runsAfterEnd");
    QTest::addColumn<quint32>("lineAfterFirst");
    QTest::newRow("step") << 1U << false << 1U;
    QTest::newRow("one cycle") << 2U << false << 0U;
    QTest::newRow("continuous") << 3U << true << 0U;
}

void MachineTest::cycleModes()
{
    QFETCH(quint32, mode);
    QFETCH(bool, runsAfterEnd);
    Memory memory = ready();
    memory.settings.lineTime = 10ms;
    addJob(memory, "A", "SET B000 1\r\n");
    setCycle(memory, CycleMode(mode));
    begin(memory, "A");
    advanceTo(memory, 10ms);
    QCOMPARE(memory.status.isRunning(), mode != 1); // step stops after each line
    if (mode == 1) {
        QTEST(line(memory), "lineAfterFirst");
        QCOMPARE(int(memory.b[0].value), 0);
        ask(memory, order(0x86, 1, 1), 20ms);
        advanceTo(memory, 30ms);
        QCOMPARE(int(memory.b[0].value), 1);
        QCOMPARE(line(memory), 2U);
    }
    advanceTo(memory, 1003ms);
    QCOMPARE(memory.status.isRunning(), runsAfterEnd);
}

void MachineTest::holdStopsAMoveWhereItIs()
{
    Memory memory = ready();
    const auto start = memory.groups.front().pose;
    QCOMPARE(ask(memory, moveTo(cartesian(start[0] + 100'000, 0, 620'000, 100))).status, quint8(0)); // 10 mm/s: 10 s
    QVERIFY(memory.status.isRunning());
    QCOMPARE(ask(memory, moveTo(cartesian(start[0], 0, 620'000))).code, quint16(0x2010));
    QCOMPARE(ask(memory, order(0x83, 1, 1), 5s).status, quint8(0));
    QVERIFY(!memory.status.isRunning());
    QVERIFY(memory.status.isServoOn() && memory.status.isHeld());
    const auto stopped = memory.groups.front().cartesianAt(memory.now);
    QCOMPARE(stopped[0], start[0] + 50'000); // half the time is half the way
    advanceTo(memory, 20s);
    QCOMPARE(memory.groups.front().cartesianAt(memory.now), stopped);
    QCOMPARE(ask(memory, moveTo(cartesian(start[0], 0, 620'000))).code, quint16(0x2050));
    QCOMPARE(ask(memory, order(0x83, 1, 2)).status, quint8(0));
    QVERIFY(!memory.status.isHeld() && !memory.status.isRunning());
}

void MachineTest::servoOffStopsEverything()
{
    Memory memory = ready();
    addJob(memory, "A", "MOVJ C00000 VJ=1.00\r\n");
    begin(memory, "A");
    advanceTo(memory, 1s);
    ask(memory, order(0x83, 2, 2));
    QVERIFY(!memory.status.isRunning() && !memory.status.isServoOn());
    const auto stopped = pulses(memory);
    QVERIFY(stopped[0] > 0 && stopped[0] < 10000);
    advanceTo(memory, 60s);
    QCOMPARE(pulses(memory), stopped);
    QCOMPARE(line(memory), 1U);
    // Started again it goes on with the line that it left.
    ask(memory, order(0x83, 2, 1));
    advanceTo(memory, memory.now + 1s);
    ask(memory, order(0x86, 1, 1));
    advanceTo(memory, memory.now + 60s);
    QCOMPARE(pulses(memory)[0], 10000);
}

void MachineTest::movesEndAtTheirTarget_data()
{
    QTest::addColumn<values::Speed>("speed");
    QTest::addColumn<int>("instance");
    QTest::addColumn<int>("takes"); // ms
    using values::SpeedClass;
    // 100 mm in X are 20000 pulses of S; Rz turns by 9 degrees, 9000 pulses of T.
    QTest::newRow("10 %") << values::Speed {SpeedClass::Percent, 1000} << 1 << 3333; // 20000 / 6000 per s
    QTest::newRow("50 mm/s") << values::Speed {SpeedClass::ToolPoint, 500} << 2 << 2000;
    QTest::newRow("3 degree/s") << values::Speed {SpeedClass::Rotation, 30} << 2 << 3000;
}

void MachineTest::movesEndAtTheirTarget()
{
    QFETCH(values::Speed, speed);
    QFETCH(int, instance);
    QFETCH(int, takes);
    Memory memory = ready();
    auto target = cartesian(1'185'000, 0, 620'000);
    target.speed = speed;
    target.rotation[2] = 90'000;
    QCOMPARE(ask(memory, moveTo(target, quint16(instance))).status, quint8(0));
    advanceTo(memory, Time {takes - 1});
    QVERIFY(memory.status.isRunning());
    advanceTo(memory, Time {takes});
    QVERIFY(!memory.status.isRunning());
    QCOMPARE(memory.groups.front().cartesianAt(memory.now), (AxisWords {1'185'000, 0, 620'000, 1'800'000, 0, 90'000}));
    QCOMPARE(pulses(memory), (AxisWords {20'000, 0, 0, 0, 0, 9'000}));
}

void MachineTest::incrementsAdd()
{
    Memory memory = ready();
    auto target = cartesian(0, 0, -10'000);
    target.rotation = {};
    target.frame = values::PositionType::Tool;
    QCOMPARE(ask(memory, moveTo(target, 3)).status, quint8(0));
    advanceTo(memory, 10s);
    QCOMPARE(memory.groups.front().cartesianAt(memory.now)[2], 610'000);
    values::PulseTarget pulse;
    pulse.speed = {values::SpeedClass::Percent, 10000};
    pulse.axes = {1, -2, 3, -4, 5, -6, 7, 8};
    QCOMPARE(ask(memory, moveTo(pulse)).status, quint8(0));
    advanceTo(memory, 20s);
    QCOMPARE(pulses(memory), (AxisWords {1, -2, 3, -4, 5, -6}));
}

void MachineTest::aStationMoves()
{
    Memory memory = ready();
    memory.groups.push_back({values::ControlGroup::stationPulse(1), {0, 0}, {}});
    values::PulseTarget target;
    target.robot = 0;
    target.station = 1;
    target.speed = {values::SpeedClass::Percent, 5000};
    target.stationAxes = {3000, -1000};
    QCOMPARE(ask(memory, moveTo(target)).status, quint8(0));
    advanceTo(memory, 99ms);
    QVERIFY(memory.status.isRunning());
    advanceTo(memory, 100ms); // 3000 pulses at 30000 per s
    QVERIFY(!memory.status.isRunning());
    QCOMPARE(memory.groups.back().pose, (AxisWords {3000, -1000}));
}

void MachineTest::aTargetOutOfReachRaisesAnAlarm()
{
    Memory memory = ready();
    // 1 m from 0 are the 200000 pulses that are allowed.
    QCOMPARE(ask(memory, moveTo(cartesian(2'085'005, 0, 620'000))).status, quint8(0));
    QVERIFY(memory.status.hasAlarm() && !memory.status.isRunning() && memory.status.isServoOn());
    QCOMPARE(memory.alarms.front().alarm.alarm.code, 4416U);
    QCOMPARE(memory.alarms.front().alarm.alarm.data.value, 1U);
    QCOMPARE(pulses(memory), (AxisWords {0, 0, 0, 0, 0, 0}));
    ask(memory, order(0x82, 1, 1));
    QVERIFY(!memory.status.hasAlarm());
    QCOMPARE(ask(memory, moveTo(cartesian(2'085'000, 0, 620'000))).status, quint8(0));
    QVERIFY(!memory.status.hasAlarm());
}

void MachineTest::alarmsStopAndAreReset()
{
    Memory memory = ready();
    addJob(memory, "A", "MOVJ C00000 VJ=1.00\r\n");
    begin(memory, "A");
    advanceTo(memory, 1s);
    values::AlarmWithTexts alarm;
    alarm.alarm.code = 4321;
    raiseAlarm(memory, alarm, true);
    QVERIFY(memory.status.hasAlarm() && !memory.status.isRunning() && memory.status.isServoOn());
    QCOMPARE(ask(memory, order(0x86, 1, 1)).code, quint16(0x2060));
    QCOMPARE(ask(memory, order(0x82, 1, 1)).status, quint8(0)); // the cause is still there: done, and nothing gone
    QVERIFY(memory.status.hasAlarm());
    removeCause(memory, 4321);
    QVERIFY(memory.status.hasAlarm());
    ask(memory, order(0x82, 1, 1));
    QVERIFY(!memory.status.hasAlarm());
    QVERIFY(memory.alarms.empty());
    QCOMPARE(memory.histories[values::AlarmHistoryClass::Minor].front().alarm.code, 4321U);

    raiseError(memory);
    QVERIFY(memory.status.hasError());
    ask(memory, order(0x82, 2, 1));
    QVERIFY(!memory.status.hasError());
}

void MachineTest::majorAlarmsSwitchServoOff()
{
    Memory memory = ready();
    raiseAlarm(memory, 1325, "ENCODER");
    QVERIFY(memory.status.hasAlarm() && !memory.status.isServoOn());
    QCOMPARE(ask(memory, order(0x83, 2, 1)).code, quint16(0x2060));
}

void MachineTest::alarmHistoriesKeepAHundred()
{
    Memory memory;
    for (quint32 code = 9001; code <= 9150; ++code)
        raiseAlarm(memory, code, "USER");
    const auto &history = memory.histories[values::AlarmHistoryClass::User];
    QCOMPARE(history.size(), std::size_t(100));
    QCOMPARE(history.front().alarm.code, 9150U);
    QCOMPARE(history.back().alarm.code, 9051U);
}

void MachineTest::jobsCallJumpWaitAndCount()
{
    Memory memory = ready();
    memory.settings.lineTime = 10ms;
    addJob(memory, "SUB", "INC B001\r\nRET\r\nSET B002 9\r\n");
    addJob(memory, "A",
        "SET B000 0\r\n*AGAIN\r\nCALL JOB:SUB\r\nINC B000\r\nJUMP *AGAIN IF B000<3\r\nWAIT IN#(2)=ON\r\n"
        "DOUT OT#(9) ON\r\nADD I000 5\r\nWAIT IN#(3)=ON T=0.50\r\nSET D000 -70000\r\n");
    begin(memory, "A");
    memory.i[0].value = 0;
    advanceTo(memory, 5s);
    QCOMPARE(int(memory.b[0].value), 3);
    QCOMPARE(int(memory.b[1].value), 3);
    QCOMPARE(int(memory.b[2].value), 0);
    QCOMPARE(line(memory), 6U); // waits
    QVERIFY(memory.status.isRunning());
    QVERIFY(!memory.signal(protocol::IoArea::UserOutput, 9));
    memory.setSignal(protocol::IoArea::UserInput, 2, true);
    advanceTo(memory, 5100ms);
    QVERIFY(memory.signal(protocol::IoArea::UserOutput, 9));
    QCOMPARE(ask(memory, {0x78, 1002, 1, protocol::Service::GetSingle}).payload, QByteArray(1, '\1'));
    QCOMPARE(int(memory.i[0].value), 5);
    advanceTo(memory, 6s);
    QCOMPARE(memory.d[0].value, -70000);
    QVERIFY(!memory.status.isRunning());
}

void MachineTest::brokenJobsDoNoHarm_data()
{
    QTest::addColumn<QByteArray>("instruction");
    QTest::addColumn<bool>("endsInAlarm");
    const auto row = [](const char *instruction, bool endsInAlarm) {
        QTest::newRow(instruction) << QByteArray(instruction) << endsInAlarm;
    };
    row("MOVJ P099 VJ=10.00", true); // never taught
    row("MOVJ C00009 VJ=10.00", true);
    row("MOVJ", true);
    row("MOVL C00000 V=inf", false);
    row("MOVL C00000 V=nan", false);
    row("CALL JOB:NONE", true);
    row("CALL JOB:A", true); // itself, for ever
    row("CALL", true);
    row("JUMP *NOWHERE", true);
    row("JUMP *NOWHERE IF B000=1", false);
    row("JUMP", true);
    row("RET IF", false);
    row("TIMER T=", false);
    row("TIMER T=-1", false);
    row("WAIT IN#( T=0.1", false);
    row("DOUT", false);
    row("DOUT OT#( ON", false);
    row("DOUT OT#(99999999) ON", false);
    row("DOUT OT#(-1) ON", false);
    row("DIN B000 IN#()", false);
    row("SET B999 1", false);
    row("SET B 1", false);
    row("SET", false);
    row("INC D", false);
    row("FROBNICATE 1 2 3", false);
    row("JUMP *NOWHERE IF =", false);
    row("JUMP *NOWHERE IF B000<>0", false);
    row("JUMP *NOWHERE IF 2>=2", true);
}

void MachineTest::brokenJobsDoNoHarm()
{
    QFETCH(QByteArray, instruction);
    Memory memory = ready();
    addJob(memory, "A", instruction + "\r\n");
    begin(memory, "A");
    advanceTo(memory, 60s);
    QVERIFY(!memory.status.isRunning());
    QTEST(memory.status.hasAlarm(), "endsInAlarm");
}

void MachineTest::followingErrorAndTorqueFollowTheMotion()
{
    Memory memory = ready();
    const Group &robot = memory.groups.front();
    QCOMPARE(robot.followingErrorAt(0ms), (AxisWords {0, 0, 0, 0, 0, 0}));
    const auto standing = robot.torqueAt(0ms, true);
    QVERIFY(standing[1] != 0);
    QCOMPARE(robot.torqueAt(0ms, false), (AxisWords {0, 0, 0, 0, 0, 0}));
    ask(memory, moveTo(cartesian(1'185'000, 0, 620'000, 500))); // 2 s
    QVERIFY(robot.followingErrorAt(1s)[0] > robot.followingErrorAt(200ms)[0]);
    QVERIFY(robot.torqueAt(200ms, true)[0] > 0);
    QVERIFY(robot.torqueAt(1800ms, true)[0] < 0);
    advanceTo(memory, 2s);
    QCOMPARE(robot.followingErrorAt(2s), (AxisWords {0, 0, 0, 0, 0, 0}));
    QCOMPARE(robot.torqueAt(2s, true), standing);
}

void MachineTest::timeNeverGoesBack()
{
    Memory memory = ready();
    advanceTo(memory, 5s);
    advanceTo(memory, 1s);
    QCOMPARE(memory.now, Time {5s});
}

void MachineTest::countersCount()
{
    Memory memory = ready();
    memory.settings.lineTime = 10ms;
    for (auto &[instance, counter] : memory.times)
        counter.elapsed = 0ms;
    addJob(memory, "A", "MOVJ C00000 VJ=10.00\r\nTIMER T=1.00\r\n"); // 1667 ms of motion in 2687 ms of play
    begin(memory, "A");
    advanceTo(memory, 10s);
    ask(memory, order(0x83, 2, 2));
    advanceTo(memory, 20s);
    QCOMPARE(memory.times[1].elapsed, Time {20s});
    QCOMPARE(memory.times[10].elapsed, Time {10s});
    QCOMPARE(memory.times[111].elapsed, Time {2687ms});
    QCOMPARE(memory.times[211].elapsed, Time {1667ms});
}

void MachineTest::everyDemoJobRunsToItsEnd()
{
    for (const auto &[name, contents] : Memory {}.files) {
        if (!name.endsWith(".JBI"))
            continue;
        Memory memory = ready();
        memory.setSignal(protocol::IoArea::UserInput, 1, true);
        memory.setSignal(protocol::IoArea::UserInput, 9, true);
        begin(memory, name.chopped(4));
        advanceTo(memory, 600s);
        QVERIFY2(!memory.status.isRunning() && !memory.status.hasAlarm(), name);
        QCOMPARE(line(memory), 0U);
    }
}

void MachineTest::theScriptHappensInTime()
{
    auto script = Script::parse(R"([{"at": 2, "hold": "pendant", "on": true}, {"at": 1, "input": 3, "on": true},
        {"at": 3, "alarm": 4416, "name": "LIMIT", "cause": true}, {"at": 4, "removeCause": 4416},
        {"at": 5, "mode": "teach"}, {"at": 6, "safety": false}, {"at": 7, "silence": 1.5}])");
    QVERIFY(script);
    Memory memory = ready();
    script->run(memory, 999ms);
    QVERIFY(!memory.signal(protocol::IoArea::UserInput, 3));
    QCOMPARE(script->next(), std::optional {Time {1s}});
    script->run(memory, 2s);
    QVERIFY(memory.signal(protocol::IoArea::UserInput, 3));
    QVERIFY(memory.status.data2 & Status::HeldByPendant);
    script->run(memory, 3s);
    QVERIFY(memory.status.hasAlarm() && memory.alarms.front().hasCause);
    script->run(memory, 10s);
    QVERIFY(!memory.alarms.front().hasCause);
    QVERIFY(memory.status.isTeach() && !memory.status.isServoOn());
    QCOMPARE(memory.silentUntil, Time {8500ms});
    QCOMPARE(script->next(), std::nullopt);
}

void MachineTest::wrongScriptsAreExplained_data()
{
    QTest::addColumn<QByteArray>("json");
    QTest::addColumn<QString>("part");
    QTest::newRow("no JSON") << QByteArray("[") << "not a JSON array";
    QTest::newRow("an object") << QByteArray("{}") << "not a JSON array";
    QTest::newRow("no time") << QByteArray(R"([{"mode": "teach"}])") << "Event 1";
    QTest::newRow("negative time") << QByteArray(R"([{"at": -1, "mode": "teach"}])") << "\"at\"";
    QTest::newRow("nothing happens") << QByteArray(R"([{"at": 1}])") << "no key";
    QTest::newRow("unknown mode") << QByteArray(R"([{"at":1,"mode":"play"},{"at": 1, "mode": "x"}])") << "Event 2";
    QTest::newRow("alarm 0") << QByteArray(R"([{"at": 1, "alarm": 0}])") << "\"alarm\"";
    QTest::newRow("hold without on") << QByteArray(R"([{"at": 1, "hold": "pendant"}])") << "\"hold\"";
}

void MachineTest::wrongScriptsAreExplained()
{
    QFETCH(QByteArray, json);
    QFETCH(QString, part);
    const auto script = Script::parse(json);
    QVERIFY(!script);
    QVERIFY2(script.error().detail.contains(part), qPrintable(script.error().detail));
}

QTEST_GUILESS_MAIN(MachineTest)
#include "tst_machine.moc"
