// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "bags.h"
#include "files/compare.h"
#include "files/jobdiff.h"
#include "files/preflight.h"
#include "verbs.h"
#include <QJsonArray>
#include <QJsonObject>
#include <QRegularExpression>

using values::FileName;

namespace pendeskctl {

namespace {

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

QStringList editsOf(const FileName &name, const files::FileSet &older, const files::FileSet &newer,
    const files::NoiseFilter &noise, const protocol::TextCodec &codec)
{
    const auto before = older.content(name);
    const auto after = newer.content(name);
    QStringList texts;
    if (!files::isJobFile(name) || !before || !after)
        return texts;
    for (const files::JobEdit &edit : diffJobs(files::parseJob(*before), files::parseJob(*after), noise))
        texts << explain(edit, codec);
    return texts;
}

/// Prints what is not the same; the exit code.
ExitCode printComparison(const Call &call, const files::FileSet &older, const files::FileSet &newer, bool withNoise)
{
    const auto noise = withNoise ? files::NoiseFilter::none() : files::NoiseFilter {};
    const protocol::TextCodec codec {call.profile.encoding};
    const auto changes = compare(older, newer, noise);
    QJsonArray json;
    for (const files::FileChange &change : changes) {
        if (change.change == files::Change::Same || change.change == files::Change::OnlyNoise)
            continue;
        const QString name = codec.decode(change.name.bytes());
        const QString state = QString::fromLatin1(word(change.change));
        const QStringList edits =
            change.change == files::Change::Changed ? editsOf(change.name, older, newer, noise, codec) : QStringList {};
        json << QJsonObject {{QStringLiteral("name"), name}, {QStringLiteral("change"), state},
            {QStringLiteral("edits"), QJsonArray::fromStringList(edits)}};
        if (call.isJson)
            continue;
        print(QStringLiteral("%1  %2").arg(state, -8).arg(name));
        for (const QString &edit : edits)
            print(QStringLiteral("          ") + edit);
    }
    if (call.isJson)
        print(QJsonValue {json});
    return differences(changes) > 0 ? Differences : Done;
}

} // namespace

int runCompare(const QStringList &arguments)
{
    const QStringList plain = arguments.mid(1).filter(QRegularExpression {QStringLiteral("^[^-]")});
    Call call;
    QCommandLineParser parser;
    const QCommandLineOption noise {
        QStringLiteral("noise"), tr("Count dates, counters, blanks and line ends as differences too.")};
    VerbHelp help {tr("Compares two backups, or a backup with the controller; exit code 1 if they differ."),
        QStringLiteral("BAG [BAG]"), {noise}, true, 1, 2};
    // Two bags need no controller; then its options are not missed.
    help.needsController = arguments.contains(QStringLiteral("--host"))
        || arguments.contains(QStringLiteral("--profile"))
        || !arguments.filter(QRegularExpression {QStringLiteral("^--(host|profile)=")}).isEmpty()
        || arguments.contains(QStringLiteral("--help")) || plain.size() < 2;
    if (const auto end = read(call, parser, help, arguments))
        return *end;
    const auto older =
        goodBag(bagAt(call.words[0])); // what was written is told by its list; what lies there must be that
    if (!older)
        return older.error();
    const bool withNoise = parser.isSet(noise);
    if (call.words.size() == 2) {
        const auto newer = goodBag(bagAt(call.words[1]));
        return newer ? printComparison(call, older->files(), newer->files(), withNoise) : newer.error();
    }
    return run(call, [=](Desk &desk) {
        snapshot(desk, [&desk, older, withNoise](const files::FileSet &newer) {
            desk.finish(printComparison(desk.call(), older->files(), newer, withNoise));
        });
    });
}

} // namespace pendeskctl
