// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "bags.h"
#include "files/identity.h"
#include "files/restore.h"
#include "protocol/codes.h"
#include "verbs.h"
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonObject>

using values::FileName;

namespace pendeskctl {

namespace {

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

/// Both sides of the identity beside each other.
void printIdentity(const QList<files::IdentityRow> &rows)
{
    for (const files::IdentityRow &row : rows) {
        const QString mark = row.isSame ? QStringLiteral(" ")
            : row.isDecisive            ? QStringLiteral("✗")
                                        : QStringLiteral("≠");
        complain(QStringLiteral("%1 %2  %3  |  %4").arg(mark, row.title.leftJustified(20), row.backup, row.controller));
    }
}

/// What needs care is sent where it was named, and nowhere else.
void leaveOutCare(QList<files::RestoreItem> &plan)
{
    for (files::RestoreItem &item : plan) {
        if (item.needsCare)
            item.step = files::RestoreStep::NotAllowed;
    }
}

void complainOfRefusals(const Desk &desk, const files::Restore &restore)
{
    for (const files::FileResult &refusal : restore.refusals())
        complain(QStringLiteral("%1: %2").arg(desk.codec().decode(refusal.name), protocol::explain(*refusal.error)));
}

void restore(
    Desk &desk, const files::FileSet &bag, const QList<files::RestoreItem> &plan, const files::BackupOrder &order)
{
    using robot::Act;
    station::FileOrders &orders = desk.station().fileOrders;
    auto *restore =
        new files::Restore {*desk.station().controller.files(), bag, plan, order, orders.guard(Act::Restore), &desk};
    QObject::connect(restore, &files::Restore::tried, &desk,
        [&orders](const files::Upload *upload) { orders.note(*upload, Act::Upload); });
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
                complain(tr("Files restored: %1. The fresh backup is %2.")
                             .arg(restore->filesDone())
                             .arg(restore->backup().path()));
            return desk.finish(isPart ? Partial : Done);
        }
        if (!restore->refusals().isEmpty()) {
            complainOfRefusals(desk, *restore);
            complain(tr("Files restored: %1. The fresh backup is %2.")
                         .arg(restore->filesDone())
                         .arg(restore->backup().path()));
            return desk.finish(restore->filesDone() > 0 ? Partial : Refused);
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

/// Says why nothing is done with the backup of another robot.
void refuse(Desk &desk, const QList<files::IdentityRow> &identity)
{
    printIdentity(identity);
    complain(
        tr("The backup (left) is of another robot than the controller (right). Nothing was sent. Single jobs and names "
           "can be sent by their names."));
    desk.finish(Refused);
}

void act(Desk &desk, const files::Bag &bag, const QList<files::RestoreItem> &plan, const files::BackupOrder &order,
    bool isDry)
{
    printPlan(desk, plan);
    const bool sends = std::ranges::any_of(plan, &files::RestoreItem::isSent);
    const bool isBlocked =
        std::ranges::any_of(plan, [](const auto &item) { return item.step == files::RestoreStep::NotAllowed; });
    if (isDry || !sends)
        return desk.finish(isDry && sends ? Differences : isBlocked ? Partial : Done);
    desk.openStation([&desk, files = bag.files(), plan, order] { restore(desk, files, plan, order); });
}

/// Reads what matters of the controller, holds both beside each other, then acts.
void readAndPlan(
    Desk &desk, const files::Bag &bag, const QList<FileName> &names, const files::BackupOrder &order, bool isDry)
{
    const auto isWanted = [names, set = bag.files()](const FileName &name) {
        const bool tellsIdentity = name.bytes() == "SYSTEM.SYS" || name.bytes() == "VAR.DAT";
        return tellsIdentity || (names.isEmpty() ? set.hashes.contains(name) : names.contains(name));
    };
    const auto plan = [=, &desk](const files::FileSet &controller) {
        const auto identity = files::compareIdentities(
            files::identityOf(bag.info(), bag.files()), files::identityOf(order.info, controller));
        const bool isOther = files::isAnotherRobot(identity);
        if (isOther && names.isEmpty())
            return refuse(desk, identity);
        auto items = planRestore(bag.files(), controller, {names, {}, isOther});
        leaveOutCare(items);
        const bool sends = std::ranges::any_of(items, &files::RestoreItem::isSent);
        if (isOther && !sends)
            return refuse(desk, identity);
        if (!desk.call().isQuiet)
            printIdentity(identity);
        act(desk, bag, items, order, isDry);
    };
    snapshot(desk, plan, isWanted);
}

} // namespace

int runRestore(const QStringList &arguments)
{
    Call call;
    QCommandLineParser parser;
    const QCommandLineOption dryRun {QStringLiteral("dry-run"), tr("Only print what would be done.")};
    const VerbHelp help {tr("Sends back what differs from a backup of the same robot: first a fresh backup beside it, "
                            "then file by file, "
                            "each read back. Tools, frames and areas only by name; parameters, calibration and ladder "
                            "never; never while "
                            "a job runs."),
        QStringLiteral("BAG [NAME…]"), {dryRun}, true, 1, anyNumber};
    if (const auto end = read(call, parser, help, arguments))
        return *end;
    const QString path = bagAt(call.words[0]);
    const auto bag = goodBag(path);
    if (!bag)
        return bag.error();
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
        withOrder(desk, rootOf(path),
            [=, &desk](const files::BackupOrder &order) { readAndPlan(desk, *bag, names, order, isDry); });
    });
}

} // namespace pendeskctl
