// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "virtualcontroller/statevariables.h"

#include <algorithm>
#include <cstdint>

using values::PositionType;

namespace virtualcontroller {

namespace {

/// The axis words of a position variable: eight of them, of which some were given.
values::AxisWords eightWords(const StateValue &value)
{
    values::AxisWords words = axisWords(value);
    words.resize(values::maxAxes);
    return words;
}

values::Position positionOf(const StateValue &value)
{
    values::Position position;
    position.axes.resize(values::maxAxes);
    for (const auto &[key, part] : value.entries()) {
        if (key == u"axes")
            position.axes = eightWords(part);
        else if (key == u"type")
            position.type = PositionType(part.number(0, 19));
        else if (key == u"form")
            position.form = quint32(part.number(0, 255));
        else if (key == u"extendedForm")
            position.extendedForm = quint32(part.number(0, 255));
        else if (key == u"tool")
            position.tool = quint32(part.number(0, 63));
        else if (key == u"userFrame")
            position.userFrame = quint32(part.number(0, 63));
        else
            part.complain(QStringLiteral("is not a key that is known here"));
    }
    return position;
}

void take(const StateValue &value, values::ByteVariable &variable) { variable = {quint8(value.number(0, 255))}; }
void take(const StateValue &value, values::IntegerVariable &variable)
{
    variable = {qint16(value.number(INT16_MIN, INT16_MAX))};
}
void take(const StateValue &value, values::DoubleVariable &variable)
{
    variable = {qint32(value.number(INT32_MIN, INT32_MAX))};
}
void take(const StateValue &value, values::RealVariable &variable) { variable = {float(value.real())}; }
void take(const StateValue &value, values::StringVariable32 &variable)
{
    variable = {values::FixedText<32> {value.text(32)}};
}
void take(const StateValue &value, std::optional<values::PositionVariable> &variable)
{
    variable.reset();
    if (!value.isNull())
        variable = {positionOf(value)};
}
/// BP and EX have a type and axes.
template <typename Variable> void takeAxes(const StateValue &value, std::optional<Variable> &variable)
{
    variable.reset();
    if (value.isNull())
        return;
    const values::Position position = positionOf(value);
    variable = {position.type, position.axes};
}
void take(const StateValue &value, std::optional<values::BasePosition> &variable) { takeAxes(value, variable); }
void take(const StateValue &value, std::optional<values::ExternalPosition> &variable) { takeAxes(value, variable); }

template <auto list> void takeItem(const StateValue &value, Memory &memory, uint number)
{
    if (number < (memory.*list).size())
        take(value, (memory.*list)[number]);
    else
        value.complain(QStringLiteral("is not a variable of this controller"));
}

} // namespace

values::AxisWords axisWords(const StateValue &value)
{
    values::AxisWords words;
    const auto items = value.items();
    if (items.size() > std::size_t(values::maxAxes))
        value.complain(QStringLiteral("has more than %1 axes").arg(values::maxAxes));
    words.resize(std::min(int(items.size()), values::maxAxes));
    for (int axis = 0; axis < words.count(); ++axis)
        words[axis] = qint32(items[std::size_t(axis)].number(INT32_MIN, INT32_MAX));
    return words;
}

void takeVariables(const StateValue &value, Memory &memory)
{
    using Taker = void (*)(const StateValue &, Memory &, uint);
    static const std::map<QString, Taker> takers {{QStringLiteral("B"), takeItem<&Memory::b>},
        {QStringLiteral("I"), takeItem<&Memory::i>}, {QStringLiteral("D"), takeItem<&Memory::d>},
        {QStringLiteral("R"), takeItem<&Memory::r>}, {QStringLiteral("S"), takeItem<&Memory::s>},
        {QStringLiteral("P"), takeItem<&Memory::p>}, {QStringLiteral("BP"), takeItem<&Memory::bp>},
        {QStringLiteral("EX"), takeItem<&Memory::ex>}};
    for (const auto &[name, variable] : value.entries()) {
        const auto digit = std::ranges::find_if(name, [](QChar c) { return c.isDigit(); });
        const qsizetype letters = digit - name.begin();
        const auto taker = takers.find(name.first(letters));
        bool ok = false;
        const uint number = name.sliced(letters).toUInt(&ok);
        if (ok && taker != takers.end())
            taker->second(variable, memory, number);
        else
            variable.complain(QStringLiteral("is not a variable like B000 or P001"));
    }
}

} // namespace virtualcontroller
