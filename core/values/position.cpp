// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "values/position.h"

#include <QCoreApplication>

namespace values {

QString toString(PositionType type)
{
    switch (type) {
    case PositionType::Pulse: return QCoreApplication::translate("values", "pulse");
    case PositionType::Base: return QCoreApplication::translate("values", "base frame");
    case PositionType::Robot: return QCoreApplication::translate("values", "robot frame");
    case PositionType::User: return QCoreApplication::translate("values", "user frame");
    case PositionType::Tool: return QCoreApplication::translate("values", "tool frame");
    }
    return QCoreApplication::translate("values", "unknown type %1").arg(quint32(type));
}

QString toString(ControlGroup group)
{
    const int number = group.isCartesian() ? group.instance - 100 : group.instance;
    if (number >= 1 && number <= 8)
        return QStringLiteral("R%1").arg(number);
    if (number >= 11 && number <= 18)
        return QStringLiteral("B%1").arg(number - 10);
    if (number >= 21 && number <= 44 && !group.isCartesian())
        return QStringLiteral("S%1").arg(number - 20);
    return QCoreApplication::translate("values", "group %1").arg(group.instance);
}

} // namespace values
