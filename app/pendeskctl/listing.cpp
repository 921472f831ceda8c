// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "listing.h"

#include "files/collection.h"
#include <QJsonArray>
#include <QRegularExpression>

using values::ErrorKind;

namespace pendeskctl {

namespace {

/// The names among `results` that match `pattern` ("*.JBI", "WELD*").
QStringList matching(const QList<files::FileResult> &results, const QString &pattern, const Desk &desk)
{
    const auto wild = QRegularExpression::fromWildcard(pattern, Qt::CaseInsensitive);
    QStringList names;
    for (const files::FileResult &result : results) {
        const QString name = desk.codec().decode(result.name);
        if (!result.error && wild.match(name).hasMatch())
            names << name;
    }
    return names;
}

/// Which lists a pattern needs: one where it names a type, else all.
QByteArrayList listsFor(const QString &pattern)
{
    const qsizetype dot = pattern.lastIndexOf(u'.');
    const QByteArray list = "*" + pattern.mid(dot).toLatin1().toUpper();
    const auto all = files::Collection::allPatterns();
    return dot >= 0 && all.contains(list) ? QByteArrayList {list} : all;
}

} // namespace

void list(Desk &desk, const QString &pattern, const NamesHandler &handler)
{
    auto *collection = new files::Collection {desk.files(), {}, &desk};
    collection->setPatterns(listsFor(pattern));
    collection->setListingOnly(true);
    QObject::connect(collection, &files::Operation::finished, &desk, [&desk, collection, pattern, handler] {
        if (collection->error())
            return desk.fail(*collection->error());
        const auto &results = collection->results();
        const auto failed =
            std::ranges::find_if(results, [](const files::FileResult &result) { return result.error.has_value(); });
        if (failed != results.end() && failed->error->kind == ErrorKind::Refused)
            return desk.fail(*failed->error);
        handler(matching(results, pattern, desk));
    });
    collection->start();
}

void expand(Desk &desk, const QStringList &words, const QStringList &done, const NamesHandler &handler)
{
    if (words.isEmpty())
        return handler(done);
    const auto goOn = [&desk, rest = words.sliced(1), done, handler](
                          const QStringList &names) { expand(desk, rest, done + names, handler); };
    const QString &word = words.first();
    if (word.contains(u'*') || word.contains(u'?'))
        list(desk, word, [word, goOn](const QStringList &names) {
            if (names.isEmpty())
                complain(tr("The controller lists no file that “%1” matches.").arg(word));
            goOn(names);
        });
    else
        goOn({word});
}

void printNames(Desk &desk, const QStringList &names)
{
    if (desk.call().isJson)
        print(QJsonValue {QJsonArray::fromStringList(names)});
    for (const QString &name : desk.call().isJson ? QStringList {} : names)
        print(name);
    desk.finish(Done);
}

} // namespace pendeskctl
