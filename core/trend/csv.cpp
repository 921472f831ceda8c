// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "trend/csv.h"

#include "trend/moment.h"
#include <QLocale>
#include <algorithm>
#include <vector>

namespace trend {

namespace {

QByteArray quoted(const QString &text)
{
    if (!text.contains(u',') && !text.contains(u'"') && !text.contains(u'\n') && !text.contains(u'\r'))
        return text.toUtf8();
    return '"' + QString(text).replace(u'"', QStringLiteral("\"\"")).toUtf8() + '"';
}

QByteArray heading(const Track &track)
{
    const QString unit = toString(track.unit);
    return quoted(unit.isEmpty() ? track.label : QStringLiteral("%1 (%2)").arg(track.label, unit));
}

QByteArray number(const Sample &sample)
{
    return sample.isGap() ? QByteArrayLiteral("NaN")
                          : QByteArray::number(sample.value, 'g', QLocale::FloatingPointShortest);
}

/// How far one track has been written.
struct Cursor {
    Series::View left;

    [[nodiscard]] bool isAt(Moment at) const { return !left.isEmpty() && left.first->at == at; }
    QByteArray take(Moment at)
    {
        if (!isAt(at))
            return {};
        QByteArray text = number(*left.first);
        ++left.first;
        return text;
    }
};

} // namespace

QByteArray toCsv(std::span<const Track *const> tracks, const Range &range)
{
    QByteArray csv = QByteArrayLiteral("time_utc");
    std::vector<Cursor> cursors;
    for (const Track *track : tracks) {
        csv += ',' + heading(*track);
        cursors.push_back({track->series.within(range)});
    }
    csv += "\r\n";
    while (true) {
        std::optional<Moment> next;
        for (const Cursor &cursor : cursors) {
            if (!cursor.left.isEmpty())
                next = std::min(next.value_or(Moment::max()), cursor.left.first->at);
        }
        if (!next)
            return csv;
        csv += toIso(*next).toLatin1();
        for (Cursor &cursor : cursors)
            csv += ',' + cursor.take(*next);
        csv += "\r\n";
    }
}

} // namespace trend
