// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "values/alarm.h"

#include <QCoreApplication>
#include <QStringList>
#include <algorithm>

namespace values {

namespace {

struct TypeName {
    AlarmDataType type;
    const char *name;
};

constexpr std::array typeNames {
    TypeName {AlarmDataType::None, QT_TRANSLATE_NOOP("values", "none")},
    TypeName {AlarmDataType::Unsigned16, QT_TRANSLATE_NOOP("values", "number")},
    TypeName {AlarmDataType::Bits8, QT_TRANSLATE_NOOP("values", "8 bits")},
    TypeName {AlarmDataType::AxesSlurbt, QT_TRANSLATE_NOOP("values", "axes")},
    TypeName {AlarmDataType::AxesXyz, QT_TRANSLATE_NOOP("values", "axes")},
    TypeName {AlarmDataType::AxesXyzRxRyRz, QT_TRANSLATE_NOOP("values", "axes")},
    TypeName {AlarmDataType::ConveyorFiles, QT_TRANSLATE_NOOP("values", "conveyor files")},
    TypeName {AlarmDataType::GroupsRobotStation, QT_TRANSLATE_NOOP("values", "robots and stations")},
    TypeName {AlarmDataType::Signed16, QT_TRANSLATE_NOOP("values", "signed number")},
    TypeName {AlarmDataType::Bits16, QT_TRANSLATE_NOOP("values", "16 bits")},
    TypeName {AlarmDataType::GroupsRobot, QT_TRANSLATE_NOOP("values", "robots")},
    TypeName {AlarmDataType::GroupsRobotStationBase, QT_TRANSLATE_NOOP("values", "robots, stations and bases")},
    TypeName {AlarmDataType::GroupLowHighAxes, QT_TRANSLATE_NOOP("values", "control group, low and high axes")},
    TypeName {AlarmDataType::GroupMinMaxAxes, QT_TRANSLATE_NOOP("values", "control group, minimum and maximum axes")},
    TypeName {AlarmDataType::GroupMinMaxXyz, QT_TRANSLATE_NOOP("values", "control group, minimum and maximum X Y Z")},
    TypeName {AlarmDataType::AxesOfTwoGroups, QT_TRANSLATE_NOOP("values", "axes of two control groups")},
    TypeName {AlarmDataType::TwoAxisSets, QT_TRANSLATE_NOOP("values", "two sets of axes of a control group")},
    TypeName {AlarmDataType::GroupAxesAndNumber, QT_TRANSLATE_NOOP("values", "axes of a control group and a number")},
    TypeName {AlarmDataType::GroupAndNumber, QT_TRANSLATE_NOOP("values", "control group and a number")},
};

/// The members of `set` whose bit is on, bit 0 first; hex if a bit is on that has no member.
QString members(quint32 bits, const char *set)
{
    const QStringList names = QString::fromLatin1(set).split(u' ');
    if (bits >> names.size())
        return QStringLiteral("0x%1").arg(bits, 8, 16, QLatin1Char('0'));
    QStringList present;
    for (int bit = 0; bit < names.size(); ++bit) {
        if (bits >> bit & 1)
            present += names[bit];
    }
    return present.join(u' ');
}

/// Groups of four, the highest bit first, as the pendant shows them.
QString bitPattern(quint32 bits, int count)
{
    QString text = QStringLiteral("%1").arg(bits, count, 2, QLatin1Char('0'));
    for (auto at = text.size() - 4; at > 0; at -= 4)
        text.insert(at, u' ');
    return text;
}

} // namespace

QString AlarmData::toString() const
{
    switch (type) {
    case AlarmDataType::None: return {};
    case AlarmDataType::Unsigned16: return QString::number(quint16(value));
    case AlarmDataType::Signed16: return QString::number(qint16(value));
    case AlarmDataType::Bits8: return bitPattern(value, 8);
    case AlarmDataType::Bits16: return bitPattern(value, 16);
    case AlarmDataType::AxesSlurbt: return members(value, "S L U R B T");
    case AlarmDataType::AxesXyz: return members(value, "X Y Z");
    case AlarmDataType::AxesXyzRxRyRz: return members(value, "X Y Z Rx Ry Rz");
    case AlarmDataType::ConveyorFiles: return members(value, "1 2 3");
    case AlarmDataType::GroupsRobot: return members(value, "R1 R2 R3 R4 R5 R6 R7 R8");
    default: return QStringLiteral("0x%1").arg(value, 8, 16, QLatin1Char('0'));
    }
}

QString toString(AlarmDataType type)
{
    const auto found = std::ranges::find(typeNames, type, &TypeName::type);
    if (found == typeNames.end())
        return QCoreApplication::translate("values", "unknown type %1").arg(quint32(type));
    return QCoreApplication::translate("values", found->name);
}

} // namespace values
