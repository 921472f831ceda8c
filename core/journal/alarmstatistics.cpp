// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "journal/alarmstatistics.h"

#include "values/utc.h"
#include <QList>
#include <algorithm>

namespace journal {

namespace {

constexpr int firstSetYear = 2000; ///< A clock before that was never set.

bool isSet(const QDateTime &time) { return time.date().year() >= firstSetYear; }

/// Two times between which the clock just ran.
bool isStep(const QDateTime &from, const QDateTime &to)
{
    return from.isValid() && to.isValid() && from <= to && isSet(from) == isSet(to);
}

} // namespace

void AlarmStatistics::add(const values::AlarmWithTexts &entry)
{
    Tally &tally = m_tallies[entry.alarm.code];
    const QDateTime time = controllerTime(entry.alarm.time);
    if (isStep(tally.statistics.last, time)) {
        tally.minutes += tally.statistics.last.secsTo(time) / 60;
        ++tally.steps;
    }
    tally.statistics.code = entry.alarm.code;
    tally.statistics.name = entry.alarm.name;
    tally.statistics.last = time;
    ++tally.statistics.count;
}

QList<CodeStatistics> AlarmStatistics::top(qsizetype count) const
{
    QList<CodeStatistics> result;
    for (const auto &[code, tally] : m_tallies) {
        result.append(tally.statistics);
        if (tally.steps > 0)
            result.last().meanBetween = std::chrono::minutes {tally.minutes / tally.steps};
    }
    std::ranges::sort(result, [](const CodeStatistics &a, const CodeStatistics &b) {
        return std::pair {-a.count, a.code} < std::pair {-b.count, b.code};
    });
    return result.first(std::min(count, result.size()));
}

QDateTime controllerTime(const values::FixedText<16> &time)
{
    // An hour is an hour, whatever this computer's zone does: taken for local time, 02:30 is missing once a year.
    const QString text = QString::fromLatin1(time.bytes());
    return values::utc(QDate::fromString(text.left(10), QStringLiteral("yyyy/MM/dd")),
        QTime::fromString(text.mid(10), QStringLiteral(" HH:mm")));
}

} // namespace journal
