// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "journal/alarmstatistics.h"
#include "journal/database.h"
#include "journal/history.h"
#include "journal/queries.h"
#include "values/utc.h"
#include <QVariant>

using values::AlarmWithTexts;
using values::Result;

namespace journal {

namespace {

QDateTime timeOf(const QVariant &value) { return values::utc(value.toLongLong()); }

/// The columns of an alarm, in the order of bound() and alarmFrom().
const QString alarmColumns = QStringLiteral("code, data, type, clock, name, extra, sub_text, reversed");
constexpr int alarmColumnCount = 8;

template <qsizetype Size> QVariant bytes(const values::FixedText<Size> &text)
{
    return text.isEmpty() ? QByteArray("") : text.bytes().toByteArray();
}

/// Without the zeros at the end.
QByteArray bytes(const std::array<quint8, 96> &flags)
{
    auto size = flags.size();
    while (size > 0 && flags[size - 1] == 0)
        --size;
    return {reinterpret_cast<const char *>(flags.data()), qsizetype(size)};
}

QVariantList bound(const AlarmWithTexts &one)
{
    return {one.alarm.code, one.alarm.data.value, quint32(one.alarm.data.type), bytes(one.alarm.time),
        bytes(one.alarm.name), bytes(one.extra), bytes(one.subText), bytes(one.reversed)};
}

AlarmWithTexts alarmFrom(const QSqlQuery &row, int column)
{
    AlarmWithTexts one;
    one.alarm.code = row.value(column).toUInt();
    one.alarm.data = {row.value(column + 1).toUInt(), values::AlarmDataType(row.value(column + 2).toUInt())};
    one.alarm.time = values::FixedText<16> {row.value(column + 3).toByteArray()};
    one.alarm.name = values::FixedText<32> {row.value(column + 4).toByteArray()};
    one.extra = values::FixedText<16> {row.value(column + 5).toByteArray()};
    one.subText = values::FixedText<96> {row.value(column + 6).toByteArray()};
    const QByteArray flags = row.value(column + 7).toByteArray().left(96);
    std::copy(flags.begin(), flags.end(), one.reversed.begin());
    return one;
}

Result<void> insert(Database &database, const HistoryReading &reading, const AlarmWithTexts &entry)
{
    const auto statement =
        QStringLiteral("INSERT INTO alarms (controller, list, seen_at, %1) VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)");
    return database
        .run(statement.arg(alarmColumns),
            QVariantList {text(reading.controller), int(reading.list), stamp(reading.seen)} + bound(entry))
        .map([](QSqlQuery *) {});
}

QString listed(const AlarmFilter &filter)
{
    return filter.list ? QStringLiteral(" AND list = %1").arg(int(*filter.list)) : QString();
}

/// `controller` twice: an empty one means all of them.
QVariantList both(const AlarmFilter &filter) { return {text(filter.controller), text(filter.controller)}; }

} // namespace

Result<void> write(Database &database, const Sighting &sighting)
{
    const auto statement = QStringLiteral(
        "INSERT INTO sightings (controller, first_seen, last_seen, times, state, %1) "
        "VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?) ON CONFLICT (controller, code, data, type) DO UPDATE SET "
        "first_seen = excluded.first_seen, last_seen = excluded.last_seen, times = excluded.times, "
        "state = excluded.state, clock = excluded.clock, name = excluded.name, extra = excluded.extra, "
        "sub_text = excluded.sub_text, reversed = excluded.reversed");
    const QVariantList values {text(sighting.controller), stamp(sighting.firstSeen), stamp(sighting.lastSeen),
        sighting.count, int(sighting.state)};
    return database.run(statement.arg(alarmColumns), values + bound(sighting.alarm)).map([](QSqlQuery *) {});
}

Result<void> write(Database &database, const HistoryReading &reading)
{
    const auto known = alarms(database, {reading.controller, reading.list, 0}, {}, values::alarmHistoryLength);
    if (!known)
        return tl::unexpected(known.error());
    QList<AlarmWithTexts> kept;
    for (const AlarmRecord &record : known->records)
        kept += record.alarm;
    for (qsizetype i = newCount(reading.entries, kept); i-- > 0;) { // the oldest first: the id is the order
        if (auto done = insert(database, reading, reading.entries[i]); !done)
            return done;
    }
    return {};
}

Result<void> write(Database &database, const Note &note)
{
    const auto ignore = [](QSqlQuery *) {};
    if (note.isEmpty())
        return database.run(QStringLiteral("DELETE FROM notes WHERE code = ?"), {note.code}).map(ignore);
    return database
        .run(QStringLiteral("INSERT INTO notes (code, cause, remedy, author, changed_at) VALUES (?, ?, ?, ?, ?) "
                            "ON CONFLICT (code) DO UPDATE SET cause = excluded.cause, remedy = excluded.remedy, "
                            "author = excluded.author, changed_at = excluded.changed_at"),
            {note.code, text(note.cause), text(note.remedy), text(note.author), stamp(note.changed)})
        .map(ignore);
}

Result<Page<AlarmRecord>> alarms(Database &database, const AlarmFilter &filter, const Cursor &from, int count)
{
    const auto statement =
        QStringLiteral("SELECT id, controller, list, seen_at, %1 FROM alarms "
                       "WHERE (? = '' OR controller = ?) AND id < ? AND id > ?%2 ORDER BY id DESC LIMIT %3")
            .arg(alarmColumns, listed(filter), QString::number(count));
    return database.run(statement, both(filter) + QVariantList {from.id, filter.newerThan})
        .map([count](QSqlQuery *query) {
            Page<AlarmRecord> page;
            Cursor last;
            while (query->next()) {
                page.records += AlarmRecord {query->value(1).toString(),
                    values::AlarmHistoryClass(query->value(2).toInt()), alarmFrom(*query, 4), timeOf(query->value(3))};
                last.id = query->value(0).toLongLong();
                page.newest = std::max(page.newest, last.id);
            }
            query->finish();
            if (page.records.size() == count)
                page.next = last;
            return page;
        });
}

Result<QList<Sighting>> sightings(Database &database, const QString &controller, int count)
{
    const auto statement = QStringLiteral("SELECT %1, first_seen, last_seen, times, state FROM sightings "
                                          "WHERE controller = ? ORDER BY last_seen DESC LIMIT %2")
                               .arg(alarmColumns)
                               .arg(count);
    return database.run(statement, {text(controller)}).map([&](QSqlQuery *query) {
        QList<Sighting> found;
        constexpr int rest = alarmColumnCount;
        while (query->next())
            found +=
                Sighting {controller, alarmFrom(*query, 0), timeOf(query->value(rest)), timeOf(query->value(rest + 1)),
                    query->value(rest + 2).toUInt(), AlarmState(query->value(rest + 3).toInt())};
        query->finish();
        return found;
    });
}

Result<QList<CodeStatistics>> statistics(Database &database, const AlarmFilter &filter, int count)
{
    const auto statement =
        QStringLiteral("SELECT %1 FROM alarms WHERE (? = '' OR controller = ?)%2 ORDER BY controller, list, id");
    return database.run(statement.arg(alarmColumns, listed(filter)), both(filter)).map([count](QSqlQuery *query) {
        AlarmStatistics statistics;
        while (query->next())
            statistics.add(alarmFrom(*query, 0));
        query->finish();
        return statistics.top(count);
    });
}

Result<QList<Note>> notes(Database &database)
{
    return database.run(QStringLiteral("SELECT code, cause, remedy, author, changed_at FROM notes ORDER BY code"))
        .map([](QSqlQuery *query) {
            QList<Note> found;
            while (query->next())
                found += Note {query->value(0).toUInt(), query->value(1).toString(), query->value(2).toString(),
                    query->value(3).toString(), timeOf(query->value(4))};
            query->finish();
            return found;
        });
}

} // namespace journal
