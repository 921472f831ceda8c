// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "bags.h"
#include "protocol/codes.h"
#include "verbs.h"
#include <QJsonArray>
#include <QJsonObject>

namespace pendeskctl {

namespace {

QCommandLineOption number(const char *name, const QString &text)
{
    return {QString::fromLatin1(name), text, QStringLiteral("N"), QStringLiteral("0")};
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
        print(QJsonValue {QJsonObject {{QStringLiteral("bag"), backup.path()},
            {QStringLiteral("files"), all - failures}, {QStringLiteral("listed"), all},
            {QStringLiteral("bytes"), backup.bytesDone()}, {QStringLiteral("failed"), failed}}});
    else
        print(QStringLiteral("%1  %2 of %3 files, %4 bytes")
                  .arg(backup.path())
                  .arg(all - failures)
                  .arg(all)
                  .arg(backup.bytesDone()));
}

} // namespace

int runBackup(const QStringList &arguments)
{
    Call call;
    QCommandLineParser parser;
    const auto keep = number("keep", tr("Delete all but the newest N backups afterwards, never the last good one."));
    const auto days = number("keep-days", tr("Delete backups older than N days afterwards, never the last good one."));
    const QCommandLineOption allParameters {QStringLiteral("all-prm"),
        tr("Also read ALL.PRM, which repeats the other parameter files and takes a real controller 45 s.")};
    const VerbHelp help {tr("Reads all files of the controller into DIR/<controller>/<UTC time>, in BagIt form."),
        QStringLiteral("DIR"), {keep, days, allParameters}, true, 1, 1};
    if (const auto end = read(call, parser, help, arguments))
        return *end;
    const auto most = numberOf(parser, keep);
    const auto oldest = numberOf(parser, days);
    if (!most || !oldest)
        return Usage;
    const files::Retention retention {*most, *oldest};
    const bool wantsAll = parser.isSet(allParameters);
    return run(call, [=](Desk &desk) {
        withOrder(desk, desk.call().words[0], [&desk, retention, wantsAll](files::BackupOrder order) {
            order.retention = retention;
            order.wantsAllParameters = wantsAll;
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
        tr("Reads a backup and tells whether it is what was written."), QStringLiteral("BAG"), {}, false, 1, 1};
    if (const auto end = read(call, parser, help, arguments))
        return *end;
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

} // namespace pendeskctl
