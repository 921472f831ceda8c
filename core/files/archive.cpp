// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "files/archive.h"

#include "disk/durable.h"
#include "values/utc.h"
#include <QDir>
#include <QRegularExpression>

using values::ErrorKind;
using values::Result;

namespace files {

namespace {

const QString pinnedName = QStringLiteral("pinned.txt");

/// When the folder name says that its backup was begun; invalid if it is no such name.
QDateTime timeOf(const QString &id)
{
    static const QRegularExpression form {QStringLiteral("^(\\d{4}-\\d\\d-\\d\\d)T(\\d{6})Z(-\\d+)?$")};
    const auto match = form.match(id);
    if (!match.hasMatch())
        return {};
    return values::utc(QDate::fromString(match.captured(1), Qt::ISODate),
        QTime::fromString(match.captured(2), QStringLiteral("HHmmss")));
}

ArchiveEntry entryOf(const QFileInfo &folder, const QStringList &pinned)
{
    ArchiveEntry entry;
    entry.id = folder.fileName();
    entry.path = folder.filePath();
    entry.taken = timeOf(entry.id);
    entry.isPinned = pinned.contains(entry.id);
    if (const auto bag = Bag::open(entry.path)) {
        entry.files = int(bag->files().hashes.size());
        entry.failures = bag->info().failures();
    } else {
        entry.isReadable = false;
    }
    return entry;
}

/// Takes a lock away whose program was killed before it could write its name into it; Qt would wait for it for long.
void clearNamelessLock(const QString &path)
{
    QLockFile lock {path};
    qint64 pid = 0;
    QString host;
    QString application;
    const bool isFresh = QFileInfo {path}.lastModified().secsTo(QDateTime::currentDateTime()) < 2;
    if (QFileInfo::exists(path) && !isFresh && !lock.getLockInfo(&pid, &host, &application))
        lock.removeStaleLockFile();
}

} // namespace

QStringList expired(
    const QList<ArchiveEntry> &newestFirst, const Retention &retention, const QDateTime &now, const QString &lastGood)
{
    QStringList ids;
    for (int index = 0; index < newestFirst.size(); ++index) {
        const ArchiveEntry &entry = newestFirst[index];
        const bool isBeyond = retention.count > 0 && index >= retention.count;
        const bool isOld = retention.days > 0 && entry.taken.addDays(retention.days) < now;
        if ((isBeyond || isOld) && !entry.isPinned && entry.id != lastGood)
            ids << entry.id;
    }
    return ids;
}

Archive::Archive(const QString &root, const QString &controller)
    : m_folder {QDir {root}.absoluteFilePath(toFolderName(controller))}
{
}

/// Those that bear the name of a backup, the newest first.
QFileInfoList Archive::folders() const
{
    QFileInfoList result = QDir {m_folder}.entryInfoList(QDir::Dirs | QDir::NoSymLinks | QDir::NoDotAndDotDot);
    result.removeIf([](const QFileInfo &folder) { return !timeOf(folder.fileName()).isValid(); });
    std::ranges::sort(result, std::greater {}, [](const QFileInfo &folder) {
        const QString id = folder.fileName();
        return std::tuple {timeOf(id), id.size(), id};
    });
    return result;
}

QList<ArchiveEntry> Archive::entries() const
{
    QList<ArchiveEntry> result;
    const QStringList pins = pinned();
    for (const QFileInfo &folder : folders())
        result << entryOf(folder, pins);
    return result;
}

QDateTime Archive::newestComplete() const
{
    for (const QFileInfo &folder : folders()) {
        if (const ArchiveEntry entry = entryOf(folder, {}); entry.isComplete())
            return entry.taken;
    }
    return {};
}

Result<std::unique_ptr<QLockFile>> Archive::lock() const
{
    if (!QDir {}.mkpath(m_folder))
        return values::failure(ErrorKind::LocalFile, QStringLiteral("%1: the folder cannot be made").arg(m_folder));
    const QString path = m_folder + QStringLiteral("/.lock");
    clearNamelessLock(path);
    clearNamelessLock(path + QStringLiteral(".rmlock")); // Qt's own, while it takes a dead program's lock away
    auto lock = std::make_unique<QLockFile>(path);
    lock->setStaleLockTime(0);
    if (lock->tryLock(0))
        return lock;
    const bool isBusy = lock->error() == QLockFile::LockFailedError;
    return values::failure(ErrorKind::LocalFile,
        (isBusy ? QStringLiteral("%1: another backup is being written here")
                : QStringLiteral("%1: the folder cannot be written"))
            .arg(m_folder));
}

void Archive::clearPartials() const
{
    for (const QFileInfo &folder : QDir {m_folder}.entryInfoList({QStringLiteral("*.partial")}, QDir::Dirs)) {
        if (timeOf(folder.completeBaseName()).isValid())
            QDir {folder.filePath()}.removeRecursively();
    }
}

QStringList Archive::pinned() const
{
    const auto text = disk::readFile(m_folder + u'/' + pinnedName);
    return text ? QString::fromUtf8(*text).split(u'\n', Qt::SkipEmptyParts) : QStringList {};
}

Result<void> Archive::setPinned(const QString &id, bool isPinned) const
{
    QStringList ids = pinned();
    ids.removeAll(id);
    if (isPinned)
        ids << id;
    ids.sort();
    return disk::replaceFile(m_folder + u'/' + pinnedName, (ids << QString {}).join(u'\n').toUtf8());
}

QString Archive::lastGood(const QList<ArchiveEntry> &newestFirst) const
{
    for (const ArchiveEntry &entry : newestFirst) {
        if (entry.isComplete() && verify(entry.path).isGood())
            return entry.id;
    }
    return {};
}

Result<QStringList> Archive::prune(const Retention &retention, const QDateTime &now) const
{
    const auto all = entries();
    if (expired(all, retention, now, {}).isEmpty())
        return QStringList {};
    const QString good = lastGood(all);
    if (good.isEmpty())
        return QStringList {}; // where nothing is good, nothing is given away
    QStringList gone;
    for (const QString &id : expired(all, retention, now, good)) {
        // Under another name first: what is half deleted must not be taken for a backup.
        const QString going = m_folder + u'/' + id + QStringLiteral(".partial");
        if (!QDir {}.rename(m_folder + u'/' + id, going) || !QDir {going}.removeRecursively())
            return values::failure(ErrorKind::LocalFile, QStringLiteral("%1: cannot be deleted").arg(going));
        gone << id;
    }
    return gone;
}

QStringList archivedControllers(const QString &root)
{
    return QDir {root}.entryList(QDir::Dirs | QDir::NoDotAndDotDot);
}

} // namespace files
