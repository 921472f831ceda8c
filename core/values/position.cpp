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

} // namespace values
