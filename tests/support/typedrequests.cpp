// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "support/typedrequests.h"

#include "protocol/codes.h"
#include "protocol/fileblocks.h"

using namespace protocol;
using namespace values;

namespace typed {

namespace {

template <typename R> QString troubleOf(const R &request, QByteArrayView payload, const auto &isExpected)
{
    const auto reply = request.decode(payload);
    if (!reply)
        return explain(reply.error());
    return isExpected(reply) ? QString {} : QStringLiteral("another value");
}

/// A request that is answered with a value.
template <TypedRequest R> Row reads(const char *title, const R &request, const typename R::Reply &value)
{
    const Request bytes = request.request();
    const auto check = [=](QByteArrayView payload) {
        return troubleOf(request, payload, [&value](const auto &reply) { return *reply == value; });
    };
    return {title, bytes, R::effect, check, encode(value, bytes.service == Service::GetSingle ? bytes.attribute : 0)};
}

/// A request that is answered with several items.
template <TypedRequest R> Row readsMany(const char *title, const Result<R> &request, const typename R::Reply &items)
{
    const auto check = [=](QByteArrayView payload) {
        return troubleOf(*request, payload, [&items](const auto &reply) { return *reply == items; });
    };
    return {title, request->request(), R::effect, check, encodePlural(quint32(items.size()), items)};
}

/// A request that is answered with nothing, or with `reply`.
template <TypedRequest R> Row writes(const char *title, const R &request, const QByteArray &reply = {})
{
    const auto check = [=](QByteArrayView payload) {
        return troubleOf(request, payload, [](const auto &) { return true; });
    };
    return {title, request.request(), R::effect, check, reply};
}

template <TypedRequest R> Row writesMany(const char *title, const Result<R> &request, quint32 count)
{
    return writes(title, *request, encodePlural<ByteVariable>(count));
}

template <qsizetype Size> void set(FixedText<Size> &field, const char *text) { field = FixedText<Size> {text}; }

Alarm trackingError()
{
    Alarm alarm {4328, {5, AlarmDataType::AxesSlurbt}, {}, {}};
    set(alarm.time, "2024/11/30 23:59");
    set(alarm.name, "SERVO TRACKING ERROR");
    return alarm;
}

AlarmWithTexts trackingErrorWithTexts()
{
    AlarmWithTexts alarm {trackingError(), {}, {}, {}};
    set(alarm.extra, "[SV#1]");
    set(alarm.subText, "SLURBT");
    alarm.reversed[1] = 1;
    return alarm;
}

QList<Row> alarmRows()
{
    Alarm timeAlone;
    set(timeAlone.time, "2024/11/30 23:59");
    AlarmWithTexts extraAlone;
    set(extraAlone.extra, "[SV#1]");
    return {
        reads("Third active alarm with an axis set", ReadAlarm {3}, trackingError()),
        reads("Alarm slot 4 is empty: zeros, not a refusal", ReadAlarm {4}, {}),
        reads("Time of the second active alarm alone", ReadElement<0x70, Alarm> {2, 4}, timeAlone),
        reads("Newest user alarm of the system", ReadAlarmHistory {AlarmHistoryClass::UserSystem, 1}, trackingError()),
        reads("Code of the hundredth off-line alarm", ReadElement<0x71, Alarm> {4100, 1}, {}),
        reads("Active alarm with texts, 268 bytes", ReadAlarmWithTexts {1}, trackingErrorWithTexts()),
        reads("Active alarm: extra text alone", ReadElement<0x30A, AlarmWithTexts> {1, 6}, extraAlone),
        reads("User alarm of the history with texts, 268 bytes", ReadAlarmHistoryWithTexts {AlarmHistoryClass::User, 1},
            trackingErrorWithTexts()),
        reads("User alarm of the history: extra text alone", ReadElement<0x30B, AlarmWithTexts> {3001, 6}, extraAlone),
    };
}

AxisNames names(std::initializer_list<const char *> texts)
{
    AxisNames axes;
    std::ranges::transform(texts, axes.names.begin(), [](const char *text) { return FixedText<4> {text}; });
    return axes;
}

QList<Row> stateRows()
{
    ExecutingJob job {{}, 12, 5, 7500};
    set(job.name, "DEMO01");
    AxisNames fourth;
    set(fourth.names[3], "Rx");
    return {
        reads("Status of a robot that runs in remote play", ReadStatus {},
            {Status::Data1 {Status::Continuous} | Status::Running | Status::Play | Status::Remote, Status::ServoOn}),
        reads("Data word 2 alone", ReadElement<0x72, Status> {1, 2},
            {{}, Status::Data2 {Status::HeldExternally} | Status::HeldByCommand | Status::ServoOn}),
        reads("Job of the master task", ReadExecutingJob {}, job),
        reads("Line of sub task 1", ReadElement<0x73, ExecutingJob> {2, 2}, {{}, 9999, 0, 0}),
        reads("Axis names of R1 in pulses", ReadAxisNames {ControlGroup::robotPulse(1)},
            names({"S", "L", "U", "R", "B", "T"})),
        reads("Axis names of a base", ReadAxisNames {ControlGroup::baseCartesian(1)}, names({"X", "Y", "Z"})),
        reads("Name of the fourth axis in the base frame", ReadElement<0x74, AxisNames> {101, 4}, fourth),
    };
}

/// Eight axis words of which one is set, as a single-element read leaves them.
AxisWords oneOfEight(int axis, qint32 word)
{
    AxisWords words {0, 0, 0, 0, 0, 0, 0, 0};
    words[axis] = word;
    return words;
}

QList<Row> positionRows()
{
    return {
        reads("Base position of a 6-axis arm", ReadPosition {ControlGroup::robotCartesian(1)},
            {PositionType::Base, 4, 1, 0, 0, {412345, -20000, 650250, 1800000, -53250, 4500}}),
        reads("Pulse position of a 7-axis arm", ReadPosition {ControlGroup::robotPulse(1)},
            {PositionType::Pulse, 0, 0, 0, 0, {1200, -34567, 89, 0, -45000, 77, 1010}}),
        reads("X of the base position alone", ReadElement<0x75, Position> {101, 6},
            {PositionType::Pulse, 0, 0, 0, 0, oneOfEight(0, -412345)}),
        reads("Following error of seven axes", ReadFollowingError {ControlGroup::robotPulse(1)},
            {{3, -2, 0, 1, -1, 0, 0}}),
        reads(
            "Following error of six axes", ReadFollowingError {ControlGroup::stationPulse(1)}, {{1, -1, 2, -2, 3, -3}}),
        reads(
            "Following error of the third axis alone", ReadElement<0x76, FollowingError> {1, 3}, {oneOfEight(2, -12)}),
        reads("Torque of eight axis words", ReadTorque {ControlGroup::robotPulse(1)}, {{1, 2, 3, 4, 5, 6, 7, 8}}),
        reads("Torque of the first axis alone", ReadElement<0x77, Torque> {1, 1},
            {oneOfEight(0, std::numeric_limits<qint32>::min())}),
    };
}

QList<Row> systemRows()
{
    ManagementTime power;
    set(power.start, "2023/04/01 08:00");
    set(power.elapsed, "18:19'02");
    ManagementTime elapsedAlone;
    set(elapsedAlone.elapsed, "3:37'14");
    SystemInformation station;
    set(station.software, "YAS1.00.00A(JP/EN)-00");
    SystemInformation parametersAlone;
    set(parametersAlone.parameters, "4.56");
    return {
        reads("Control power time", ReadManagementTime {ManagementTimeCounter::controlPower()}, power),
        reads("Elapsed motion time of S2 alone",
            ReadElement<0x88, ManagementTime> {
                ManagementTimeCounter::station(ManagementTimeKind::Motion, 2).instance, 2},
            elapsedAlone),
        reads("System information of S1, which has no model", ReadSystemInformation::station(1), station),
        reads("Parameter version of R2 alone",
            ReadElement<0x89, SystemInformation> {ReadSystemInformation::robot(2).instance, 3}, parametersAlone),
        reads("Encoder temperatures of R1", ReadEncoderTemperatures {ControlGroup::robotPulse(1)},
            {{38, 39, 40, 41, 42, 43, 0, 0}}),
        reads("Encoder temperatures by the single service", ReadElement<0x411, EncoderTemperatures> {2, 1},
            {{-5, 0, 0, 0, 0, 0, 0, 0}}),
        reads("Converter temperature", ReadConverterTemperature {2}, {{41, 0, 0, 0, 0, 0}}),
        reads("Converter temperature by the single service", ReadElement<0x413, ConverterTemperature> {1, 1},
            {{40, 0, 0, 0, 0, 0}}),
    };
}

/// The exchanges of a variable with one element, whose titles begin with `name`.
template <typename Variable> QList<Row> scalarRows(std::array<const char *, 6> titles, const Variable &value)
{
    constexpr quint16 command = CommandsOf<Variable>::single;
    return {
        reads(titles[0], ReadItem<Variable> {99}, value),
        reads(titles[1], ReadAll<command, Variable> {99}, value),
        reads(titles[2], ReadAll<command, Variable, 1> {99}, value),
        writes(titles[3], WriteItem<Variable> {0, value}),
        writes(titles[4], WriteAll<command, Variable> {0, value}),
        writes(titles[5], WriteAll<command, Variable, 1> {0, value}),
    };
}

#define SCALAR_TITLES(name)                                                                                            \
    {                                                                                                                  \
        {                                                                                                              \
            name " is read", name " is read whole", name " is read whole with attribute 1", name " is written",        \
                name " is written whole", name " is written whole with attribute 1"                                    \
        }                                                                                                              \
    }

QList<Row> scalarVariableRows()
{
    StringVariable16 short_ {FixedText<16> {"AB C"}};
    StringVariable32 long_ {FixedText<32> {"0123456789ABCDEF0123456789ABCDEF"}};
    return QList<Row> {
               reads("Network input group 2701", ReadItem<IoGroup> {2701}, {0x85}),
               writes("I/O group is written", WriteItem<IoGroup> {2701, {0xA5}}),
               reads("Register M005", ReadItem<Register> {5}, {65000}),
               writes("Register is written", WriteItem<Register> {559, {65535}}),
           }
    + scalarRows<ByteVariable>(SCALAR_TITLES("B"), {255}) + scalarRows<IntegerVariable>(SCALAR_TITLES("I"), {-32768})
        + scalarRows<DoubleVariable>(SCALAR_TITLES("D"), {std::numeric_limits<qint32>::min()})
        + scalarRows<RealVariable>(SCALAR_TITLES("R"), {0.1F}) + scalarRows(SCALAR_TITLES("S of 16 bytes"), short_)
        + scalarRows(SCALAR_TITLES("S of 32 bytes"), long_);
}

PositionVariable userFramePosition()
{
    return {{PositionType::User, 0x85, 5, 7, 0x13, {1000, -2000, 3000, 1800000, -900000, 1, 0, 0}}};
}

template <typename Variable> QList<Row> axesRows(std::array<const char *, 4> titles, PositionType type)
{
    const Variable all {type, {-5, 6, 0, 0, 0, 0, 0, 1}};
    return {
        reads(titles[0], ReadItem<Variable> {127}, all),
        reads(titles[1], ReadItemElement<Variable> {3, 2}, {PositionType::Pulse, oneOfEight(0, -77)}),
        writes(titles[2], WriteItem<Variable> {4, all}),
        writes(titles[3], WriteItemElement<Variable> {4, {PositionType::Pulse, oneOfEight(7, 88)}, 9}),
    };
}

QList<Row> positionVariableRows()
{
    const auto tool = [](quint32 number) {
        return PositionVariable {{PositionType::Pulse, 0, number, 0, 0, {0, 0, 0, 0, 0, 0, 0, 0}}};
    };
    return QList<Row> {
               reads("P127 in a user frame", ReadItem<PositionVariable> {127}, userFramePosition()),
               reads("Tool of P000 alone", ReadItemElement<PositionVariable> {0, 3}, tool(5)),
               writes("P002 is written", WriteItem<PositionVariable> {2, userFramePosition()}),
               writes("Tool of P002 alone is written", WriteItemElement<PositionVariable> {2, tool(6), 3}),
           }
    + axesRows<BasePosition>(
        {"BP127 is read", "First axis of BP003 alone", "BP004 is written", "Last axis of BP004 alone is written"},
        PositionType::Base)
        + axesRows<ExternalPosition>(
            {"EX127 is read", "First axis of EX003 alone", "EX004 is written", "Last axis of EX004 alone is written"},
            PositionType::Pulse);
}

template <typename Item>
QList<Row> pluralRows(const char *readTitle, const char *writeTitle, quint16 first, const QList<Item> &items)
{
    const int count = int(items.size());
    return {
        readsMany(readTitle, ReadItems<Item>::create(first, count), items),
        writesMany(writeTitle, WriteItems<Item>::create(first, items), quint32(count)),
    };
}

QList<Row> pluralVariableRows()
{
    const PositionVariable pulse {{PositionType::Pulse, 0, 1, 0, 0, {9, 8, 7, 6, 5, 4, 3, 2}}};
    const StringVariable16 letters {FixedText<16> {"ABCDEFGHIJKLMNOP"}};
    const StringVariable16 x {FixedText<16> {"X"}};
    const StringVariable32 xs {FixedText<32> {"xxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxx"}};
    const StringVariable32 y {FixedText<32> {"y"}};
    const BasePosition inFrame {PositionType::Base, {1, 2, 3, 0, 0, 0, 0, 0}};
    const BasePosition inPulses {PositionType::Pulse, {-1, 0, 0, 0, 0, 0, 0, 0}};
    constexpr qint32 most = std::numeric_limits<qint32>::max();
    constexpr qint32 least = std::numeric_limits<qint32>::min();
    return pluralRows<IoGroup>("Two I/O groups are read", "Two I/O groups are written", 2702, {{0x81}, {0x7E}})
        + pluralRows<Register>("Three registers are read", "Three registers are written", 100, {{1}, {65535}, {32768}})
        + pluralRows<ByteVariable>(
            "Four B variables are read", "Four B variables are written", 10, {{0}, {127}, {128}, {255}})
        + pluralRows<IntegerVariable>(
            "Three I variables are read", "Three I variables are written", 11, {{-1}, {32767}, {-32768}})
        + pluralRows<DoubleVariable>("Two D variables are read", "Two D variables are written", 12, {{most}, {least}})
        + pluralRows<RealVariable>("Two R variables are read", "Two R variables are written", 13, {{-1}, {10}})
        + pluralRows<StringVariable16>(
            "Two S variables of 16 bytes are read", "Two S variables of 16 bytes are written", 14, {letters, x})
        + pluralRows<PositionVariable>(
            "Two P variables are read", "Two P variables are written", 15, {userFramePosition(), pulse})
        + pluralRows<BasePosition>("Two BP variables are read", "Two BP variables are written", 16, {inFrame, inPulses})
        + pluralRows<ExternalPosition>("One EX variable are read", "One EX variable are written", 17,
            {{PositionType::Pulse, {1, 2, 3, 4, 5, 6, 7, 8}}})
        + pluralRows<StringVariable32>(
            "Two S variables of 32 bytes are read", "Two S variables of 32 bytes are written", 18, {xs, y});
}

QList<Row> controlRows()
{
    const auto text = [](const char *bytes) { return *PendantText::create(bytes); };
    return {
        writes("Alarm reset", ResetAlarm {}),
        writes("Error message is cancelled", CancelError {}),
        writes("HOLD on", HoldOn {}),
        writes("HOLD off", HoldOff {}),
        writes("Servo on", ServoOn {}),
        writes("Servo off", ServoOff {}),
        writes("HLOCK on", HlockOn {}),
        writes("HLOCK off", HlockOff {}),
        writes("Cycle mode step", SelectCycle {CycleMode::Step}),
        writes("Cycle mode one cycle", SelectCycle {CycleMode::OneCycle}),
        writes("Cycle mode continuous", SelectCycle {CycleMode::Continuous}),
        writes("Message on the pendant", ShowPendantText {text("HELLO PENDANT")}),
        writes("Message of 30 characters", ShowPendantText {text("123456789012345678901234567890")}),
        writes("Start", StartJob {}),
        writes("DEMO01 is selected to execute", SelectJob {{JobName {"DEMO01"}, 0}}),
        writes("Master job of sub task 1", SelectJob {{JobName {"SUBMASTER"}, 0}, JobTarget::masterOf(1)}),
        writes("Job name of 32 characters from line 9999",
            SelectJob {{JobName {"ABCDEFGHIJKLMNOPQRSTUVWXYZ012345"}, 9999}}),
    };
}

QList<Row> moveRows()
{
    CartesianTarget base {1, 0, {SpeedClass::Percent, 1000}};
    base.xyz = {500000, -100000, 400000};
    base.rotation = {1800000, 0, -900000, 0};
    base.form = 4;
    base.tool = 1;
    CartesianTarget increment {1, 0, {SpeedClass::ToolPoint, 250}, PositionType::Tool};
    increment.xyz = {0, 0, 10000};
    const CartesianTarget everything {2, 0, {SpeedClass::Rotation, 35}, PositionType::User, {1, -2, 3}, {-4, 5, -6, 7},
        0, 8, 9, 10, 11, {12, -13, 14}, {15, -16, 17, 18, 19, -20}};
    const PulseTarget joint {
        1, 0, {SpeedClass::Percent, 10000}, {1, -2, 3, -4, 5, -6, 7, -8}, 9, {10, -11, 12}, {13, -14, 15, 16, 17, -18}};
    return {
        writes("Joint move to a base position", MoveCartesian {CartesianMove::JointAbsolute, base}),
        writes("Straight increment along the Z of the tool",
            MoveCartesian {CartesianMove::StraightIncremental, increment}),
        writes("Straight move in a user frame, all words set",
            MoveCartesian {CartesianMove::StraightAbsolute, everything}),
        writes("Joint move in pulses, all words set", MovePulse {PulseMove::JointAbsolute, joint}),
        writes("Straight move in pulses",
            MovePulse {PulseMove::StraightAbsolute, PulseTarget {0, 3, {SpeedClass::ToolPoint, 2500}}}),
    };
}

} // namespace

const QList<Row> &rows()
{
    static const QList<Row> all = alarmRows() + stateRows() + positionRows() + systemRows() + scalarVariableRows()
        + positionVariableRows() + pluralVariableRows() + controlRows() + moveRows();
    return all;
}

const QList<FileRow> &fileRows()
{
    const auto name = [](const char *bytes) { return *FileName::create(bytes); };
    static const QList<FileRow> all {
        {"List of jobs in one block", listFiles("*.JBI")},
        {"A job is loaded in two blocks", loadFile(name("DEMO01.JBI"))},
        {"A job is saved in two blocks", saveFile(name("DEMO01.JBI"))},
        {"A job is deleted", deleteFile(name("DEMO01.JBI"))},
        {"The batch backup is not set up", saveFile(FileName::batchBackup())},
    };
    return all;
}

} // namespace typed
