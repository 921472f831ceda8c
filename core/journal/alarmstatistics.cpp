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

/// Adds a tally of the same code in another list or controller.
void join(AlarmTally &sum, const AlarmTally &tally)
{
    if (sum.count == 0 || tally.newest > sum.newest) {
        sum.code = tally.code;
        sum.name = tally.name;
        sum.last = tally.last;
        sum.newest = tally.newest;
    }
    sum.count += tally.count;
    sum.steps += tally.steps;
    sum.minutes += tally.minutes;
}

CodeStatistics statisticsOf(const AlarmTally &sum)
{
    CodeStatistics statistics {sum.code, sum.name, int(sum.count), std::nullopt, sum.last};
    if (sum.steps > 0)
        statistics.meanBetween = std::chrono::minutes {sum.minutes / sum.steps};
    return statistics;
}

} // namespace

void AlarmTally::add(const values::AlarmWithTexts &entry)
{
    const QDateTime time = controllerTime(entry.alarm.time);
    if (isStep(last, time)) {
        minutes += last.secsTo(time) / 60;
        ++steps;
    }
    code = entry.alarm.code;
    name = entry.alarm.name;
    last = time;
    ++count;
}

QList<CodeStatistics> topCodes(const QList<AlarmTally> &tallies, qsizetype count)
{
    std::unordered_map<quint32, AlarmTally> sums;
    for (const AlarmTally &tally : tallies)
        join(sums[tally.code], tally);
    QList<CodeStatistics> result;
    for (const auto &[code, sum] : sums)
        result.append(statisticsOf(sum));
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
