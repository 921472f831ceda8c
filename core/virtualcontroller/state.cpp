// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "virtualcontroller/state.h"

#include "virtualcontroller/alarms.h"
#include "virtualcontroller/kinematics.h"
#include "virtualcontroller/machine.h"
#include "virtualcontroller/statereader.h"
#include "virtualcontroller/statevariables.h"
#include <QJsonDocument>

using values::AlarmHistoryClass;
using values::ControlGroup;
using values::CycleMode;
using values::FixedText;
using values::Status;

namespace virtualcontroller {

namespace {

constexpr quint32 maxWord = 0xFFFF'FFFF;

/// What is done with one key of an object.
template <typename Target> struct Key {
    const char *name;
    void (*take)(const StateValue &, Target &);
};

/// Gives each entry of an object to the row of its key, in the order of the rows. An unknown key is a fault.
template <typename Target, std::size_t Count>
void take(const StateValue &object, Target &target, const std::array<Key<Target>, Count> &keys)
{
    const auto entries = object.entries();
    for (const auto &[name, value] : entries) {
        const auto isThis = [&name = name](const Key<Target> &key) { return name == QLatin1StringView {key.name}; };
        if (std::ranges::none_of(keys, isThis))
            value.complain(QStringLiteral("is not a key that is known here"));
    }
    for (const Key<Target> &key : keys) {
        for (const auto &[name, value] : entries) {
            if (name == QLatin1StringView {key.name})
                key.take(value, target);
        }
    }
}

/// The number that a key is, in first..last.
std::optional<quint16> numberKey(const QString &key, const StateValue &value)
{
    bool ok = false;
    const quint16 number = key.toUShort(&ok);
    if (!ok)
        value.complain(QStringLiteral("is not named by a number"));
    return ok ? std::optional {number} : std::nullopt;
}

// status and interlocks

template <auto flag> void takeData1(const StateValue &v, Memory &m) { m.status.data1.setFlag(flag, v.boolean()); }
template <auto flag> void takeData2(const StateValue &v, Memory &m) { m.status.data2.setFlag(flag, v.boolean()); }

void takeMode(const StateValue &value, Memory &memory)
{
    value.choice({QStringLiteral("play"), QStringLiteral("teach")}) == 0 ? setPlayMode(memory) : setTeachMode(memory);
}

void takeCycle(const StateValue &value, Memory &memory)
{
    const QStringList words {QStringLiteral("step"), QStringLiteral("oneCycle"), QStringLiteral("continuous")};
    setCycle(memory, CycleMode(quint32(CycleMode::Step) + quint32(value.choice(words))));
}

void takeHolds(const StateValue &value, Memory &memory)
{
    constexpr std::array flags {Status::HeldByPendant, Status::HeldExternally, Status::HeldByCommand};
    const QStringList words {QStringLiteral("pendant"), QStringLiteral("external"), QStringLiteral("command")};
    for (const auto flag : flags)
        setHold(memory, flag, false);
    for (const StateValue &item : value.items())
        setHold(memory, flags[std::size_t(item.choice(words))], true);
}

void takeStatus(const StateValue &value, Memory &memory)
{
    static constexpr std::array<Key<Memory>, 7> keys {{
        {"mode", takeMode},
        {"remote", [](const StateValue &v, Memory &m) { setRemote(m, v.boolean()); }},
        {"servo", takeData2<Status::ServoOn>},
        {"cycle", takeCycle},
        {"hold", takeHolds},
        {"speedLimited", takeData1<Status::SpeedLimited>},
        {"error", takeData2<Status::Error>},
    }};
    take(value, memory, keys);
}

template <auto member> void takeInterlock(const StateValue &v, Interlocks &interlocks)
{
    interlocks.*member = v.boolean();
}

void takeInterlocks(const StateValue &value, Memory &memory)
{
    static constexpr std::array<Key<Interlocks>, 11> keys {{
        {"safetyChainClosed", takeInterlock<&Interlocks::isSafetyChainClosed>},
        {"editing", takeInterlock<&Interlocks::isEditing>},
        {"filesInUse", takeInterlock<&Interlocks::areFilesInUse>},
        {"dataLocked", takeInterlock<&Interlocks::isDataLocked>},
        {"panelLocked", takeInterlock<&Interlocks::isPanelLocked>},
        {"startLocked", takeInterlock<&Interlocks::isStartLocked>},
        {"homeConfirmed", takeInterlock<&Interlocks::isHomeConfirmed>},
        {"teachLocked", takeInterlock<&Interlocks::isTeachLocked>},
        {"jobSelectPermitted", takeInterlock<&Interlocks::isJobSelectPermitted>},
        {"masterCallPermitted", takeInterlock<&Interlocks::isMasterCallPermitted>},
        {"masterCalled", takeInterlock<&Interlocks::isMasterCalled>},
    }};
    take(value, memory.interlocks, keys);
}

// files and job

void takeFiles(const StateValue &value, Memory &memory)
{
    for (const auto &[name, file] : value.entries())
        memory.files[name.toLatin1()] = file.text(maxFileSize);
}

struct JobState {
    QByteArray name;
    int line = 0;
    quint32 speedOverride = 10000;
    bool isRunning = false;
};

void takeJob(const StateValue &value, Memory &memory)
{
    static constexpr std::array<Key<JobState>, 4> keys {{
        {"name", [](const StateValue &v, JobState &job) { job.name = v.text(32); }},
        {"line", [](const StateValue &v, JobState &job) { job.line = int(v.number(0, 9999)); }},
        {"override", [](const StateValue &v, JobState &job) { job.speedOverride = quint32(v.number(1, 25500)); }},
        {"running", [](const StateValue &v, JobState &job) { job.isRunning = v.boolean(); }},
    }};
    JobState job;
    take(value, job, keys);
    if (!memory.program(job.name))
        return value.complain(QStringLiteral("names a job that is not there"));
    selectJob(memory, 0, job.name, job.line);
    memory.tasks.front().speedOverride = job.speedOverride;
    if (job.isRunning)
        startJob(memory);
}

// positions

/// The group that "R1", "B1" or "S1" names.
std::optional<ControlGroup> groupOf(const QString &name, const protocol::Dialect &dialect)
{
    bool ok = false;
    const int number = name.sliced(std::min<qsizetype>(1, name.size())).toInt(&ok);
    if (!ok || number < 1)
        return std::nullopt;
    if (name.startsWith(u'R') && number <= dialect.robots)
        return ControlGroup::robotPulse(number);
    if (name.startsWith(u'B') && number <= dialect.bases)
        return ControlGroup::basePulse(number);
    if (name.startsWith(u'S') && number <= dialect.stations)
        return ControlGroup::stationPulse(number);
    return std::nullopt;
}

void takePositions(const StateValue &value, Memory &memory)
{
    for (const auto &[name, words] : value.entries()) {
        const auto which = groupOf(name, memory.dialect);
        if (!which) {
            value.complain(QStringLiteral("has no control group %1 on this model").arg(name));
            return;
        }
        if (!memory.findGroup(*which))
            memory.groups.push_back({*which, {}, {}});
        Group &group = *memory.findGroup(*which);
        const auto pulses = axisWords(words);
        group.pose = group.isRobot() ? kinematics::toCartesian(pulses) : pulses;
    }
}

// alarms

ActiveAlarm alarmOf(const StateValue &value)
{
    static constexpr std::array<Key<ActiveAlarm>, 8> keys {{
        {"code", [](const StateValue &v, ActiveAlarm &a) { a.alarm.alarm.code = quint32(v.number(1, 9999)); }},
        {"data", [](const StateValue &v, ActiveAlarm &a) { a.alarm.alarm.data.value = quint32(v.number(0, maxWord)); }},
        {"type",
            [](const StateValue &v, ActiveAlarm &a) {
                a.alarm.alarm.data.type = values::AlarmDataType(v.number(0, maxWord));
            }},
        {"time", [](const StateValue &v, ActiveAlarm &a) { a.alarm.alarm.time = FixedText<16> {v.text(16)}; }},
        {"name", [](const StateValue &v, ActiveAlarm &a) { a.alarm.alarm.name = FixedText<32> {v.text(32)}; }},
        {"extra", [](const StateValue &v, ActiveAlarm &a) { a.alarm.extra = FixedText<16> {v.text(16)}; }},
        {"subText", [](const StateValue &v, ActiveAlarm &a) { a.alarm.subText = FixedText<96> {v.text(96)}; }},
        {"cause", [](const StateValue &v, ActiveAlarm &a) { a.hasCause = v.boolean(); }},
    }};
    ActiveAlarm alarm;
    take(value, alarm, keys);
    return alarm;
}

void takeAlarms(const StateValue &value, Memory &memory)
{
    memory.alarms.clear();
    for (const StateValue &item : value.items())
        memory.alarms.push_back(alarmOf(item));
    memory.status.data2.setFlag(Status::Alarm, !memory.alarms.empty());
}

template <AlarmHistoryClass kind> void takeHistory(const StateValue &value, Memory &memory)
{
    auto &history = memory.histories[kind];
    history.clear();
    for (const StateValue &item : value.items())
        history.push_back(alarmOf(item).alarm);
    history.resize(std::min<std::size_t>(history.size(), values::alarmHistoryLength));
}

void takeHistories(const StateValue &value, Memory &memory)
{
    static constexpr std::array<Key<Memory>, 5> keys {{
        {"major", takeHistory<AlarmHistoryClass::Major>},
        {"minor", takeHistory<AlarmHistoryClass::Minor>},
        {"userSystem", takeHistory<AlarmHistoryClass::UserSystem>},
        {"user", takeHistory<AlarmHistoryClass::User>},
        {"offline", takeHistory<AlarmHistoryClass::Offline>},
    }};
    take(value, memory, keys);
}

// tables by number

void takeIo(const StateValue &value, Memory &memory)
{
    for (const auto &[key, bits] : value.entries()) {
        const auto group = numberKey(key, bits);
        if (group && !memory.dialect.ioArea(*group))
            bits.complain(QStringLiteral("is not an I/O group of this model"));
        memory.io[group.value_or(1)] = quint8(bits.number(0, 255));
    }
}

void takeRegisters(const StateValue &value, Memory &memory)
{
    for (const auto &[key, word] : value.entries()) {
        const auto number = numberKey(key, word);
        if (number && *number >= memory.registers.size())
            word.complain(QStringLiteral("is not a register"));
        else
            memory.registers[number.value_or(0)] = {quint16(word.number(0, 0xFFFF))};
    }
}

struct VariableCounts {
    int variables;
    int positions;
};

void takeVariableCounts(const StateValue &value, Memory &memory)
{
    constexpr int most = 10'000;
    static constexpr std::array<Key<VariableCounts>, 2> keys {{
        {"variables", [](const StateValue &v, VariableCounts &c) { c.variables = int(v.number(1, most)); }},
        {"positionVariables", [](const StateValue &v, VariableCounts &c) { c.positions = int(v.number(1, most)); }},
    }};
    VariableCounts counts {memory.dialect.variables, memory.dialect.positionVariables};
    take(value, counts, keys);
    memory.resizeVariables(counts.variables, counts.positions);
}

void takeTimes(const StateValue &value, Memory &memory)
{
    static constexpr std::array<Key<RunningTime>, 2> keys {{
        {"start",
            [](const StateValue &v, RunningTime &time) {
                const QString text = QString::fromLatin1(v.text(16));
                time.start = QDateTime::fromString(text, QStringLiteral("yyyy/MM/dd HH:mm"));
                if (!time.start.isValid())
                    v.complain(QStringLiteral("is not a time like 2026/01/31 08:30"));
            }},
        {"seconds", [](const StateValue &v, RunningTime &time) { time.elapsed = Time {v.number(0, maxWord) * 1000}; }},
    }};
    for (const auto &[key, time] : value.entries())
        take(time, memory.times[numberKey(key, time).value_or(1)], keys);
}

void takeInformation(const StateValue &value, Memory &memory)
{
    using Information = values::SystemInformation;
    static constexpr std::array<Key<Information>, 3> keys {{
        {"software", [](const StateValue &v, Information &i) { i.software = FixedText<24> {v.text(24)}; }},
        {"model", [](const StateValue &v, Information &i) { i.model = FixedText<16> {v.text(16)}; }},
        {"parameters", [](const StateValue &v, Information &i) { i.parameters = FixedText<8> {v.text(8)}; }},
    }};
    for (const auto &[key, information] : value.entries())
        take(information, memory.systemInformation[numberKey(key, information).value_or(11)], keys);
}

void takeEncoders(const StateValue &value, Memory &memory)
{
    for (const auto &[key, celsius] : value.entries()) {
        const auto words = axisWords(celsius);
        auto &temperatures = memory.encoderTemperatures[numberKey(key, celsius).value_or(1)];
        std::copy(words.begin(), words.end(), temperatures.celsius.begin());
    }
}

void takeConverters(const StateValue &value, Memory &memory)
{
    for (const auto &[key, celsius] : value.entries())
        memory.converterTemperatures[numberKey(key, celsius).value_or(1)] = {{qint32(celsius.number(-273, 1000))}};
}

/// In the order in which they may rely on each other: the job comes last.
constexpr std::array<Key<Memory>, 15> sections {{
    {"status", takeStatus},
    {"interlocks", takeInterlocks},
    {"files", takeFiles},
    {"positions", takePositions},
    {"alarms", takeAlarms},
    {"histories", takeHistories},
    {"io", takeIo},
    {"registers", takeRegisters},
    {"variableCounts", takeVariableCounts},
    {"variables", takeVariables},
    {"times", takeTimes},
    {"systemInformation", takeInformation},
    {"encoderTemperatures", takeEncoders},
    {"converterTemperatures", takeConverters},
    {"job", takeJob},
}};

} // namespace

values::Result<void> applyState(const QByteArray &json, Memory &memory)
{
    QJsonParseError fault;
    const QJsonDocument document = QJsonDocument::fromJson(json, &fault);
    if (!document.isObject())
        return values::badInput(QStringLiteral("The state is not a JSON object: %1.").arg(fault.errorString()));
    QString complaint;
    Memory changed = memory;
    take(StateValue {document.object(), {}, complaint}, changed, sections);
    if (!complaint.isEmpty())
        return values::badInput(complaint);
    memory = std::move(changed);
    return {};
}

} // namespace virtualcontroller
