// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "journal/schema.h"

namespace journal {

namespace {

QString sql(const char *text) { return QString::fromLatin1(text).simplified(); }

QStringList firstVersion(const SqlDialect &dialect)
{
    return {
        sql(R"(CREATE TABLE orders (id %1, tried_at BIGINT NOT NULL, person TEXT NOT NULL, host TEXT NOT NULL,
            level TEXT NOT NULL, controller TEXT NOT NULL, action TEXT NOT NULL, subject TEXT NOT NULL,
            old_value TEXT NOT NULL, new_value TEXT NOT NULL, outcome INTEGER NOT NULL, status INTEGER NOT NULL,
            added INTEGER NOT NULL, reply TEXT NOT NULL, duration BIGINT NOT NULL))")
            .arg(dialect.serial),
        sql("CREATE INDEX orders_by_time ON orders (tried_at, id)"),
        sql(R"(CREATE TABLE alarms (id %1, controller TEXT NOT NULL, list INTEGER NOT NULL, code BIGINT NOT NULL,
            data BIGINT NOT NULL, type BIGINT NOT NULL, clock %2, name %2, extra %2, sub_text %2, reversed %2,
            seen_at BIGINT NOT NULL))")
            .arg(dialect.serial, dialect.bytes),
        sql("CREATE INDEX alarms_by_list ON alarms (controller, list, id)"),
        sql(R"(CREATE TABLE sightings (controller TEXT NOT NULL, code BIGINT NOT NULL, data BIGINT NOT NULL,
            type BIGINT NOT NULL, clock %1, name %1, extra %1, sub_text %1, reversed %1, first_seen BIGINT NOT NULL,
            last_seen BIGINT NOT NULL, times BIGINT NOT NULL, state INTEGER NOT NULL,
            PRIMARY KEY (controller, code, data, type)))")
            .arg(dialect.bytes),
        sql(R"(CREATE TABLE notes (code BIGINT PRIMARY KEY, cause TEXT NOT NULL, remedy TEXT NOT NULL,
            author TEXT NOT NULL, changed_at BIGINT NOT NULL))"),
    };
}

/// What is asked often is answered without reading everything: alarms are counted as they come, and the orders of one
/// action or controller lie together.
QStringList secondVersion(const SqlDialect &dialect)
{
    return {
        sql(R"(CREATE TABLE tallies (controller TEXT NOT NULL, list INTEGER NOT NULL, code BIGINT NOT NULL, name %1,
            times BIGINT NOT NULL, steps BIGINT NOT NULL, minutes BIGINT NOT NULL, last_at BIGINT,
            newest BIGINT NOT NULL, PRIMARY KEY (controller, list, code)))")
            .arg(dialect.bytes),
        sql("CREATE INDEX orders_by_action ON orders (action, tried_at, id)"),
        sql("CREATE INDEX orders_by_controller ON orders (controller, tried_at, id)"),
    };
}

} // namespace

const SqlDialect &sqliteDialect()
{
    static const SqlDialect dialect {QStringLiteral("INTEGER PRIMARY KEY AUTOINCREMENT"), QStringLiteral("BLOB"),
        {QStringLiteral("BEGIN IMMEDIATE")}};
    return dialect;
}

const SqlDialect &postgresDialect()
{
    static const SqlDialect dialect {QStringLiteral("BIGSERIAL PRIMARY KEY"), QStringLiteral("BYTEA"),
        {QStringLiteral("BEGIN"), QStringLiteral("LOCK TABLE journal_version IN EXCLUSIVE MODE")}};
    return dialect;
}

QList<QStringList> schemaSteps(const SqlDialect &dialect) { return {firstVersion(dialect), secondVersion(dialect)}; }

} // namespace journal
