// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "values/move.h"

namespace values {

QString Speed::toString() const
{
    switch (kind) {
    case SpeedClass::Percent: return QStringLiteral("%1 %").arg(value / 100.0, 0, 'f', 2);
    case SpeedClass::ToolPoint: return QStringLiteral("%1 mm/s").arg(value / 10.0, 0, 'f', 1);
    case SpeedClass::Rotation: return QStringLiteral("%1 °/s").arg(value / 10.0, 0, 'f', 1);
    }
    return QString::number(value);
}

} // namespace values
