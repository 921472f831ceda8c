// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include <QDateTime>
#include <QTimeZone>

namespace values {

/// The moment of a calendar and a clock that count in UTC, whatever zone this computer is in; invalid if one of them
/// is. Its timeSpec() is Qt::UTC.
[[nodiscard]] inline QDateTime utc(QDate date, QTime time)
{
    return date.isValid() && time.isValid() ? QDateTime {date, time, QTimeZone::utc()}.toUTC() : QDateTime {};
}

/// Milliseconds since 1970.
[[nodiscard]] inline QDateTime utc(qint64 milliseconds) { return QDateTime::fromMSecsSinceEpoch(milliseconds).toUTC(); }

} // namespace values
