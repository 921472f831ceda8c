// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "trend/signal.h"

#include <QCoreApplication>
#include <algorithm>

namespace trend {

using robot::Kind;

namespace {

struct KindRow {
    Kind kind;
    const char *key; ///< In keys; never changes, because settings and files hold it.
    int elements;
};

constexpr KindRow kinds[] {
    {Kind::Status, "status", 16},
    {Kind::Job, "job", 3},
    {Kind::Position, "position", values::maxAxes},
    {Kind::AxisNames, "names", 0},
    {Kind::FollowingError, "error", values::maxAxes},
    {Kind::Torque, "torque", values::maxAxes},
    {Kind::EncoderTemperatures, "encoder", values::maxAxes},
    {Kind::ConverterTemperature, "converter", 1},
    {Kind::SystemInformation, "system", 0},
    {Kind::ManagementTime, "time", 1},
    {Kind::Alarm, "alarm", 1},
    {Kind::IoGroup, "io", 8},
    {Kind::Register, "m", 1},
    {Kind::ByteVariable, "b", 1},
    {Kind::IntegerVariable, "i", 1},
    {Kind::DoubleVariable, "d", 1},
    {Kind::RealVariable, "r", 1},
    {Kind::StringVariable, "s", 0},
    {Kind::PositionVariable, "p", values::maxAxes},
    {Kind::BasePosition, "bp", values::maxAxes},
    {Kind::ExternalPosition, "ex", values::maxAxes},
};

constexpr bool isInOrder()
{
    for (std::size_t i = 0; i < std::size(kinds); ++i) {
        if (kinds[i].kind != Kind(i))
            return false;
    }
    return true;
}
static_assert(isInOrder() && std::size(kinds) == std::size_t(robot::kindCount));

const KindRow &row(Kind kind) { return kinds[std::size_t(kind)]; }

/// The bits of reference §3.4, data 1 then data 2; nullptr where a bit has no meaning.
constexpr const char *statusBits[] {
    QT_TRANSLATE_NOOP("trend", "Step mode"),
    QT_TRANSLATE_NOOP("trend", "One cycle"),
    QT_TRANSLATE_NOOP("trend", "Continuous"),
    QT_TRANSLATE_NOOP("trend", "Running"),
    QT_TRANSLATE_NOOP("trend", "Speed limit"),
    QT_TRANSLATE_NOOP("trend", "TEACH"),
    QT_TRANSLATE_NOOP("trend", "PLAY"),
    QT_TRANSLATE_NOOP("trend", "REMOTE"),
    nullptr,
    QT_TRANSLATE_NOOP("trend", "Held by the pendant"),
    QT_TRANSLATE_NOOP("trend", "Held externally"),
    QT_TRANSLATE_NOOP("trend", "Held by command"),
    QT_TRANSLATE_NOOP("trend", "Alarm active"),
    QT_TRANSLATE_NOOP("trend", "Error active"),
    QT_TRANSLATE_NOOP("trend", "Servo on"),
    nullptr,
};

/// Of a text that QT_TRANSLATE_NOOP marks.
QString translated(const char *text) { return QCoreApplication::translate("trend", text); }

Unit unitOf(values::PositionType type, int axis)
{
    switch (values::axisUnit(type, axis)) {
    case values::AxisUnit::Micrometre: return Unit::Millimetre;
    case values::AxisUnit::TenThousandthDegree: return Unit::Degree;
    case values::AxisUnit::Pulse: break;
    }
    return Unit::Pulse;
}

double scaled(qint32 word, Unit unit)
{
    switch (unit) {
    case Unit::Millimetre: return word / 1e3;
    case Unit::Degree: return word / 1e4;
    default: return word;
    }
}

std::optional<Quantity> axisQuantity(const values::AxisWords &axes, values::PositionType type, int axis)
{
    if (axis < 0 || axis >= axes.count())
        return std::nullopt;
    const Unit unit = unitOf(type, axis);
    return Quantity {scaled(axes[axis], unit), unit};
}

std::optional<Quantity> only(int element, double value, Unit unit = Unit::Plain)
{
    return element == 0 ? std::optional(Quantity {value, unit}) : std::nullopt;
}

std::optional<Quantity> bit(quint32 word, int index, int count)
{
    if (index < 0 || index >= count)
        return std::nullopt;
    return Quantity {double(word >> index & 1), Unit::Bit};
}

QString jobLabel(int task, int element)
{
    const char *const words[] {QT_TRANSLATE_NOOP("trend", "Job line"), QT_TRANSLATE_NOOP("trend", "Job step"),
        QT_TRANSLATE_NOOP("trend", "Speed override")};
    const QString word = translated(words[std::clamp(element, 0, 2)]);
    return task == 0 ? word : QCoreApplication::translate("trend", "%1, sub task %2").arg(word).arg(task);
}

QString axisLabel(const Signal &signal, const QString &axis)
{
    const values::ControlGroup group {signal.topic.number};
    const char *pattern = QT_TRANSLATE_NOOP("trend", "%1 %2");
    switch (signal.topic.kind) {
    case Kind::FollowingError: pattern = QT_TRANSLATE_NOOP("trend", "%1 %2 following error"); break;
    case Kind::Torque: pattern = QT_TRANSLATE_NOOP("trend", "%1 %2 torque"); break;
    case Kind::EncoderTemperatures: pattern = QT_TRANSLATE_NOOP("trend", "%1 %2 encoder temperature"); break;
    default: break;
    }
    return translated(pattern).arg(values::toString(group), axis);
}

/// "B005", "P012 X".
QString variableLabel(const Signal &signal, const QString &axis)
{
    const QString name = QString::fromLatin1(row(signal.topic.kind).key).toUpper()
        + QStringLiteral("%1").arg(signal.topic.number, 3, 10, QLatin1Char('0'));
    return row(signal.topic.kind).elements > 1 ? name + u' ' + axis : name;
}

} // namespace

QString toString(Unit unit)
{
    switch (unit) {
    case Unit::Plain:
    case Unit::Bit: return {};
    case Unit::Pulse: return QCoreApplication::translate("trend", "pulses");
    case Unit::Millimetre: return QCoreApplication::translate("trend", "mm");
    case Unit::Degree: return QCoreApplication::translate("trend", "°");
    case Unit::Percent: return QCoreApplication::translate("trend", "%");
    case Unit::Celsius: return QCoreApplication::translate("trend", "°C");
    case Unit::Hour: return QCoreApplication::translate("trend", "h");
    }
    return {};
}

int elementCount(Kind kind) { return row(kind).elements; }

bool isUsed(const Signal &signal)
{
    return signal.element < elementCount(signal.topic.kind)
        && (signal.topic.kind != Kind::Status || statusBits[signal.element]);
}

std::optional<Quantity> quantity(const values::Status &status, int index)
{
    return index < 8 ? bit(quint32(status.data1.toInt()), index, 8) : bit(quint32(status.data2.toInt()), index - 8, 8);
}

std::optional<Quantity> quantity(const values::ExecutingJob &job, int element)
{
    switch (element) {
    case 0: return Quantity {double(job.line)};
    case 1: return Quantity {double(job.step)};
    case 2: return Quantity {job.speedOverride / 100.0, Unit::Percent};
    default: return std::nullopt;
    }
}

std::optional<Quantity> quantity(const values::Position &position, int axis)
{
    return axisQuantity(position.axes, position.type, axis);
}

std::optional<Quantity> quantity(const values::FollowingError &error, int axis)
{
    return axisQuantity(error.axes, values::PositionType::Pulse, axis);
}

std::optional<Quantity> quantity(const values::Torque &torque, int axis)
{
    if (axis < 0 || axis >= torque.axes.count())
        return std::nullopt;
    return Quantity {double(torque.axes[axis])};
}

std::optional<Quantity> quantity(const values::EncoderTemperatures &temperatures, int axis)
{
    if (axis < 0 || axis >= int(temperatures.celsius.size()))
        return std::nullopt;
    return Quantity {double(temperatures.celsius[std::size_t(axis)]), Unit::Celsius};
}

std::optional<Quantity> quantity(const values::ConverterTemperature &temperature, int element)
{
    return only(element, temperature.celsius(), Unit::Celsius);
}

std::optional<Quantity> quantity(const values::ManagementTime &time, int element)
{
    const auto duration = time.duration();
    return duration ? only(element, double(duration->count()) / 3600, Unit::Hour) : std::nullopt;
}

std::optional<Quantity> quantity(const values::AlarmWithTexts &alarm, int element)
{
    return only(element, alarm.alarm.code);
}

std::optional<Quantity> quantity(const values::IoGroup &group, int index) { return bit(group.bits, index, 8); }
std::optional<Quantity> quantity(const values::Register &value, int element) { return only(element, value.value); }
std::optional<Quantity> quantity(const values::ByteVariable &value, int element) { return only(element, value.value); }

std::optional<Quantity> quantity(const values::IntegerVariable &value, int element)
{
    return only(element, value.value);
}

std::optional<Quantity> quantity(const values::DoubleVariable &value, int element)
{
    return only(element, value.value);
}

std::optional<Quantity> quantity(const values::RealVariable &value, int element)
{
    return only(element, double(value.value));
}

std::optional<Quantity> quantity(const values::PositionVariable &value, int axis)
{
    return quantity(value.position, axis);
}

std::optional<Quantity> quantity(const values::BasePosition &value, int axis)
{
    return axisQuantity(value.axes, value.type, axis);
}

std::optional<Quantity> quantity(const values::ExternalPosition &value, int axis)
{
    return axisQuantity(value.axes, value.type, axis);
}

QString label(const Signal &signal, const QString &axisName)
{
    const QString axis = axisName.isEmpty() ? QString::number(signal.element + 1) : axisName;
    switch (signal.topic.kind) {
    case Kind::Status: return isUsed(signal) ? translated(statusBits[signal.element]) : QString {};
    case Kind::Job: return jobLabel(signal.topic.number, signal.element);
    case Kind::Position:
    case Kind::FollowingError:
    case Kind::Torque:
    case Kind::EncoderTemperatures: return axisLabel(signal, axis);
    case Kind::ConverterTemperature:
        return QCoreApplication::translate("trend", "Converter temperature, board %1").arg(signal.topic.number);
    case Kind::ManagementTime: return QCoreApplication::translate("trend", "Running time %1").arg(signal.topic.number);
    case Kind::Alarm: return QCoreApplication::translate("trend", "Alarm code %1").arg(signal.topic.number);
    case Kind::IoGroup:
        return QStringLiteral("#%1%2").arg(signal.topic.number, 4, 10, QLatin1Char('0')).arg(signal.element);
    case Kind::AxisNames:
    case Kind::SystemInformation:
    case Kind::StringVariable: return {};
    case Kind::Register:
    case Kind::ByteVariable:
    case Kind::IntegerVariable:
    case Kind::DoubleVariable:
    case Kind::RealVariable:
    case Kind::PositionVariable:
    case Kind::BasePosition:
    case Kind::ExternalPosition: break;
    }
    return variableLabel(signal, axis);
}

std::optional<robot::Topic> namesOf(const Signal &signal)
{
    switch (signal.topic.kind) {
    case Kind::Position:
    case Kind::FollowingError:
    case Kind::Torque:
    case Kind::EncoderTemperatures: return robot::Topic {Kind::AxisNames, signal.topic.number};
    default: return std::nullopt;
    }
}

QString key(const Signal &signal)
{
    return QStringLiteral("%1.%2.%3")
        .arg(QLatin1String(row(signal.topic.kind).key))
        .arg(signal.topic.number)
        .arg(signal.element);
}

std::optional<Signal> fromKey(QStringView text)
{
    const auto parts = text.split(u'.');
    if (parts.size() != 3)
        return std::nullopt;
    const auto found =
        std::ranges::find_if(kinds, [&](const KindRow &row) { return parts[0] == QLatin1String(row.key); });
    if (found == std::end(kinds))
        return std::nullopt;
    bool hasNumber = false;
    bool hasElement = false;
    const Signal signal {{found->kind, parts[1].toUShort(&hasNumber)}, parts[2].toUShort(&hasElement)};
    if (!hasNumber || !hasElement || !isUsed(signal) || key(signal) != text)
        return std::nullopt;
    return signal;
}

QByteArray toMime(const QList<Signal> &list)
{
    QByteArray data;
    for (const Signal &signal : list)
        data += key(signal).toLatin1() + '\n';
    return data;
}

QList<Signal> fromMime(const QByteArray &data)
{
    QList<Signal> result;
    for (const QByteArray &line : data.split('\n')) {
        if (const auto signal = fromKey(QString::fromLatin1(line)))
            result << *signal;
    }
    return result;
}

} // namespace trend
