// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "bags.h"
#include "station/differences.h"
#include "verbs.h"
#include <QJsonArray>
#include <QJsonObject>
#include <QRegularExpression>

using values::FileName;

namespace pendeskctl {

namespace {

const char *word(cellfiles::FileClass fileClass)
{
    switch (fileClass) {
    case cellfiles::FileClass::Configuration: return "configuration";
    case cellfiles::FileClass::Data: return "data";
    case cellfiles::FileClass::Log: return "log";
    case cellfiles::FileClass::Counter: return "counter";
    }
    return "";
}

const char *word(files::Change change)
{
    switch (change) {
    case files::Change::Same: return "same";
    case files::Change::OnlyNoise: return "noise";
    case files::Change::Changed: return "changed";
    case files::Change::New: return "new";
    case files::Change::Gone: return "gone";
    case files::Change::Unread: return "unread";
    }
    return "";
}

QJsonObject toJson(const station::FileDifference &difference, const QString &name)
{
    QStringList edits;
    QJsonArray statements;
    for (const cell::Statement &statement : difference.statements) {
        edits << statement.text;
        statements << QJsonObject {{QStringLiteral("text"), statement.text},
            {QStringLiteral("safety"), statement.isSafety}, {QStringLiteral("noise"), statement.isNoise}};
    }
    return {{QStringLiteral("name"), name}, {QStringLiteral("change"), QString::fromLatin1(word(difference.change))},
        {QStringLiteral("class"), QString::fromLatin1(word(difference.fileClass))},
        {QStringLiteral("edits"), QJsonArray::fromStringList(edits)}, {QStringLiteral("statements"), statements}};
}

void printLines(const station::FileDifference &difference, const QString &name)
{
    print(QStringLiteral("%1  %2").arg(QString::fromLatin1(word(difference.change)), -8).arg(name));
    for (const cell::Statement &statement : difference.statements)
        print((statement.isSafety ? QStringLiteral("        ! ") : QStringLiteral("          ")) + statement.text);
}

/// "9 counters, 2 logs changed": what was folded.
void printFolded(const QList<station::FileDifference> &differences)
{
    using cellfiles::FileClass;
    const int counters = foldedCount(differences, FileClass::Counter);
    const int logs = foldedCount(differences, FileClass::Log);
    const int others = foldedCount(differences, FileClass::Configuration) + foldedCount(differences, FileClass::Data);
    if (counters + logs + others > 0)
        print(tr("Not counted: %1 counters, %2 logs, %3 other files with nothing but dates, hours or check lines.")
                  .arg(counters)
                  .arg(logs)
                  .arg(others));
}

/// Prints what is not the same; the exit code.
ExitCode printComparison(const Call &call, const files::FileSet &older, const files::FileSet &newer, bool withNoise)
{
    const auto noise = withNoise ? files::NoiseFilter::none() : files::NoiseFilter {};
    const protocol::TextCodec codec {call.profile.encoding};
    const auto differences = station::differencesOf(older, newer, noise, codec);
    QJsonArray json;
    bool isDifferent = false;
    for (const station::FileDifference &difference : differences) {
        if (!withNoise && !difference.counts())
            continue;
        isDifferent = true;
        const QString name = codec.decode(difference.name.bytes());
        json << toJson(difference, name);
        if (!call.isJson)
            printLines(difference, name);
    }
    if (call.isJson)
        print(QJsonValue {json});
    else if (!withNoise)
        printFolded(differences);
    return isDifferent ? Differences : Done;
}

} // namespace

int runCompare(const QStringList &arguments)
{
    const QStringList plain = arguments.mid(1).filter(QRegularExpression {QStringLiteral("^[^-]")});
    Call call;
    QCommandLineParser parser;
    const QCommandLineOption noise {
        QStringLiteral("noise"), tr("Count dates, counters, logs, blanks and line ends as differences too.")};
    VerbHelp help {
        tr("Compares two backups or folders of controller files, or one with the controller, in words; exit code 1 if "
           "configuration or data differ."),
        QStringLiteral("BAG [BAG]"), {noise}, true, 1, 2};
    // Two bags need no controller; then its options are not missed.
    help.needsController = arguments.contains(QStringLiteral("--host"))
        || arguments.contains(QStringLiteral("--profile"))
        || !arguments.filter(QRegularExpression {QStringLiteral("^--(host|profile)=")}).isEmpty()
        || arguments.contains(QStringLiteral("--help")) || plain.size() < 2;
    if (const auto end = read(call, parser, help, arguments))
        return *end;
    const auto older = goodFiles(bagAt(call.words[0])); // of a backup, what lies there must be what was written
    if (!older)
        return older.error();
    const bool withNoise = parser.isSet(noise);
    if (call.words.size() == 2) {
        const auto newer = goodFiles(bagAt(call.words[1]));
        return newer ? printComparison(call, *older, *newer, withNoise) : newer.error();
    }
    return run(call, [=](Desk &desk) {
        snapshot(desk, [&desk, older, withNoise](const files::FileSet &newer) {
            desk.finish(printComparison(desk.call(), *older, newer, withNoise));
        });
    });
}

} // namespace pendeskctl
