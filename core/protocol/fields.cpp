// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "protocol/fields.h"

#include <array>
#include <cmath>

namespace protocol {

QString hexWord(quint64 number, int digits)
{
    return QStringLiteral("0x") + QString::number(number, 16).toUpper().rightJustified(digits, u'0');
}

Field showNumber(const char *name, qint64 value) { return {QString::fromLatin1(name), value, {}}; }

Field showReal(const char *name, float value)
{
    // The shortest text that means the same single-precision number: 0.1 and not 0.10000000149011612.
    constexpr int enoughDigits = 9;
    QString text;
    for (int digits = 6; digits <= enoughDigits; ++digits) {
        text = QString::number(double(value), 'g', digits);
        if (text.toFloat() == value)
            break;
    }
    const QJsonValue shown = std::isfinite(value) ? QJsonValue {text.toDouble()} : QJsonValue {}; // JSON has no NaN
    return {QString::fromLatin1(name), shown, text};
}

Field showWords(const char *name, const QStringList &words)
{
    return {QString::fromLatin1(name), QJsonArray::fromStringList(words), words.join(QStringLiteral(", "))};
}

Field showAxes(const char *name, const values::AxisWords &words)
{
    QJsonArray list;
    for (const qint32 word : words)
        list += word;
    return {QString::fromLatin1(name), list, {}};
}

QString axisName(values::PositionType type, int axis)
{
    constexpr std::array names {"x", "y", "z", "rx", "ry", "rz", "re"};
    if (type == values::PositionType::Pulse || axis >= int(names.size()))
        return QStringLiteral("axis_%1").arg(axis + 1);
    return QString::fromLatin1(names[std::size_t(axis)]);
}

} // namespace protocol
