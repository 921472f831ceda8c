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

AlarmTally tallyFrom(const QSqlQuery &row)
{
    AlarmTally tally;
    tally.code = row.value(0).toUInt();
    tally.name = values::FixedText<32> {row.value(1).toByteArray()};
    tally.count = row.value(2).toLongLong();
    tally.steps = row.value(3).toLongLong();
    tally.minutes = row.value(4).toLongLong();
    if (!row.value(5).isNull())
        tally.last = timeOf(row.value(5));
    tally.newest = row.value(6).toLongLong();
    return tally;
}
constexpr auto tallyColumns = "code, name, times, steps, minutes, last_at, newest";

Result<QList<AlarmTally>> tallies(Database &database, const QString &condition, const QVariantList &bound)
{
    const auto statement =
        QStringLiteral("SELECT %1 FROM tallies WHERE %2").arg(QLatin1String(tallyColumns), condition);
    return database.run(statement, bound).map([](QSqlQuery *query) {
        QList<AlarmTally> found;
        while (query->next())
            found += tallyFrom(*query);
        query->finish();
        return found;
    });
}

Result<void> keep(Database &database, const QString &controller, int list, const AlarmTally &tally)
{
    const auto statement = QStringLiteral(
        "INSERT INTO tallies (controller, list, %1) VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?) "
        "ON CONFLICT (controller, list, code) DO UPDATE SET name = excluded.name, times = excluded.times, "
        "steps = excluded.steps, minutes = excluded.minutes, last_at = excluded.last_at, newest = excluded.newest");
    const QVariant last =
        tally.last.isValid() ? QVariant {stamp(tally.last)} : QVariant {QMetaType {QMetaType::LongLong}};
    return database
        .run(statement.arg(QLatin1String(tallyColumns)),
            {text(controller), list, tally.code, bytes(tally.name), tally.count, tally.steps, tally.minutes, last,
                tally.newest})
        .map([](QSqlQuery *) {});
}

/// Counts one entry, which is the newest of its list.
Result<void> count(
    Database &database, const QString &controller, int list, const AlarmWithTexts &entry, const QDateTime &seen)
{
    const auto kept = tallies(database, QStringLiteral("controller = ? AND list = ? AND code = ?"),
        {text(controller), list, entry.alarm.code});
    if (!kept)
        return tl::unexpected(kept.error());
    AlarmTally tally = kept->value(0);
    tally.add(entry);
    tally.newest = std::max(tally.newest + 1, stamp(seen));
    return keep(database, controller, list, tally);
}

Result<void> insert(Database &database, const HistoryReading &reading, const AlarmWithTexts &entry)
{
    const auto statement =
        QStringLiteral("INSERT INTO alarms (controller, list, seen_at, %1) VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)");
    return database
        .run(statement.arg(alarmColumns),
            QVariantList {text(reading.controller), int(reading.list), stamp(reading.seen)} + bound(entry))
        .and_then(
            [&](QSqlQuery *) { return count(database, reading.controller, int(reading.list), entry, reading.seen); });
}

QString listed(const AlarmFilter &filter)
{
    return filter.list ? QStringLiteral(" AND list = %1").arg(int(*filter.list)) : QString();
}

/// An empty name means all of them; then there is nothing to bind either.
QString ofController(const AlarmFilter &filter)
{
    return filter.controller.isEmpty() ? QString() : QStringLiteral(" AND controller = ?");
}
QVariantList controllerOf(const AlarmFilter &filter)
{
    return filter.controller.isEmpty() ? QVariantList {} : QVariantList {filter.controller};
}

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
    const auto statement = QStringLiteral("SELECT id, controller, list, seen_at, %1 FROM alarms "
                                          "WHERE id < ? AND id > ?%2%3 ORDER BY id DESC LIMIT %4")
                               .arg(alarmColumns, ofController(filter), listed(filter), QString::number(count));
    return database.run(statement, QVariantList {from.id, filter.newerThan} + controllerOf(filter))
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
    const QString condition = QStringLiteral("times > 0") + ofController(filter) + listed(filter);
    return tallies(database, condition, controllerOf(filter)).map([count](const QList<AlarmTally> &found) {
        return topCodes(found, count);
    });
}

Result<void> countKeptAlarms(Database &database)
{
    constexpr int pageSize = 1000;
    const auto statement = QStringLiteral("SELECT controller, list, seen_at, id, %1 FROM alarms WHERE id > ? "
                                          "ORDER BY id LIMIT %2")
                               .arg(alarmColumns)
                               .arg(pageSize);
    struct Kept {
        QString controller;
        int list;
        QDateTime seen;
        AlarmWithTexts entry;
    };
    for (qint64 last = 0;;) {
        const auto query = database.run(statement, {last});
        if (!query)
            return tl::unexpected(query.error());
        QList<Kept> page; // a statement may not write while another reads (PostgreSQL)
        while ((*query)->next()) {
            const QSqlQuery &row = **query;
            page += {row.value(0).toString(), row.value(1).toInt(), timeOf(row.value(2)), alarmFrom(row, 4)};
            last = row.value(3).toLongLong();
        }
        (*query)->finish();
        for (const Kept &kept : page) {
            if (auto done = count(database, kept.controller, kept.list, kept.entry, kept.seen); !done)
                return done;
        }
        if (page.size() < pageSize)
            return {};
    }
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
