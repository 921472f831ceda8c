// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
// How a controller leaves the factory: the data behind Memory's constructor and Memory::demo().
#include "virtualcontroller/kinematics.h"
#include "virtualcontroller/machine.h"
#include "virtualcontroller/memory.h"
#include <QDirIterator>

using values::AxisWords;
using values::ControlGroup;
using values::FixedText;
using values::Status;

// Outside of all namespaces, as Qt demands it for a resource inside a static library.
static void initializeDemoResource() { Q_INIT_RESOURCE(demo); }

namespace virtualcontroller {

namespace {

std::map<QByteArray, QByteArray> demoFiles()
{
    initializeDemoResource();
    std::map<QByteArray, QByteArray> files;
    QDirIterator entries {QStringLiteral(":/demo"), QDir::Files};
    while (entries.hasNext()) {
        QFile file {entries.next()};
        if (file.open(QIODevice::ReadOnly))
            files[entries.fileName().toLatin1()] = file.readAll();
    }
    return files;
}

values::AlarmWithTexts pastAlarm(quint32 code, values::AlarmData data, const char *time, const char *name)
{
    values::AlarmWithTexts past;
    past.alarm = {code, data, FixedText<16> {time}, FixedText<32> {name}};
    return past;
}

std::map<values::AlarmHistoryClass, std::deque<values::AlarmWithTexts>> pastAlarms()
{
    using values::AlarmDataType;
    using values::AlarmHistoryClass;
    return {
        {AlarmHistoryClass::Major,
            {pastAlarm(1325, {1, AlarmDataType::AxesSlurbt}, "2026/01/09 14:22", "COMMUNICATION ERROR(ENCODER)"),
                pastAlarm(1204, {3, AlarmDataType::Unsigned16}, "2025/11/27 06:58", "COMMUNICATION ERROR(I/O)")}},
        {AlarmHistoryClass::Minor,
            {pastAlarm(4416, {2, AlarmDataType::AxesSlurbt}, "2026/01/11 10:05", "PULSE LIMIT(MIN/MAX)"),
                pastAlarm(4107, {1, AlarmDataType::AxesSlurbt}, "2026/01/05 07:31", "OUT OF RANGE(ABSO DATA)")}},
        {AlarmHistoryClass::UserSystem, {pastAlarm(8001, {}, "2025/12/18 16:40", "COOLING WATER LOW")}},
        {AlarmHistoryClass::User, {pastAlarm(9001, {}, "2026/01/12 08:12", "FIXTURE NOT CLAMPED")}},
    };
}

/// Sets the counters that exist for the configured groups, with some life behind them.
std::map<quint16, RunningTime> runningTimes(const Memory &memory)
{
    using Counter = values::ManagementTimeCounter;
    using Kind = values::ManagementTimeKind;
    const RunningTime sinceInstallation {QDateTime {QDate {2025, 3, 14}, QTime {9, 26}}, 811h};
    std::map<quint16, RunningTime> times {{Counter::controlPower().instance, sinceInstallation}};
    const auto add = [&](Kind kind, Time elapsed) {
        times[Counter::total(kind).instance] = {sinceInstallation.start, elapsed};
        for (const Group &group : memory.groups) {
            if (group.group.instance < 11 || group.group.instance > 20)
                times[quint16(int(kind) + group.group.instance - (group.isRobot() ? 0 : 10))] = {
                    sinceInstallation.start, elapsed};
        }
    };
    add(Kind::ServoPower, 402h + 17min);
    add(Kind::Playback, 318h + 3min);
    add(Kind::Motion, 296h + 44min);
    times[Counter::application(1).instance] = {sinceInstallation.start, 120h};
    return times;
}

void fillInformation(Memory &memory)
{
    const FixedText<24> software {"PENDESK VIRTUAL 1.00-00"};
    memory.systemInformation[11] = {software, FixedText<16> {"VIRTUAL-A00"}, FixedText<8> {"1.00"}};
    memory.systemInformation[101] = {software, FixedText<16> {"GENERAL"}, {}};
    memory.encoderTemperatures[1] = {{38, 41, 40, 36, 37, 35, 0, 0}};
    memory.converterTemperatures[1] = {{44, 0, 0, 0, 0, 0}};
}

void fillVariables(Memory &memory)
{
    memory.registers.resize(protocol::registers.count());
    memory.resizeVariables(memory.dialect.variables, memory.dialect.positionVariables);
    memory.i[0] = {120};
    memory.d[0] = {4711};
    memory.r[0] = {12.5F};
    memory.s[0] = {FixedText<32> {"PART A12"}};
    memory.p[0] = values::PositionVariable {{values::PositionType::Pulse, 0, 0, 0, 0, {0, 0, 0, 0, 0, 0}}};
    memory.p[1] =
        values::PositionVariable {{values::PositionType::Base, 4, 0, 0, 0, {1'085'000, 0, 620'000, 1'800'000, 0, 0}}};
}

} // namespace

Memory::Memory(const Settings &newSettings)
    : settings {newSettings},
      dialect {protocol::dialect(newSettings.model)},
      histories {pastAlarms()},
      files {demoFiles()}
{
    dialect.numbering = settings.numbering;
    status.data1 = Status::Data1 {Status::OneCycle} | Status::Play | Status::Remote;
    tasks.resize(1);
    groups.push_back({ControlGroup::robotPulse(1), kinematics::toCartesian(AxisWords {0, 0, 0, 0, 0, 0}), {}});
    fillInformation(*this);
    fillVariables(*this);
    times = runningTimes(*this);
}

Memory Memory::demo(const Settings &settings)
{
    Memory memory {settings};
    memory.status.data2.setFlag(Status::ServoOn);
    memory.setSignal(protocol::IoArea::UserInput, 1, true);
    setCycle(memory, values::CycleMode::Continuous);
    selectJob(memory, 0, "WELD_A12", 0);
    startJob(memory);
    return memory;
}

} // namespace virtualcontroller
