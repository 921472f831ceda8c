// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "support/fuzz/target.h"

#include "journal/database.h"
#include "journal/queries.h"
#include <QTemporaryDir>
#include <QVariant>

namespace fuzz {

namespace {

using journal::Database;

Database &database()
{
    static const QTemporaryDir folder;
    // Never destroyed: Qt forgets its connections before what was made ahead of the first one.
    static auto &database = *new Database {QUrl::fromLocalFile(folder.filePath(QStringLiteral("journal.sqlite")))};
    require(database.open().has_value(), "no database");
    return database;
}

/// A column of any type: SQLite keeps whatever another program wrote into it.
QVariant column(Source &source)
{
    const quint8 type = source.byte();
    const QByteArray bytes = source.take(source.byte() % 24).toByteArray();
    switch (type % 4) {
    case 0: return QString::fromUtf8(bytes);
    case 1: return bytes;
    case 2: return bytes.isEmpty() ? 0 : qint64(qHash(bytes));
    default: return bytes.toDouble();
    }
}

void insert(Source &source, const QString &table, const QString &columns)
{
    QVariantList bound;
    for (qsizetype count = columns.count(u',') + 1; count > 0; --count)
        bound << column(source);
    QStringList marks;
    marks.fill(QStringLiteral("?"), bound.size());
    (void)database().run(
        QStringLiteral("INSERT INTO %1 (%2) VALUES (%3)").arg(table, columns, marks.join(u',')), bound);
}

/// A row of each table as a damaged file or another program may have it; everything that is asked of the journal is
/// answered. Nothing stays.
void take(QByteArrayView data)
{
    Source source {data};
    (void)database().run(QStringLiteral("BEGIN"));
    insert(source, QStringLiteral("orders"),
        QStringLiteral(
            "tried_at, person, host, level, controller, action, subject, old_value, new_value, outcome, status, "
            "added, reply, duration"));
    insert(source, QStringLiteral("alarms"),
        QStringLiteral("controller, list, code, data, type, clock, name, extra, sub_text, reversed, seen_at"));
    insert(source, QStringLiteral("sightings"),
        QStringLiteral("controller, code, data, type, clock, name, extra, sub_text, reversed, first_seen, last_seen, "
                       "times, state"));
    insert(source, QStringLiteral("notes"), QStringLiteral("code, cause, remedy, author, changed_at"));
    (void)journal::orders(database(), {}, {}, 5);
    (void)journal::orderActions(database());
    (void)journal::orderControllers(database());
    (void)journal::alarms(database(), {}, {}, 5);
    (void)journal::sightings(database(), {}, 5);
    (void)journal::statistics(database(), {}, 5);
    (void)journal::notes(database());
    (void)database().run(QStringLiteral("ROLLBACK"));
}

Seeds seeds()
{
    QByteArray row;
    for (const char *cell : {"2\1A", "0\3WHO", "0\1H", "0\5LEVEL", "0\4CELL", "0\3ACT", "0\1S", "0\1O", "0\1N", "2\0"})
        row += QByteArray {cell};
    return {row + row + row, QByteArray(60, '\1'), QByteArray(60, '\3')};
}

} // namespace

extern const Target journalRow;
const Target journalRow {"journalRow", take, seeds, 320, 200};

} // namespace fuzz
