// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "journal/exports.h"

#include "disk/durable.h"
#include "journal/queries.h"

using values::Result;

namespace journal::exports {

namespace {

constexpr int pageSize = 1000;

QStringList names(const char *text) { return QString::fromLatin1(text).split(u' '); }

QVariantList rowOf(const OrderRecord &order)
{
    return {order.at, order.user, order.host, order.level, order.controller, order.action, order.subject,
        order.oldValue, order.newValue, QString::fromLatin1(key(order.outcome)), order.status, order.added, order.reply,
        qint64(order.duration.count())};
}

QVariantList rowOf(const AlarmRecord &record, const protocol::TextCodec &codec)
{
    const values::Alarm &alarm = record.alarm.alarm;
    return {record.seen, record.controller, QString::fromLatin1(key(record.list)), codec.decode(alarm.time.bytes()),
        alarm.code, alarm.data.value, quint32(alarm.data.type), alarm.data.toString(), codec.decode(alarm.name.bytes()),
        codec.decode(record.alarm.extra.bytes()), codec.decode(record.alarm.subText.bytes())};
}

/// Hands `write` a table in `path`, and keeps the file if that went well.
template <typename Write> Result<qint64> toFile(const QString &path, Format format, const char *columns, Write write)
{
    qint64 count = 0;
    const auto writeAll = [&](QIODevice &file) -> Result<void> {
        TableWriter table {file, format, names(columns)};
        const Result<qint64> written = write(table);
        if (!written)
            return tl::unexpected(written.error());
        table.end();
        count = *written;
        return {};
    };
    return disk::replaceFile(path, writeAll).map([&] { return count; });
}

/// Writes every page of `ask`, which takes a cursor.
template <typename Ask, typename Row> Result<qint64> allPages(TableWriter &table, Ask ask, Row row)
{
    qint64 count = 0;
    for (std::optional<Cursor> next = Cursor {}; next;) {
        const auto page = ask(*next);
        if (!page)
            return tl::unexpected(page.error());
        for (const auto &record : page->records)
            table.row(row(record));
        count += page->records.size();
        next = page->next;
    }
    return count;
}

} // namespace

Result<qint64> orders(Database &database, const OrderFilter &filter, const QString &path, Format format)
{
    constexpr auto columns = "time_utc user host level controller action subject old_value new_value outcome status "
                             "added_status reply duration_ms";
    return toFile(path, format, columns, [&](TableWriter &table) {
        return allPages(
            table, [&](const Cursor &from) { return journal::orders(database, filter, from, pageSize); },
            [](const OrderRecord &order) { return rowOf(order); });
    });
}

Result<qint64> alarms(
    Database &database, const AlarmFilter &filter, const protocol::TextCodec &codec, const QString &path, Format format)
{
    constexpr auto columns =
        "seen_utc controller list controller_time code sub_code sub_code_type data name extra sub_code_text";
    return toFile(path, format, columns, [&](TableWriter &table) {
        return allPages(
            table, [&](const Cursor &from) { return journal::alarms(database, filter, from, pageSize); },
            [&](const AlarmRecord &record) { return rowOf(record, codec); });
    });
}

Result<qint64> notes(Database &database, const QString &path, Format format)
{
    return toFile(path, format, "code cause remedy author changed_utc", [&](TableWriter &table) {
        return journal::notes(database).map([&](const QList<Note> &found) {
            for (const Note &note : found)
                table.row({note.code, note.cause, note.remedy, note.author, note.changed});
            return qint64(found.size());
        });
    });
}

} // namespace journal::exports
