// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "support/fuzz/target.h"

#include "journal/alarmstatistics.h"
#include "trend/moment.h"
#include "values/managementtime.h"

namespace fuzz {

namespace {

/// A time as a controller or a file of ours writes it.
void take(QByteArrayView data)
{
    values::ManagementTime time;
    time.elapsed = values::FixedText<12> {data};
    if (const auto duration = time.duration())
        require(duration->count() >= 0, "a negative running time");
    const QDateTime clock = journal::controllerTime(values::FixedText<16> {data});
    require(!clock.isValid() || clock.toString(QStringLiteral("yyyy/MM/dd HH:mm")).toLatin1() == data.first(16),
        "a time changed");
    if (const auto moment = trend::fromIso(QString::fromUtf8(data)))
        require(trend::fromIso(trend::toIso(*moment)) == moment, "a moment changed on the way");
}

Seeds seeds()
{
    return {"2026/01/12 08:30", "2026/03/29 02:30", "18:19'02\"", "2026-11-22T09:15:17.123Z", "99999999:59'59",
        "2026-11-22T09:15:17.123+01:00"};
}

} // namespace

extern const Target clock;
const Target clock {"clock", take, seeds, 32};

} // namespace fuzz
