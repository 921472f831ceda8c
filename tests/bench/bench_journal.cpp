// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
//
// A journal of many alarms and orders: how long its answers take, beside reading every row of it once, and how long the
// end of the program takes while another program keeps the database for itself. bench_journal [rows]. Prints a table;
// nothing here passes or fails.
#include "journal/store.h"
#include <QCoreApplication>
#include <QElapsedTimer>
#include <QEventLoop>
#include <QFileInfo>
#include <QSqlDatabase>
#include <QSqlQuery>
#include <QTemporaryDir>
#include <cstdio>

using namespace journal;
using namespace std::chrono_literals;

namespace {

double milliseconds(const QElapsedTimer &timer) { return double(timer.nsecsElapsed()) / 1e6; }

/// Calls `ask` with a handler, and waits for the answer.
template <typename Value, typename Ask> double timeOf(Ask ask)
{
    QEventLoop loop;
    QElapsedTimer timer;
    timer.start();
    ask([&](const values::Result<Value> &) { loop.quit(); });
    loop.exec();
    return milliseconds(timer);
}

void fill(const QString &path, int rows)
{
    {
        auto database = QSqlDatabase::addDatabase(QStringLiteral("QSQLITE"), QStringLiteral("fill"));
        database.setDatabaseName(path);
        if (!database.open())
            std::abort();
        QSqlQuery query {database};
        const QString numbers =
            QStringLiteral("WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n WHERE i < %1) ").arg(rows);
        query.exec(QStringLiteral("BEGIN"));
        query.exec(QStringLiteral("INSERT INTO orders (tried_at, person, host, level, controller, action, subject, "
                                  "old_value, new_value, outcome, status, added, reply, duration) ")
            + numbers
            + QStringLiteral("SELECT 1700000000000 + i * 1000, 'maria', 'desk-3', 'Operate', 'CELL ' || (i % 8), "
                             "'action-' || (i % 20), 'M' || (i % 1000), '5', '100', 0, 0, 0, '', 12 FROM n"));
        query.exec(QStringLiteral("INSERT INTO alarms (controller, list, code, data, type, clock, name, extra, "
                                  "sub_text, reversed, seen_at) ")
            + numbers
            + QStringLiteral(
                "SELECT 'CELL ' || (i % 8), i % 5, 4000 + i % 300, 3, 1, CAST('2026/01/01 08:00' AS BLOB), "
                "CAST('NAME' AS BLOB), x'', x'', x'', 1700000000000 + i * 1000 FROM n"));
        query.exec(QStringLiteral("DROP TABLE tallies"));
        query.exec(QStringLiteral("DROP INDEX orders_by_action"));
        query.exec(QStringLiteral("DROP INDEX orders_by_controller"));
        query.exec(QStringLiteral("DELETE FROM journal_version WHERE number > 1"));
        query.exec(QStringLiteral("COMMIT"));
    }
    QSqlDatabase::removeDatabase(QStringLiteral("fill"));
}

/// What every answer cost when all rows were read for it.
double readAll(const QString &path)
{
    QElapsedTimer timer;
    timer.start();
    {
        auto database = QSqlDatabase::addDatabase(QStringLiteral("QSQLITE"), QStringLiteral("read"));
        database.setDatabaseName(path);
        if (!database.open())
            std::abort();
        QSqlQuery query {database};
        query.setForwardOnly(true);
        query.exec(QStringLiteral("SELECT code, clock, name FROM alarms ORDER BY controller, list, id"));
        qint64 sum = 0;
        while (query.next())
            sum += query.value(0).toLongLong() + query.value(1).toByteArray().size();
        if (sum == 0)
            std::abort();
    }
    QSqlDatabase::removeDatabase(QStringLiteral("read"));
    return milliseconds(timer);
}

void printLine(const char *what, double ms, double bound)
{
    std::printf("%-52s %10.1f ms   of reading all %8.4f\n", what, ms, ms / bound);
    std::fflush(stdout);
}

/// The end of a store with an order to write, while somebody else keeps the database.
double endWhileLocked(const QString &path)
{
    double ms = 0;
    {
        auto other = QSqlDatabase::addDatabase(QStringLiteral("QSQLITE"), QStringLiteral("other"));
        other.setDatabaseName(path);
        if (!other.open() || !QSqlQuery(other).exec(QStringLiteral("BEGIN EXCLUSIVE")))
            std::abort();
        auto store = std::make_unique<Store>(QUrl::fromLocalFile(path));
        store->append({});
        QElapsedTimer timer;
        timer.start();
        store.reset();
        ms = milliseconds(timer);
    }
    QSqlDatabase::removeDatabase(QStringLiteral("other"));
    return ms;
}

/// The end of a store while it answers a question that reads everything.
double endWhileAsked(const QString &path)
{
    auto store = std::make_unique<Store>(QUrl::fromLocalFile(path));
    (void)timeOf<QStringList>([&](auto handler) { store->orderActions(qApp, handler); });
    OrderFilter filter;
    filter.text = QStringLiteral("nowhere");
    store->orders(filter, {}, 500, qApp, [](const auto &) {});
    QElapsedTimer timer;
    timer.start();
    store.reset();
    return milliseconds(timer);
}

} // namespace

int main(int argc, char *argv[])
{
    const QCoreApplication application {argc, argv};
    const int rows = argc > 1 ? std::atoi(argv[1]) : 100'000;
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("journal.sqlite"));
    {
        Store store {QUrl::fromLocalFile(path)};
        (void)timeOf<QStringList>([&](auto handler) { store.orderActions(&store, handler); });
    }
    fill(path, rows);
    std::printf("%d orders and %d alarms, %.0f MB\n", rows, rows, double(QFileInfo(path).size()) / 1e6);
    const double bound = readAll(path);
    Store store {QUrl::fromLocalFile(path)};
    printLine("taking over a journal of the first version, once",
        timeOf<QStringList>([&](auto handler) { store.orderActions(&store, handler); }), bound);
    printLine("statistics of all controllers",
        timeOf<QList<CodeStatistics>>([&](auto handler) { store.statistics({}, 20, &store, handler); }), bound);
    printLine("newest 500 alarms of one controller", timeOf<Page<AlarmRecord>>([&](auto handler) {
        store.alarms({QStringLiteral("CELL 3"), {}, 0}, {}, 500, &store, handler);
    }),
        bound);
    printLine(
        "names of all actions", timeOf<QStringList>([&](auto handler) { store.orderActions(&store, handler); }), bound);
    OrderFilter filter;
    filter.action = QStringLiteral("action-7");
    printLine("newest 500 orders of one action",
        timeOf<Page<OrderRecord>>([&](auto handler) { store.orders(filter, {}, 500, &store, handler); }), bound);
    filter = {};
    filter.text = QStringLiteral("nowhere");
    printLine("a text that no order has",
        timeOf<Page<OrderRecord>>([&](auto handler) { store.orders(filter, {}, 500, &store, handler); }), bound);
    printLine("end of the program during such a question", endWhileAsked(path), bound);
    printLine("end of the program, database locked by another", endWhileLocked(path), bound);
    return 0;
}
