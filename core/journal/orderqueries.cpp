// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "journal/database.h"
#include "journal/queries.h"
#include "values/utc.h"
#include <QVariant>

using values::Result;

namespace journal {

namespace {

OrderRecord orderFrom(const QSqlQuery &row)
{
    OrderRecord order;
    order.at = values::utc(row.value(1).toLongLong());
    QString *const texts[] {&order.user, &order.host, &order.level, &order.controller, &order.action, &order.subject,
        &order.oldValue, &order.newValue};
    for (int i = 0; i < int(std::size(texts)); ++i)
        *texts[i] = row.value(2 + i).toString();
    order.outcome = Outcome(row.value(10).toInt());
    order.status = quint16(row.value(11).toUInt());
    order.added = quint16(row.value(12).toUInt());
    order.reply = row.value(13).toString();
    order.duration = std::chrono::milliseconds {row.value(14).toLongLong()};
    return order;
}

/// The text as a pattern of LIKE that finds it anywhere.
QString pattern(QString text)
{
    for (const char16_t special : u"\\%_") {
        if (special)
            text.replace(QChar(special), QString(u'\\') + QChar(special));
    }
    return u'%' + text.toLower() + u'%';
}

struct Condition {
    QStringList parts {QStringLiteral("(tried_at, id) < (?, ?)"), QStringLiteral("id <= ?")};
    QVariantList bound;

    void add(bool isWanted, const char *part, const QVariant &value)
    {
        if (!isWanted)
            return;
        parts += QLatin1String(part);
        bound += value;
    }
};

Condition conditionOf(const OrderFilter &filter, const Cursor &from)
{
    Condition condition;
    condition.bound = {from.at, from.id, from.newest};
    condition.add(filter.from.isValid(), "tried_at >= ?", stamp(filter.from));
    condition.add(filter.to.isValid(), "tried_at < ?", stamp(filter.to));
    condition.add(!filter.controller.isEmpty(), "controller = ?", filter.controller);
    condition.add(!filter.action.isEmpty(), "action = ?", filter.action);
    condition.add(filter.newerThan > 0, "id > ?", filter.newerThan);
    condition.add(filter.outcome.has_value(), "outcome = ?", int(filter.outcome.value_or(Outcome::Done)));
    condition.add(!filter.text.isEmpty(),
        "LOWER(person || ' ' || host || ' ' || controller || ' ' || action || ' ' || subject || ' ' || old_value || ' "
        "' "
        "|| new_value || ' ' || reply) LIKE ? ESCAPE '\\'",
        pattern(filter.text));
    return condition;
}

Result<qint64> newestId(Database &database)
{
    return database.run(QStringLiteral("SELECT MAX(id) FROM orders")).map([](QSqlQuery *query) {
        const qint64 id = query->next() ? query->value(0).toLongLong() : 0;
        query->finish();
        return id;
    });
}

/// Leaps from name to name in an index instead of reading every order.
Result<QStringList> namesIn(Database &database, const char *column)
{
    const auto statement =
        QStringLiteral("WITH RECURSIVE names(name) AS (SELECT MIN(%1) FROM orders UNION ALL "
                       "SELECT (SELECT MIN(%1) FROM orders WHERE %1 > name) FROM names WHERE name IS NOT NULL) "
                       "SELECT name FROM names WHERE name IS NOT NULL")
            .arg(QLatin1String(column));
    return database.run(statement).map([](QSqlQuery *query) {
        QStringList names;
        while (query->next())
            names += query->value(0).toString();
        query->finish();
        return names;
    });
}

} // namespace

Result<void> write(Database &database, const OrderRecord &order)
{
    const QVariantList bound {stamp(order.at), text(order.user), text(order.host), text(order.level),
        text(order.controller), text(order.action), text(order.subject), text(order.oldValue), text(order.newValue),
        int(order.outcome), order.status, order.added, text(order.reply), qint64(order.duration.count())};
    return database
        .run(QStringLiteral("INSERT INTO orders (tried_at, person, host, level, controller, action, subject, "
                            "old_value, new_value, outcome, status, added, reply, duration) "
                            "VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)"),
            bound)
        .map([](QSqlQuery *) {});
}

Result<Page<OrderRecord>> orders(Database &database, const OrderFilter &filter, const Cursor &from, int count)
{
    const auto newest = newestId(database);
    if (!newest)
        return tl::unexpected(newest.error());
    Cursor last = from;
    last.newest = std::min(from.newest, *newest);
    const Condition condition = conditionOf(filter, last);
    const auto statement =
        QStringLiteral("SELECT id, tried_at, person, host, level, controller, action, subject, old_value, new_value, "
                       "outcome, status, added, reply, duration FROM orders WHERE %1 "
                       "ORDER BY tried_at DESC, id DESC LIMIT %2")
            .arg(condition.parts.join(QStringLiteral(" AND ")))
            .arg(count);
    return database.run(statement, condition.bound).map([count, last](QSqlQuery *query) mutable {
        Page<OrderRecord> page;
        page.newest = last.newest;
        while (query->next()) {
            page.records += orderFrom(*query);
            last.at = query->value(1).toLongLong();
            last.id = query->value(0).toLongLong();
        }
        query->finish();
        if (page.records.size() == count)
            page.next = last;
        return page;
    });
}

Result<QStringList> orderActions(Database &database) { return namesIn(database, "action"); }

Result<QStringList> orderControllers(Database &database) { return namesIn(database, "controller"); }

} // namespace journal
