// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "desk.h"
#include "files/jobdiff.h"
#include "files/restore.h"
#include "protocol/codes.h"
#include "protocol/requests.h"
#include "verbs.h"
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonObject>
#include <QRegularExpression>

using files::OperationState;
using values::Error;
using values::FileName;
using values::Result;

namespace pendeskctl {

namespace {

QCommandLineOption number(const char *name, const QString &text)
{
    return {QString::fromLatin1(name), text, QStringLiteral("N"), QStringLiteral("0")};
}

files::BackupOrder orderFor(const Desk &desk, const QString &root, const Result<values::SystemInformation> &system)
{
    files::BackupOrder order;
    order.root = root;
    order.info.controller = desk.call().profile.name;
    order.info.host = desk.call().profile.host;
    if (system) {
        order.info.model = desk.codec().decode(system->model.bytes());
        order.info.software = desk.codec().decode(system->software.bytes());
        order.info.parameterVersion = desk.codec().decode(system->parameters.bytes());
    }
    return order;
}

/// What the controller says of itself goes into the backup; without an answer the backup is made all the same.
void withOrder(Desk &desk, const QString &root, const std::function<void(const files::BackupOrder &)> &handler)
{
    desk.robot().send(protocol::ReadSystemInformation::robot(1), &desk,
        [&desk, root, handler](
            const Result<values::SystemInformation> &system) { handler(orderFor(desk, root, system)); });
}

void printBackup(Desk &desk, const files::Backup &backup)
{
    const int all = int(backup.info().results.size());
    const int failures = backup.info().failures();
    QJsonArray failed;
    for (const files::FileResult &result : backup.info().results) {
        if (!result.error)
            continue;
        const QString name = desk.codec().decode(result.name);
        failed << QJsonObject {
            {QStringLiteral("name"), name}, {QStringLiteral("error"), protocol::explain(*result.error)}};
        complain(QStringLiteral("%1: %2").arg(name, protocol::explain(*result.error)));
    }
    if (desk.call().isJson)
        print(
            QJsonValue {QJsonObject {{QStringLiteral("bag"), backup.path()}, {QStringLiteral("files"), all - failures},
                {QStringLiteral("listed"), all}, {QStringLiteral("failed"), failed}}});
    else
        print(QStringLiteral("%1  %2 of %3 files").arg(backup.path()).arg(all - failures).arg(all));
}

/// A path as it was typed, without the slash that a shell completes.
QString bagAt(const QString &path) { return QString {path}.remove(QRegularExpression {QStringLiteral("/+$")}); }

int complainAbout(const Error &error)
{
    complain(error.detail);
    return LocalFile;
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

/// Reads the controller into memory, then goes on.
void snapshot(
    Desk &desk, const std::function<void(const files::FileSet &)> &handler, files::Collection::Filter filter = {})
{
    auto *snapshot = new files::Snapshot {desk.files(), &desk};
    snapshot->setFilter(std::move(filter));
    QObject::connect(snapshot, &files::Operation::progressed, &desk, [&desk, snapshot] {
        showProgress(desk.call(),
            QStringLiteral("%1/%2  %3")
                .arg(snapshot->filesDone())
                .arg(snapshot->filesTotal())
                .arg(desk.codec().decode(snapshot->current())));
    });
    QObject::connect(snapshot, &files::Operation::finished, &desk, [&desk, snapshot, handler] {
        if (snapshot->error())
            return desk.fail(*snapshot->error());
        showProgress(desk.call(), {});
        handler(snapshot->files());
    });
    snapshot->start();
}

const char *word(files::RestoreStep step)
{
    switch (step) {
    case files::RestoreStep::New: return "new";
    case files::RestoreStep::Changed: return "changed";
    case files::RestoreStep::Same: return "same";
    case files::RestoreStep::NotAllowed: return "not allowed";
    }
    return "";
}

void printPlan(const Desk &desk, const QList<files::RestoreItem> &plan)
{
    QJsonArray json;
    for (const files::RestoreItem &item : plan) {
        const QString name = desk.codec().decode(item.name.bytes());
        const QString step = QString::fromLatin1(word(item.step));
        json << QJsonObject {
            {QStringLiteral("name"), name}, {QStringLiteral("step"), step}, {QStringLiteral("reason"), item.reason}};
        if (!desk.call().isJson && item.step != files::RestoreStep::Same)
            print(QStringLiteral("%1  %2  %3").arg(step, -11).arg(name, item.reason).trimmed());
    }
    if (desk.call().isJson)
        print(QJsonValue {json});
}

void restore(
    Desk &desk, const files::FileSet &bag, const QList<files::RestoreItem> &plan, const files::BackupOrder &order)
{
    auto *restore = new files::Restore {desk.files(), bag, plan, order, desk.guard(), &desk};
    QObject::connect(restore, &files::Operation::progressed, &desk, [&desk, restore] {
        const auto current = restore->current();
        showProgress(desk.call(),
            current ? QStringLiteral("%1/%2  %3")
                          .arg(restore->filesDone())
                          .arg(restore->filesTotal())
                          .arg(desk.codec().decode(current->bytes()))
                    : QStringLiteral("fresh backup  %1/%2")
                          .arg(restore->backup().filesDone())
                          .arg(restore->backup().filesTotal()));
    });
    QObject::connect(restore, &files::Operation::finished, &desk, [&desk, restore, plan] {
        if (!restore->error()) {
            const bool isPart =
                std::ranges::any_of(plan, [](const auto &item) { return item.step == files::RestoreStep::NotAllowed; });
            if (!desk.call().isQuiet)
                complain(tr("%1 files were restored. The fresh backup is %2.")
                             .arg(restore->filesDone())
                             .arg(restore->backup().path()));
            return desk.finish(isPart ? Partial : Done);
        }
        desk.complainOf(*restore->error());
        if (restore->canPutBack())
            complain(tr("It stopped at %1. As it was it is in %2; “restore” that one with this name puts it back.")
                         .arg(desk.codec().decode(restore->current()->bytes()), restore->backup().path()));
        const bool isDifferent = restore->error()->kind == values::ErrorKind::Malformed;
        desk.finish(isDifferent ? VerificationFailed : exitCodeOf(*restore->error()));
    });
    restore->start();
}

/// The root of the archive in which the bag lies: two folders up.
QString rootOf(const QString &bag)
{
    return QFileInfo {QFileInfo {QFileInfo {bag}.absoluteFilePath()}.absolutePath()}.absolutePath();
}

} // namespace

int runBackup(const QStringList &arguments)
{
    Call call;
    QCommandLineParser parser;
    const auto keep = number("keep", tr("Delete all but the newest N backups afterwards, never the last good one."));
    const auto days = number("keep-days", tr("Delete backups older than N days afterwards, never the last good one."));
    const VerbHelp help {tr("Reads all files of the controller into DIR/<controller>/<UTC time>, in BagIt form."),
        QStringLiteral("DIR"), {keep, days}};
    if (const auto end = read(call, parser, help, arguments))
        return *end;
    if (call.words.size() != 1)
        return mistake(tr("Say the folder of the backups."));
    const files::Retention retention {parser.value(keep).toInt(), parser.value(days).toInt()};
    return run(call, [=](Desk &desk) {
        withOrder(desk, desk.call().words[0], [&desk, retention](files::BackupOrder order) {
            order.retention = retention;
            auto *backup = new files::Backup {desk.files(), order, &desk};
            QObject::connect(backup, &files::Operation::progressed, &desk, [&desk, backup] {
                showProgress(desk.call(),
                    QStringLiteral("%1/%2  %3")
                        .arg(backup->filesDone())
                        .arg(backup->filesTotal())
                        .arg(desk.codec().decode(backup->current())));
            });
            QObject::connect(backup, &files::Operation::finished, &desk, [&desk, backup] {
                if (backup->error())
                    return desk.fail(*backup->error());
                showProgress(desk.call(), {});
                printBackup(desk, *backup);
                desk.finish(backup->info().isComplete() ? Done : Partial);
            });
            backup->start();
        });
    });
}

int runVerify(const QStringList &arguments)
{
    Call call;
    QCommandLineParser parser;
    const VerbHelp help {
        tr("Reads a backup and tells whether it is what was written."), QStringLiteral("BAG"), {}, false};
    if (const auto end = read(call, parser, help, arguments))
        return *end;
    if (call.words.size() != 1)
        return mistake(tr("Say the backup."));
    const files::Verification found = files::verify(bagAt(call.words[0]));
    QStringList faults;
    for (const files::BagFault &fault : found.faults)
        faults << explain(fault);
    if (call.isJson)
        print(QJsonValue {QJsonObject {{QStringLiteral("good"), found.isGood()}, {QStringLiteral("files"), found.files},
            {QStringLiteral("bytes"), found.bytes}, {QStringLiteral("faults"), QJsonArray::fromStringList(faults)}}});
    else if (found.isGood())
        print(QStringLiteral("good: %1 files, %2 bytes").arg(found.files).arg(found.bytes));
    for (const QString &fault : call.isJson ? QStringList {} : faults)
        print(fault);
    return found.isGood() ? Done : VerificationFailed;
}

int runCompare(const QStringList &arguments)
{
    const QStringList plain = arguments.mid(1).filter(QRegularExpression {QStringLiteral("^[^-]")});
    Call call;
    QCommandLineParser parser;
    const QCommandLineOption noise {
        QStringLiteral("noise"), tr("Count dates, counters, blanks and line ends as differences too.")};
    VerbHelp help {tr("Compares two backups, or a backup with the controller; exit code 1 if they differ."),
        QStringLiteral("BAG [BAG]"), {noise}};
    // Two bags need no controller; then its options are not missed.
    help.needsController = arguments.contains(QStringLiteral("--host"))
        || arguments.contains(QStringLiteral("--profile"))
        || arguments.filter(QRegularExpression {QStringLiteral("^--(host|profile)=")}).size() > 0
        || arguments.contains(QStringLiteral("--help")) || plain.size() < 2;
    if (const auto end = read(call, parser, help, arguments))
        return *end;
    if (call.words.isEmpty() || call.words.size() > 2)
        return mistake(tr("Say one or two backups."));
    const auto older = files::Bag::open(bagAt(call.words[0]));
    if (!older)
        return complainAbout(older.error());
    const bool withNoise = parser.isSet(noise);
    if (call.words.size() == 2) {
        const auto newer = files::Bag::open(bagAt(call.words[1]));
        return newer ? printComparison(call, older->files(), newer->files(), withNoise) : complainAbout(newer.error());
    }
    return run(call, [=](Desk &desk) {
        snapshot(desk, [&desk, older, withNoise](const files::FileSet &newer) {
            desk.finish(printComparison(desk.call(), older->files(), newer, withNoise));
        });
    });
}

int runRestore(const QStringList &arguments)
{
    Call call;
    QCommandLineParser parser;
    const QCommandLineOption dryRun {QStringLiteral("dry-run"), tr("Only print what would be done.")};
    const VerbHelp help {
        tr("Sends back what differs from a backup: first a fresh backup beside it, then file by file, each "
           "read back. Stops at the first error; never while a job runs."),
        QStringLiteral("BAG [NAME…]"), {dryRun}};
    if (const auto end = read(call, parser, help, arguments))
        return *end;
    if (call.words.isEmpty())
        return mistake(tr("Say the backup."));
    const QString path = bagAt(call.words[0]);
    const auto bag = files::Bag::open(path);
    if (!bag)
        return complainAbout(bag.error());
    if (!files::verify(path).isGood()) {
        complain(tr("The backup is not as it was written; “verify” tells what is wrong. Nothing is restored from it."));
        return VerificationFailed;
    }
    QList<FileName> names;
    for (const QString &text : call.words.sliced(1)) {
        const auto name = protocol::TextCodec {call.profile.encoding}.encode(text).and_then(
            [](const QByteArray &bytes) { return FileName::create(bytes); });
        if (!name)
            return mistake(tr("“%1” is no file name.").arg(text));
        names << *name;
    }
    const bool isDry = parser.isSet(dryRun);
    if (const auto end = isDry ? std::nullopt : requireYes(call))
        return *end;
    return run(call, [=](Desk &desk) {
        const auto isWanted = [names, set = bag->files()](const FileName &name) {
            return names.isEmpty() ? set.hashes.contains(name) : names.contains(name);
        };
        snapshot(
            desk,
            [&desk, bag, names, isDry, path](const files::FileSet &controller) {
                const auto plan = planRestore(bag->files(), controller, names);
                printPlan(desk, plan);
                const bool sends = std::ranges::any_of(plan, &files::RestoreItem::isSent);
                const bool isBlocked = std::ranges::any_of(
                    plan, [](const auto &item) { return item.step == files::RestoreStep::NotAllowed; });
                if (isDry || !sends)
                    return desk.finish(isDry && sends ? Differences : isBlocked ? Partial : Done);
                withOrder(desk, rootOf(path),
                    [&desk, bag, plan](const files::BackupOrder &order) { restore(desk, bag->files(), plan, order); });
            },
            isWanted);
    });
}

} // namespace pendeskctl
