// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "journal/unsaved.h"

#include "disk/durable.h"
#include "journal/database.h"
#include "journal/queries.h"
#include <QCoreApplication>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLoggingCategory>
#include <QStandardPaths>

using values::Result;

namespace journal {

namespace {

Q_LOGGING_CATEGORY(unsavedLog, "pendesk.journal")

QString tr(const char *text, int count = -1)
{
    return QCoreApplication::translate("journal::Store", text, nullptr, count);
}

struct Unsaved {
    QList<OrderRecord> orders;
    QList<Note> notes;
};

/// The texts of an order, by their names in the file.
void eachText(auto &&order, auto &&visit)
{
    visit(QStringLiteral("user"), order.user);
    visit(QStringLiteral("host"), order.host);
    visit(QStringLiteral("level"), order.level);
    visit(QStringLiteral("controller"), order.controller);
    visit(QStringLiteral("action"), order.action);
    visit(QStringLiteral("subject"), order.subject);
    visit(QStringLiteral("oldValue"), order.oldValue);
    visit(QStringLiteral("newValue"), order.newValue);
    visit(QStringLiteral("reply"), order.reply);
}

QString timeText(const QDateTime &time) { return time.toUTC().toString(Qt::ISODateWithMs); }
QDateTime timeFrom(const QJsonValue &json) { return QDateTime::fromString(json.toString(), Qt::ISODateWithMs).toUTC(); }

QJsonObject toJson(const OrderRecord &order)
{
    QJsonObject json {{QStringLiteral("at"), timeText(order.at)}, {QStringLiteral("outcome"), int(order.outcome)},
        {QStringLiteral("status"), order.status}, {QStringLiteral("added"), order.added},
        {QStringLiteral("durationMs"), qint64(order.duration.count())}};
    eachText(order, [&](const QString &key, const QString &text) { json[key] = text; });
    return json;
}

OrderRecord orderFrom(const QJsonObject &json)
{
    OrderRecord order;
    order.at = timeFrom(json.value(u"at"));
    order.outcome = Outcome(std::clamp(json.value(u"outcome").toInt(), 0, int(Outcome::Withheld)));
    order.status = quint16(json.value(u"status").toInt());
    order.added = quint16(json.value(u"added").toInt());
    order.duration = std::chrono::milliseconds {json.value(u"durationMs").toInteger()};
    eachText(order, [&](const QString &key, QString &text) { text = json.value(key).toString(); });
    return order;
}

QJsonObject toJson(const Note &note)
{
    return {{QStringLiteral("code"), qint64(note.code)}, {QStringLiteral("cause"), note.cause},
        {QStringLiteral("remedy"), note.remedy}, {QStringLiteral("author"), note.author},
        {QStringLiteral("changed"), timeText(note.changed)}};
}

Note noteFrom(const QJsonObject &json)
{
    return {quint32(json.value(u"code").toInteger()), json.value(u"cause").toString(), json.value(u"remedy").toString(),
        json.value(u"author").toString(), timeFrom(json.value(u"changed"))};
}

QByteArray toText(const Unsaved &unsaved)
{
    QJsonArray orders;
    for (const OrderRecord &order : unsaved.orders)
        orders += toJson(order);
    QJsonArray notes;
    for (const Note &note : unsaved.notes)
        notes += toJson(note);
    return QJsonDocument {{{QStringLiteral("orders"), orders}, {QStringLiteral("notes"), notes}}}.toJson();
}

/// What is in the file; nothing if there is none.
Result<Unsaved> read(const QString &path)
{
    if (!QFile::exists(path))
        return Unsaved {};
    const auto text = disk::readFile(path);
    if (!text)
        return tl::unexpected(text.error());
    const QJsonDocument json = QJsonDocument::fromJson(*text);
    if (!json.isObject())
        return values::badInput(path);
    Unsaved unsaved;
    for (const QJsonValue order : json[u"orders"].toArray())
        unsaved.orders += orderFrom(order.toObject());
    for (const QJsonValue note : json[u"notes"].toArray())
        unsaved.notes += noteFrom(note.toObject());
    return unsaved;
}

Result<void> writeOnce(Database &database, const OrderRecord &order)
{
    const auto known = database.run(
        QStringLiteral("SELECT COUNT(*) FROM orders WHERE tried_at = ? AND person = ? AND host = ? AND controller = ? "
                       "AND action = ? AND subject = ? AND new_value = ? AND outcome = ?"),
        {stamp(order.at), text(order.user), text(order.host), text(order.controller), text(order.action),
            text(order.subject), text(order.newValue), int(order.outcome)});
    if (!known)
        return tl::unexpected(known.error());
    const bool isThere = (*known)->next() && (*known)->value(0).toInt() > 0;
    (*known)->finish();
    return isThere ? Result<void> {} : write(database, order);
}

Result<void> bringIn(Database &database, const Unsaved &unsaved)
{
    for (const OrderRecord &order : unsaved.orders) {
        if (auto done = writeOnce(database, order); !done)
            return done;
    }
    for (const Note &note : unsaved.notes) {
        if (auto done = write(database, note); !done)
            return done;
    }
    return {};
}

} // namespace

QString unsavedPath(const QUrl &place)
{
    const QString beside = place.isLocalFile()
        ? place.toLocalFile()
        : QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) + QStringLiteral("/journal");
    return beside + QStringLiteral(".unsaved.json");
}

QString leaveUnsaved(
    const QUrl &place, const std::vector<std::variant<OrderRecord, Sighting, HistoryReading, Note>> &changes)
{
    const QString path = unsavedPath(place);
    Unsaved unsaved = read(path).value_or(Unsaved {});
    for (const auto &change : changes) {
        if (const auto *order = std::get_if<OrderRecord>(&change))
            unsaved.orders += *order;
        else if (const auto *note = std::get_if<Note>(&change))
            unsaved.notes += *note;
    }
    const int count = int(changes.size());
    if (const auto kept = disk::replaceFile(path, toText(unsaved), disk::Readers::OwnerOnly); !kept)
        return tr("%n record(s) of the journal are lost: neither the journal nor %1 could be written.", count)
            .arg(path);
    return tr("%n record(s) could not be written into the journal. Orders and notes are kept in %1.", count).arg(path);
}

Result<void> takeInUnsaved(Database &database)
{
    const QString path = unsavedPath(database.place());
    const auto unsaved = read(path);
    if (!unsaved) {
        qCWarning(unsavedLog).noquote()
            << tr("What an earlier program left for the journal cannot be read: %1").arg(path);
        QFile::rename(path, path + QStringLiteral(".damaged"));
        return {};
    }
    if (unsaved->orders.isEmpty() && unsaved->notes.isEmpty())
        return {};
    return database.inTransaction([&] { return bringIn(database, *unsaved); }).map([&] { QFile::remove(path); });
}

} // namespace journal
