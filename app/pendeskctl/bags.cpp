// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "bags.h"

#include "files/folder.h"
#include "protocol/requests.h"
#include <QFileInfo>
#include <QRegularExpression>

using values::Result;

namespace pendeskctl {

namespace {

files::BackupOrder orderFor(const Desk &desk, const QString &root, const Result<values::SystemInformation> &system)
{
    files::BackupOrder order;
    order.root = root;
    order.info.controller = desk.call().profile.folderName();
    order.info.host = desk.call().profile.host;
    if (system) {
        order.info.model = desk.codec().decode(system->model.bytes());
        order.info.software = desk.codec().decode(system->software.bytes());
        order.info.parameterVersion = desk.codec().decode(system->parameters.bytes());
    }
    return order;
}

} // namespace

QString bagAt(const QString &path) { return QString {path}.remove(QRegularExpression {QStringLiteral("/+$")}); }

tl::expected<files::Bag, ExitCode> goodBag(const QString &path)
{
    auto bag = files::Bag::open(path);
    if (!bag) {
        complain(bag.error().detail);
        return tl::unexpected(LocalFile);
    }
    if (!files::verify(path).isGood()) {
        complain(tr("The backup is not as it was written; “verify” tells what is wrong. Nothing was done with it."));
        return tl::unexpected(VerificationFailed);
    }
    return std::move(*bag);
}

tl::expected<files::FileSet, ExitCode> goodFiles(const QString &path)
{
    if (QFileInfo::exists(path + QStringLiteral("/bagit.txt")))
        return goodBag(path).map([](const files::Bag &bag) { return bag.files(); });
    auto set = files::folderFiles(path);
    if (set)
        return *set;
    complain(set.error().detail);
    return tl::unexpected(LocalFile);
}

void withOrder(Desk &desk, const QString &root, const std::function<void(const files::BackupOrder &)> &handler)
{
    desk.robot().send(protocol::ReadSystemInformation::robot(1), &desk,
        [&desk, root, handler](
            const Result<values::SystemInformation> &system) { handler(orderFor(desk, root, system)); });
}

void snapshot(Desk &desk, const std::function<void(const files::FileSet &)> &handler, files::Collection::Filter filter)
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

} // namespace pendeskctl
