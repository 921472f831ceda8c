// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include <QStringList>

/// The tables, in SQL that SQLite and PostgreSQL both understand. Times are milliseconds since 1970, UTC; a
/// controller's texts are bytes as received.
namespace journal {

/// What the two databases call differently.
struct SqlDialect {
    QString serial; ///< A number that counts by itself.
    QString bytes;
    QStringList begin; ///< Begins a transaction that writes.
};
[[nodiscard]] const SqlDialect &sqliteDialect();
[[nodiscard]] const SqlDialect &postgresDialect();

/// The statements that lead from version n to n + 1, for each n from 0 on.
[[nodiscard]] QList<QStringList> schemaSteps(const SqlDialect &dialect);

} // namespace journal
