// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "trend/moment.h"

namespace trend {

Moment now() { return std::chrono::time_point_cast<std::chrono::milliseconds>(std::chrono::system_clock::now()); }

Moment toMoment(const QDateTime &clock) { return Moment {std::chrono::milliseconds {clock.toMSecsSinceEpoch()}}; }

QDateTime toLocalTime(Moment moment) { return QDateTime::fromMSecsSinceEpoch(moment.time_since_epoch().count()); }

QString toIso(Moment moment) { return toLocalTime(moment).toUTC().toString(Qt::ISODateWithMs); }

std::optional<Moment> fromIso(const QString &text)
{
    const QDateTime clock = QDateTime::fromString(text, Qt::ISODateWithMs);
    return clock.isValid() ? std::optional(toMoment(clock)) : std::nullopt;
}

} // namespace trend
