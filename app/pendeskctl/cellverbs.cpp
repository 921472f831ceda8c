// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "bags.h"
#include "cell/usewords.h"
#include "verbs.h"
#include <QJsonArray>
#include <QJsonObject>

namespace pendeskctl {

namespace {

/// The cell of a backup, a folder or files, with what it was asked. Else the code that the program ends with.
struct Question {
    Call call;
    cell::Cell cell;
};
using Asked = tl::expected<Question, int>;

Asked ask(
    const QStringList &arguments, const QString &description, const QString &words, qsizetype fewest, qsizetype most)
{
    Question question;
    QCommandLineParser parser;
    const QCommandLineOption encoding {
        QStringLiteral("encoding"), tr("The encoding of the pendant."), QStringLiteral("NAME")};
    const VerbHelp help {description, words, {encoding}, false, fewest, most};
    if (const auto end = read(question.call, parser, help, arguments))
        return tl::unexpected<int>(*end);
    auto used = std::optional {question.call.profile.encoding};
    if (parser.isSet(encoding))
        used = protocol::findEncoding(parser.value(encoding));
    if (!used)
        return tl::unexpected<int>(mistake(tr("There is no encoding “%1”.").arg(parser.value(encoding))));
    const auto set = goodFiles(bagAt(question.call.words[0]));
    if (!set)
        return tl::unexpected<int>(set.error());
    QList<cell::File> files;
    for (const auto &[name, hash] : set->hashes) {
        const auto content = set->content(name);
        if (!content) {
            complain(content.error().detail);
            return tl::unexpected<int>(LocalFile);
        }
        files << cell::File {name.bytes(), *content};
    }
    question.cell = cell::cellOf(files, protocol::TextCodec {*used});
    return question;
}

QJsonObject placeJson(const cell::Place &place, const cell::Cell &cell)
{
    static const QStringList kinds {
        QStringLiteral("job"), QStringLiteral("ladder"), QStringLiteral("macro"), QStringLiteral("names")};
    return {{QStringLiteral("in"), kinds[int(place.kind)]}, {QStringLiteral("name"), cell.codec.decode(place.name)},
        {QStringLiteral("line"), place.line}};
}

/// The keys stay English whatever the language is.
QString howKey(cell::How how)
{
    static const QStringList keys {QStringLiteral("writes"), QStringLiteral("reads"), QStringLiteral("waits"),
        QStringLiteral("calls"), QStringLiteral("jumps"), QStringLiteral("starts"), QStringLiteral("names")};
    return keys[int(how)];
}

QJsonObject useJson(const cell::Use &use, const cell::Cell &cell)
{
    QJsonObject json = placeJson(use.place, cell);
    json[QStringLiteral("how")] = howKey(use.how);
    json[QStringLiteral("maybe")] = use.isMaybe;
    if (!use.through.isEmpty())
        json[QStringLiteral("through")] = cell.codec.decode(use.through);
    if (const QString text = lineText(use.place, cell); !text.isEmpty())
        json[QStringLiteral("text")] = text;
    return json;
}

void printUses(const cell::Subject &subject, const QList<cell::Use> &uses, const cell::Cell &cell)
{
    print(subjectText(subject, cell));
    for (const cell::Use &use : uses)
        print(QStringLiteral("  %1  %2  %3")
                  .arg(useText(use), -14)
                  .arg(placeText(use.place, cell), -24)
                  .arg(lineText(use.place, cell))
                  .trimmed()
                  .prepend(QStringLiteral("  ")));
    if (uses.isEmpty())
        print(QStringLiteral("  ") + tr("not used in these files"));
}

QString callText(const cell::Call &call, const cell::Cell &cell)
{
    QString callee =
        call.callee.isEmpty() ? tr("a job that is known when the line runs") : cell.codec.decode(call.callee);
    if (!call.through.isEmpty())
        callee = QString::fromLatin1(call.through) + u' ' + callee;
    if (call.isMissing)
        callee += QStringLiteral("  ! ") + tr("no file has it");
    return callee;
}

} // namespace

int runXref(const QStringList &arguments)
{
    const auto asked = ask(arguments,
        tr("Tells where variables, signals, registers, tools, frames, macros, alarms and jobs are used: in jobs, in "
           "the "
           "ladder, in files of names."),
        QStringLiteral("BAG|FOLDER NAME…"), 2, anyNumber);
    if (!asked)
        return asked.error();
    const cell::CrossReference uses {asked->cell};
    QJsonObject json;
    for (const QString &word : asked->call.words.mid(1)) {
        const auto subject = cell::subjectFromText(word);
        if (!subject)
            return mistake(tr("Say what to look for, such as B012, IN#(5) or a job."));
        const QList<cell::Use> found = uses.uses(*subject);
        QJsonArray list;
        for (const cell::Use &use : found)
            list << useJson(use, asked->cell);
        json[toString(*subject)] = list;
        if (!asked->call.isJson)
            printUses(*subject, found, asked->cell);
    }
    if (asked->call.isJson)
        print(QJsonValue {json});
    return Done;
}

int runCalls(const QStringList &arguments)
{
    const auto asked = ask(arguments, tr("Tells which job calls, jumps to or starts which, line by line."),
        QStringLiteral("BAG|FOLDER"), 1, 1);
    if (!asked)
        return asked.error();
    const cell::CallTree tree {asked->cell};
    QJsonArray json;
    for (const cell::Call &call : tree.calls()) {
        const cell::Place place {cell::Place::Kind::Job, call.caller, call.line};
        json << QJsonObject {{QStringLiteral("caller"), asked->cell.codec.decode(call.caller)},
            {QStringLiteral("line"), call.line}, {QStringLiteral("how"), howKey(call.how)},
            {QStringLiteral("callee"), asked->cell.codec.decode(call.callee)},
            {QStringLiteral("conditional"), call.isConditional}, {QStringLiteral("missing"), call.isMissing}};
        if (!asked->call.isJson)
            print(placeText(place, asked->cell) + QStringLiteral("  ") + callText(call, asked->cell));
    }
    if (asked->call.isJson)
        print(QJsonValue {json});
    return Done;
}

int runUnused(const QStringList &arguments)
{
    const auto asked = ask(arguments,
        tr("Tells what is worth a look: jobs that nothing names, jobs that are missing, outputs with several writers, "
           "variables that are never written, tools that were not entered."),
        QStringLiteral("BAG|FOLDER"), 1, 1);
    if (!asked)
        return asked.error();
    QJsonArray json;
    const auto hints = hintsOf(asked->cell, cell::CrossReference {asked->cell}, cell::CallTree {asked->cell});
    for (const cell::Hint &hint : hints) {
        const QString text = sentence(hint, asked->cell);
        QJsonArray places;
        for (const cell::Place &place : hint.places)
            places << placeJson(place, asked->cell);
        json << QJsonObject {{QStringLiteral("subject"), toString(hint.subject)}, {QStringLiteral("text"), text},
            {QStringLiteral("places"), places}};
        if (!asked->call.isJson)
            print(text);
    }
    if (asked->call.isJson)
        print(QJsonValue {json});
    return Done;
}

} // namespace pendeskctl
