// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "support/golden.h"

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <algorithm>

namespace golden {

namespace {

QString text(const QJsonObject &object, const char *key) { return object.value(QLatin1StringView(key)).toString(); }
QByteArray bytes(const QJsonObject &object, const char *key)
{
    return QByteArray::fromHex(text(object, key).toLatin1());
}

QJsonArray section(const char *name)
{
    static const QJsonObject document = [] {
        QFile file {QStringLiteral(PENDESK_TEST_DATA "/golden.json")};
        if (!file.open(QIODevice::ReadOnly))
            qFatal("%s", qPrintable(file.errorString()));
        return QJsonDocument::fromJson(file.readAll()).object();
    }();
    return document.value(QLatin1StringView(name)).toArray();
}

Packet packet(const QJsonObject &object)
{
    return {text(object, "from") == QLatin1StringView("client"), bytes(object, "hex"),
        object.value(QLatin1StringView("fields")).toObject()};
}

Exchange exchangeOf(const QJsonObject &object)
{
    Exchange exchange {text(object, "title"), {}};
    const QJsonArray packets = object.value(QLatin1StringView("packets")).toArray();
    for (const auto &entry : packets)
        exchange.packets += packet(entry.toObject());
    return exchange;
}

Malformed malformedOf(const QJsonObject &object)
{
    return {text(object, "title"), bytes(object, "hex"), bytes(object, "reply_to"),
        object.value(QLatin1StringView("port")).toInt(), text(object, "error")};
}

Refused refusedOf(const QJsonObject &object)
{
    const QString model = text(object, "model");
    return {text(object, "title"), bytes(object, "hex"), model.isEmpty() ? QStringLiteral("yrc1000") : model,
        quint16(object.value(QLatin1StringView("refused_with")).toInt())};
}

template <typename Row> QList<Row> rows(const char *name, Row (*make)(const QJsonObject &))
{
    QList<Row> result;
    const QJsonArray entries = section(name);
    for (const auto &entry : entries)
        result += make(entry.toObject());
    return result;
}

} // namespace

const QList<Exchange> &exchanges()
{
    static const auto list = rows("exchanges", exchangeOf);
    return list;
}

const QList<Malformed> &malformed()
{
    static const auto list = rows("malformed", malformedOf);
    return list;
}

const QList<Refused> &refused()
{
    static const auto list = rows("refused", refusedOf);
    return list;
}

const Exchange &exchange(const QString &title)
{
    const auto &list = exchanges();
    const auto found = std::ranges::find(list, title, &Exchange::title);
    if (found == list.end())
        qFatal("no golden exchange \"%s\"", qPrintable(title));
    return *found;
}

} // namespace golden
