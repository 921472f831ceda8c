// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "variables/text.h"

#include "variables/sentences.h"
#include <limits>

using values::AxisUnit;
using values::ErrorKind;
using values::failure;
using values::PositionType;
using values::Result;

namespace variables {

namespace {

/// The range of a kind that holds a whole number; everything that needs it asks here.
template <typename Integer> using LimitsOf = std::numeric_limits<decltype(Integer::value)>;

template <typename Integer> Result<Value> integer(QStringView typed)
{
    return wholeNumber(typed, LimitsOf<Integer>::min(), LimitsOf<Integer>::max()).map([](qint64 number) -> Value {
        return Integer {decltype(Integer::value)(number)};
    });
}

QString fromTo(const QString &least, const QString &most) { return least + QStringLiteral(" … ") + most; }

template <typename Integer> QString limitsText()
{
    return fromTo(QString::number(LimitsOf<Integer>::min()), QString::number(LimitsOf<Integer>::max()));
}

QString registerLimits(Base base)
{
    constexpr quint16 leastSigned = 0x8000;
    const bool isSigned = base == Base::Signed;
    return fromTo(
        toText(quint16(isSigned ? leastSigned : 0), base), toText(quint16(isSigned ? leastSigned - 1 : 0xFFFF), base));
}

Result<Value> string(QStringView typed, const Format &format)
{
    const auto bytes = format.codec.encode(typed);
    if (!bytes)
        return values::badInput(Sentences::tr("The text cannot be sent: %1.").arg(bytes.error().detail));
    if (bytes->contains('\0'))
        return values::badInput(Sentences::tr("The text must not hold the character NUL, which ends it."));
    if (bytes->size() > format.stringSize)
        return values::badInput(
            Sentences::tr("The text takes %1 bytes; there is room for %2.").arg(bytes->size()).arg(format.stringSize));
    return values::StringVariable32 {values::FixedText<32> {*bytes}};
}

QString positionText(const Value &value, const Format &format)
{
    const values::Position position = *positionOf(value);
    QStringList parts {values::toString(position.type)};
    int last = position.axes.count();
    while (last > usualAxes(kindOf(value)) && position.axes[last - 1] == 0)
        --last;
    for (int axis = 0; axis < last; ++axis) {
        const QString number = axisText(position.axes[axis], axisUnit(position.type, axis), format.locale);
        parts << axisName(kindOf(value), position.type, axis) + u' ' + number;
    }
    return parts.join(QStringLiteral("  "));
}

} // namespace

QString toText(const Value &value, const Format &format)
{
    switch (kindOf(value)) {
    case Kind::B: return QString::number(std::get<values::ByteVariable>(value).value);
    case Kind::I: return QString::number(std::get<values::IntegerVariable>(value).value);
    case Kind::D: return QString::number(std::get<values::DoubleVariable>(value).value);
    case Kind::R: return toText(std::get<values::RealVariable>(value).value, format.locale);
    case Kind::S: return format.codec.decode(std::get<values::StringVariable32>(value).value.bytes());
    case Kind::M: return toText(std::get<values::Register>(value).value, format.registerBase);
    case Kind::P:
    case Kind::BP:
    case Kind::EX: return positionText(value, format);
    }
    return {};
}

Result<Value> fromText(Kind kind, QStringView typed, const Format &format)
{
    switch (kind) {
    case Kind::B: return integer<values::ByteVariable>(typed);
    case Kind::I: return integer<values::IntegerVariable>(typed);
    case Kind::D: return integer<values::DoubleVariable>(typed);
    case Kind::R: return real(typed).map([](float number) -> Value { return values::RealVariable {number}; });
    case Kind::S: return string(typed, format);
    case Kind::M:
        return bits16(typed, format.registerBase).map([](quint16 bits) -> Value { return values::Register {bits}; });
    case Kind::P:
    case Kind::BP:
    case Kind::EX: break;
    }
    return values::badInput(Sentences::tr("A position is not written as one text."));
}

QString rangeText(Kind kind, const Format &format)
{
    switch (kind) {
    case Kind::B: return limitsText<values::ByteVariable>();
    case Kind::I: return limitsText<values::IntegerVariable>();
    case Kind::D: return limitsText<values::DoubleVariable>();
    case Kind::R: return Sentences::tr("a real number");
    case Kind::S: return Sentences::tr("up to %n byte(s)", nullptr, format.stringSize);
    case Kind::M: return registerLimits(format.registerBase);
    case Kind::P:
    case Kind::BP:
    case Kind::EX: break;
    }
    return {};
}

QString unitText(AxisUnit unit)
{
    switch (unit) {
    case AxisUnit::Pulse: return Sentences::tr("pulse");
    case AxisUnit::Micrometre: return QStringLiteral("mm");
    case AxisUnit::TenThousandthDegree: return QStringLiteral("°");
    }
    return {};
}

QString axisText(qint32 word, AxisUnit unit, const QLocale &locale) { return toText(word, decimalsOf(unit), locale); }

Result<qint32> axisFromText(QStringView typed, AxisUnit unit) { return fixedPoint(typed, decimalsOf(unit)); }

QString axisName(Kind kind, PositionType type, int axis)
{
    static const QStringList pulse {QStringLiteral("S"), QStringLiteral("L"), QStringLiteral("U"), QStringLiteral("R"),
        QStringLiteral("B"), QStringLiteral("T"), QStringLiteral("E")};
    static const QStringList cartesian {QStringLiteral("X"), QStringLiteral("Y"), QStringLiteral("Z"),
        QStringLiteral("Rx"), QStringLiteral("Ry"), QStringLiteral("Rz"), QStringLiteral("Re")};
    const QString number = QString::number(axis + 1);
    if (type != PositionType::Pulse)
        return cartesian.value(axis, number);
    return kind == Kind::P ? pulse.value(axis, number) : number;
}

} // namespace variables
