// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "protocol/catalog.h"
#include "protocol/payloads.h"
#include "protocol/plural.h"

#include <QJsonObject>
#include <QtEndian>

using values::Result;

namespace protocol {

namespace {

using Ranges = QList<InstanceRange>;

InstanceRange numbered(int base, int count) { return {quint16(base + 1), quint16(base + count)}; }
InstanceRange variables(int count, Numbering numbering)
{
    return {variableInstance(0, numbering), variableInstance(count - 1, numbering)};
}
Ranges onlyIf(bool has, const Ranges &ranges) { return has ? ranges : Ranges {}; }

// The instances, reference §2.1 and the section of each command.
Ranges onlyFirst(const Dialect &) { return {{1, 1}}; }
Ranges firstTwo(const Dialect &) { return {{1, 2}}; }
Ranges firstThree(const Dialect &) { return {{1, 3}}; }
Ranges cycleInstance(const Dialect &) { return {{2, 2}}; }
Ranges alarmSlots(const Dialect &) { return {{1, values::activeAlarmCount}}; }
Ranges alarmTextSlots(const Dialect &d) { return onlyIf(d.hasAlarmTexts, alarmSlots(d)); }
Ranges historyEntries(const Dialect &)
{
    Ranges ranges;
    for (const auto list : values::allAlarmHistoryClasses)
        ranges += numbered(int(list), values::alarmHistoryLength);
    return ranges;
}
Ranges historyTextEntries(const Dialect &d) { return onlyIf(d.hasAlarmTexts, historyEntries(d)); }
Ranges tasks(const Dialect &d) { return {numbered(0, d.tasks)}; }
Ranges pulseGroups(const Dialect &d)
{
    return {numbered(0, d.robots), numbered(10, d.bases), numbered(20, d.stations)};
}
Ranges positionGroups(const Dialect &d) { return pulseGroups(d) + Ranges {numbered(100, d.robots)}; }
Ranges axisNameGroups(const Dialect &d) { return positionGroups(d) + Ranges {numbered(110, d.bases)}; }
Ranges encoderGroups(const Dialect &d) { return onlyIf(d.hasTemperatures, pulseGroups(d)); }
Ranges servoBoards(const Dialect &d) { return onlyIf(d.hasTemperatures, {{1, 2}}); }
Ranges timeCounters(const Dialect &d)
{
    Ranges ranges {{1, 1}};
    for (const quint16 base : {quint16(10), quint16(110), quint16(210)})
        ranges += {InstanceRange {base, base}, numbered(base, d.robots), numbered(base + 10, d.stations)};
    return ranges + Ranges {numbered(300, d.applications)};
}
Ranges systemParts(const Dialect &d)
{
    return {numbered(10, d.robots), numbered(20, d.stations), numbered(100, d.applications)};
}
Ranges ioGroups(const Dialect &d)
{
    Ranges ranges;
    for (const IoRange &range : d.io)
        ranges += range.groups;
    return ranges;
}
Ranges networkInputs(const Dialect &d) { return {d.ioRange(IoArea::NetworkInput)}; }
Ranges allRegisters(const Dialect &) { return {registers}; }
Ranges openRegisters(const Dialect &) { return {writableRegisters}; }
Ranges plainVariables(const Dialect &d) { return {variables(d.variables, d.numbering)}; }
Ranges longStrings(const Dialect &d) { return onlyIf(d.stringSize == 32, plainVariables(d)); }
Ranges positionVariables(const Dialect &d) { return {variables(d.positionVariables, d.numbering)}; }
Ranges jobTargets(const Dialect &d) { return {{1, 1}, {10, d.lastMasterJob}}; }
Ranges cartesianMoves(const Dialect &d) { return onlyIf(d.hasMoves, {{1, 3}}); }
Ranges pulseMoves(const Dialect &d) { return onlyIf(d.hasMoves, {{1, 2}}); }

// The effects.
Effect reads(const Request &) { return Effect::Reads; }
Effect writes(const Request &) { return Effect::Writes; }
Effect starts(const Request &) { return Effect::Starts; }
Effect moves(const Request &) { return Effect::Moves; }
Effect readsOrWrites(const Request &request)
{
    return requestPayload(request.service) == PayloadKind::Empty || request.service == Service::ReadPlural
        ? Effect::Reads
        : Effect::Writes;
}

/// 0x83: HOLD on and servo off stop, the rest of servo makes motion possible, and what remains changes a setting
/// (reference §6). A servo order that is not clearly "off" counts as "on".
Effect powerSwitchEffect(const Request &request)
{
    constexpr quint16 hold = 1;
    constexpr quint16 servo = 2;
    constexpr quint32 on = 1;
    constexpr quint32 off = 2;
    const quint32 word = request.payload.size() >= 4 ? qFromLittleEndian<quint32>(request.payload.data()) : 0;
    if (request.instance == hold)
        return word == on ? Effect::Stops : Effect::Writes;
    if (request.instance == servo)
        return word == off ? Effect::Stops : Effect::Starts;
    return Effect::Writes;
}

/// What a request says about the value that answers it: a single axis has its name by the group.
void prepare(auto &, const Request &) { }
void prepare(values::Position &position, const Request &request)
{
    if (values::ControlGroup {request.instance}.isCartesian())
        position.type = values::PositionType::Base;
}

Result<Fields> finished(const FieldReader &reader, QByteArrayView payload)
{
    if (reader.isComplete())
        return reader.fields();
    return values::failure(
        values::ErrorKind::Malformed, QStringLiteral("a payload of %1 bytes does not fit").arg(payload.size()));
}

bool isSingle(Service service) { return service == Service::GetSingle || service == Service::SetSingle; }

template <typename Value>
Result<Fields> valueFields(QByteArrayView payload, const Request &request, const TextCodec &codec)
{
    Value value;
    prepare(value, request);
    FieldReader reader {payload, isSingle(request.service) ? request.attribute : 0, codec};
    Layout<Value>::describe(reader, value);
    return finished(reader, payload);
}

/// One item of a list: its value if it has a single field, else all of them by name.
QJsonValue itemOf(const Fields &fields)
{
    if (fields.size() == 1)
        return fields.first().value;
    QJsonObject object;
    for (const Field &field : fields)
        object.insert(field.name, field.value);
    return object;
}

template <typename Item> Result<Fields> itemFields(QByteArrayView payload, const Request &, const TextCodec &codec)
{
    const qsizetype size = measure<Item>().bytes;
    QJsonArray values;
    for (; !payload.isEmpty(); payload = payload.sliced(size)) {
        Item item;
        FieldReader reader {payload.first(std::min(size, payload.size())), 0, codec};
        Layout<Item>::describe(reader, item);
        auto fields = finished(reader, payload);
        if (!fields)
            return fields;
        values += itemOf(*fields);
    }
    return Fields {{QStringLiteral("values"), values, {}}};
}

const QList<Service> get {Service::GetSingle, Service::GetAll};
const QList<Service> getAndSet {Service::GetSingle, Service::GetAll, Service::SetSingle, Service::SetAll};
const QList<Service> execute {Service::SetSingle};
const QList<Service> setAll {Service::SetAll};
const QList<Service> plural {Service::ReadPlural, Service::WritePlural};

using RangesOf = Ranges (*)(const Dialect &);
using EffectOf = Effect (*)(const Request &);

template <typename Value>
Command row(quint16 number, const char *name, const QList<Service> &services, RangesOf instances, EffectOf effect,
    AllAttribute attribute = AllAttribute::Zero, RangesOf writable = nullptr)
{
    const Measure measured = measure<Value>();
    return {number, name, services, measured.elements, measured.bytes, instances, effect, valueFields<Value>, attribute,
        writable};
}

template <typename Item>
Command pluralRow(quint16 number, const char *name, RangesOf instances, RangesOf writable = nullptr)
{
    return {number, name, plural, 0, measure<Item>().bytes, instances, readsOrWrites, itemFields<Item>,
        AllAttribute::Zero, writable};
}

std::vector<Command> makeRows()
{
    using namespace values;
    using enum AllAttribute;
    const QList<Service> getSetSingle {Service::GetSingle, Service::SetSingle};
    return {
        row<Alarm>(0x70, "active alarm", get, alarmSlots, reads),
        row<Alarm>(0x71, "alarm history", get, historyEntries, reads),
        row<Status>(0x72, "status", get, onlyFirst, reads),
        row<ExecutingJob>(0x73, "executing job", get, tasks, reads),
        row<AxisNames>(0x74, "axis names", get, axisNameGroups, reads),
        row<Position>(0x75, "position", get, positionGroups, reads),
        row<FollowingError>(0x76, "following error", get, pulseGroups, reads),
        row<Torque>(0x77, "torque", get, pulseGroups, reads),
        row<IoGroup>(0x78, "i/o group", getSetSingle, ioGroups, readsOrWrites, Zero, networkInputs),
        row<Register>(0x79, "register", getSetSingle, allRegisters, readsOrWrites, Zero, openRegisters),
        row<ByteVariable>(0x7A, "b variable", getAndSet, plainVariables, readsOrWrites, ZeroOrOne),
        row<IntegerVariable>(0x7B, "i variable", getAndSet, plainVariables, readsOrWrites, ZeroOrOne),
        row<DoubleVariable>(0x7C, "d variable", getAndSet, plainVariables, readsOrWrites, ZeroOrOne),
        row<RealVariable>(0x7D, "r variable", getAndSet, plainVariables, readsOrWrites, ZeroOrOne),
        row<StringVariable16>(0x7E, "s variable, 16 bytes", getAndSet, plainVariables, readsOrWrites, ZeroOrOne),
        row<PositionVariable>(0x7F, "p variable", getAndSet, positionVariables, readsOrWrites),
        row<BasePosition>(0x80, "bp variable", getAndSet, positionVariables, readsOrWrites),
        row<ExternalPosition>(0x81, "ex variable", getAndSet, positionVariables, readsOrWrites),
        row<ControlWord>(0x82, "reset alarm, cancel error", execute, firstTwo, writes),
        row<ControlWord>(0x83, "hold, servo, hlock", execute, firstThree, powerSwitchEffect),
        row<CycleSelection>(0x84, "cycle mode", execute, cycleInstance, writes),
        row<PendantText>(0x85, "pendant message", execute, onlyFirst, writes),
        row<ControlWord>(0x86, "start job", execute, onlyFirst, starts),
        row<JobSelection>(0x87, "select job", setAll, jobTargets, writes),
        row<ManagementTime>(0x88, "management time", get, timeCounters, reads),
        row<SystemInformation>(0x89, "system information", get, systemParts, reads),
        row<CartesianTarget>(0x8A, "move cartesian", setAll, cartesianMoves, moves, One),
        row<PulseTarget>(0x8B, "move pulse", setAll, pulseMoves, moves, One),
        row<StringVariable32>(0x8C, "s variable, 32 bytes", getAndSet, longStrings, readsOrWrites, ZeroOrOne),
        pluralRow<IoGroup>(0x300, "i/o groups", ioGroups, networkInputs),
        pluralRow<Register>(0x301, "registers", allRegisters, openRegisters),
        pluralRow<ByteVariable>(0x302, "b variables", plainVariables),
        pluralRow<IntegerVariable>(0x303, "i variables", plainVariables),
        pluralRow<DoubleVariable>(0x304, "d variables", plainVariables),
        pluralRow<RealVariable>(0x305, "r variables", plainVariables),
        pluralRow<StringVariable16>(0x306, "s variables, 16 bytes", plainVariables),
        pluralRow<PositionVariable>(0x307, "p variables", positionVariables),
        pluralRow<BasePosition>(0x308, "bp variables", positionVariables),
        pluralRow<ExternalPosition>(0x309, "ex variables", positionVariables),
        row<AlarmWithTexts>(0x30A, "active alarm with texts", get, alarmTextSlots, reads),
        row<AlarmWithTexts>(0x30B, "alarm history with texts", get, historyTextEntries, reads),
        pluralRow<StringVariable32>(0x30C, "s variables, 32 bytes", longStrings),
        row<EncoderTemperatures>(0x411, "encoder temperature", get, encoderGroups, reads, One),
        row<ConverterTemperature>(0x413, "converter temperature", get, servoBoards, reads, One),
    };
}

} // namespace

std::span<const Command> commands()
{
    static const std::vector<Command> rows = makeRows();
    return rows;
}

} // namespace protocol
