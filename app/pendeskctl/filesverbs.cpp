// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "disk/durable.h"
#include "files/localname.h"
#include "files/preflight.h"
#include "listing.h"
#include "transfers.h"
#include "verbs.h"
#include <QDir>

using values::FileName;

namespace pendeskctl {

namespace {

int get(const Call &call, const QStringList &words, const QString &folder)
{
    if (!QDir {folder}.exists() && !QDir {}.mkpath(folder)) {
        complain(tr("The folder “%1” cannot be made.").arg(folder));
        return LocalFile;
    }
    return run(call, [=](Desk &desk) {
        expand(desk, words, {}, [&desk, folder](const QStringList &names) {
            auto locals = std::make_shared<files::LocalNames>();
            transfer(desk, names, [&desk, folder, locals](const FileName &name) -> std::unique_ptr<files::Task> {
                const QString path = folder + u'/' + locals->take(name);
                if (QFileInfo::exists(path) && !desk.call().mayWrite) {
                    complain(tr("%1 exists and is left alone; --yes replaces it.").arg(path));
                    return nullptr;
                }
                return std::make_unique<files::Download>(desk.files(), name, path);
            });
        });
    });
}

/// Tells what the pre-flight found; false if one of it stands against sending.
bool passes(const FileName &name, const QString &path, const Call &call)
{
    const auto content = disk::readFile(path);
    if (!content) {
        complain(content.error().detail);
        return false;
    }
    const auto findings = files::preflight(name, *content);
    const protocol::TextCodec codec {call.profile.encoding};
    for (const inform::Finding &finding : findings) {
        if (finding.isError() || !call.isQuiet)
            complain(QStringLiteral("%1: %2").arg(path, files::explain(finding, codec)));
    }
    return files::mayBeSent(findings);
}

/// Files are not changed while a job runs; ends the program then.
bool isAtRest(Desk &desk)
{
    const auto &status = desk.station().orders.situation().status;
    if (status && !status->isRunning())
        return true;
    desk.fail({values::ErrorKind::NotSent, 0, 0, tr("A job is running; files are not changed meanwhile.")});
    return false;
}

int put(const Call &call, const QStringList &paths, bool mayReplace)
{
    std::map<QString, QString> pathOf; // by the name at the controller
    for (const QString &path : paths) {
        const QString local = QFileInfo {path}.fileName();
        const auto name = files::fromLocalName(local);
        if (!name)
            return mistake(tr("“%1” is no name that a controller takes.").arg(local));
        if (!passes(*name, path, call))
            return LocalFile;
        pathOf[QString::fromLatin1(name->bytes())] = path;
    }
    if (const auto end = requireYes(call))
        return *end;
    return change(call, [=](Desk &desk) {
        if (!isAtRest(desk))
            return;
        list(desk, QStringLiteral("*"), [&desk, pathOf, mayReplace](const QStringList &there) {
            QStringList names;
            for (const auto &[name, path] : pathOf)
                names << name;
            transfer(
                desk, names, [&desk, pathOf, mayReplace, there](const FileName &name) -> std::unique_ptr<files::Task> {
                    const QString text = QString::fromLatin1(name.bytes());
                    if (!mayReplace && there.contains(text)) {
                        complain(tr("%1 exists at the controller and is left alone; --replace replaces it.").arg(text));
                        return nullptr;
                    }
                    return desk.station().fileOrders.upload(name, pathOf.at(text));
                });
        });
    });
}

int rm(const Call &call, const QStringList &words, const QString &folder)
{
    if (const auto end = requireYes(call))
        return *end;
    return change(call, [=](Desk &desk) {
        if (!isAtRest(desk))
            return;
        expand(desk, words, {}, [&desk, folder](const QStringList &names) {
            transfer(desk, names,
                [&desk, folder](const FileName &name) { return desk.station().fileOrders.remove(name, folder); });
        });
    });
}

} // namespace

int runJobs(const QStringList &arguments)
{
    Call call;
    QCommandLineParser parser;
    if (const auto end = read(call, parser, {tr("Lists the jobs."), {}}, arguments))
        return *end;
    return run(call, [](Desk &desk) {
        list(desk, QStringLiteral("*.JBI"), [&desk](QStringList names) {
            for (QString &name : names)
                name.chop(4);
            printNames(desk, names);
        });
    });
}

int runFiles(const QStringList &arguments)
{
    Call call;
    QCommandLineParser parser;
    const QCommandLineOption to {QStringLiteral("to"), tr("The folder for what comes; for rm, for the copies."),
        QStringLiteral("DIR"), QStringLiteral(".")};
    const QCommandLineOption replace {QStringLiteral("replace"), tr("put: replace what the controller has.")};
    const VerbHelp help {
        tr("Lists, reads, sends and deletes files. Sent files are read back; before a file is deleted, a "
           "copy is written here. What exists is replaced by get with --yes, by put with --replace; put and rm need "
           "--yes."),
        QStringLiteral("ls [PATTERN] | get NAME… | put FILE… | rm NAME…"), {to, replace}, true, 1, anyNumber};
    if (const auto end = read(call, parser, help, arguments))
        return *end;
    const QString what = call.words.value(0);
    const QStringList words = call.words.mid(1);
    if (what == u"ls" && words.size() <= 1)
        return run(call, [words](Desk &desk) {
            list(desk, words.value(0, QStringLiteral("*")),
                [&desk](const QStringList &names) { printNames(desk, names); });
        });
    if (words.isEmpty())
        return mistake(tr("Say “ls”, “get NAME…”, “put FILE…” or “rm NAME…”."));
    if (what == u"get")
        return get(call, words, parser.value(to));
    if (what == u"put")
        return put(call, words, parser.isSet(replace));
    if (what == u"rm")
        return rm(call, words, parser.value(to));
    return mistake(tr("Say “ls”, “get NAME…”, “put FILE…” or “rm NAME…”."));
}

} // namespace pendeskctl
