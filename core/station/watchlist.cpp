// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "station/watchlist.h"

#include <QJsonArray>

namespace station {

namespace {

const QString watchSubject = QStringLiteral("watchedSignals");
const QString signalsKey = QStringLiteral("signals");

void load(robot::SignalWatch &watch, const settings::Notes &notes, const protocol::Dialect &dialect)
{
    for (const QJsonValue text : notes.read(watchSubject)[signalsKey].toArray()) {
        if (const auto signal = names::signalFromText(text.toString(), dialect))
            watch.add(*signal);
    }
}

void save(const robot::SignalWatch &watch, settings::Notes notes)
{
    QJsonArray list;
    for (const auto &trace : watch.traces())
        list << toString(trace.signal);
    notes.write(watchSubject, list.isEmpty() ? QJsonObject {} : QJsonObject {{signalsKey, list}});
}

} // namespace

void keepWatchList(robot::SignalWatch &watch, settings::Notes notes, const protocol::Dialect &dialect)
{
    load(watch, notes, dialect);
    QObject::connect(&watch, &robot::SignalWatch::listChanged, &watch, [&watch, notes] { save(watch, notes); });
}

} // namespace station
