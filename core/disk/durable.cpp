// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "disk/durable.h"

#include <QDir>
#include <QDirIterator>
#include <QFile>
#include <QFileInfo>
#include <QRegularExpression>
#include <QSaveFile>
#include <cerrno>
#ifdef Q_OS_UNIX
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>
#endif

using values::ErrorKind;
using values::Result;

namespace disk {

namespace {

constexpr QFileDevice::Permissions ownerOnly = QFileDevice::ReadOwner | QFileDevice::WriteOwner;

tl::unexpected<values::Error> localFailure(const QString &path, const QString &why)
{
    return values::failure(ErrorKind::LocalFile, QStringLiteral("%1: %2").arg(path, why));
}

#ifdef Q_OS_UNIX
/// Opens a regular file; what would make the reader wait for somebody is refused.
Result<void> openRegular(QFile &file)
{
    const int handle = ::open(QFile::encodeName(file.fileName()).constData(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
    if (handle < 0)
        return localFailure(file.fileName(), qt_error_string());
    struct stat about {
    };
    if (::fstat(handle, &about) != 0 || !S_ISREG(about.st_mode)) {
        ::close(handle);
        return localFailure(file.fileName(), QStringLiteral("is not a regular file"));
    }
    if (!file.open(handle, QIODevice::ReadOnly, QFileDevice::AutoCloseHandle))
        return localFailure(file.fileName(), file.errorString());
    return {};
}

/// A file system that has no such call has nothing to wait for.
bool isSynced(int returned) { return returned == 0 || errno == EINVAL || errno == ENOTSUP || errno == ENOSYS; }

/// Calls a function of the fsync() kind on a file or folder.
Result<void> syncBy(int (*synchronize)(int), const QString &path)
{
    const int handle = ::open(QFile::encodeName(path).constData(), O_RDONLY | O_CLOEXEC);
    const bool isDone = handle >= 0 && isSynced(synchronize(handle));
    const QString why = qt_error_string();
    if (handle >= 0)
        ::close(handle);
    if (!isDone)
        return localFailure(path, why);
    return {};
}
#else
Result<void> openRegular(QFile &file)
{
    if (!QFileInfo {file}.isFile())
        return localFailure(file.fileName(), QStringLiteral("is not a regular file"));
    if (!file.open(QIODevice::ReadOnly))
        return localFailure(file.fileName(), file.errorString());
    return {};
}
#endif

/// A disk that becomes full in the middle of a piece leaves no word with Qt, but the system's number.
QString reasonOf(const QIODevice &file)
{
    const int number = errno;
    return number != 0 ? qt_error_string(number) : file.errorString();
}

/// Whether the disk has all that was written; commit() would ignore that it does not.
bool isOnDisk(QSaveFile &file)
{
    if (file.error() != QFileDevice::NoError || !file.flush())
        return false;
#ifdef Q_OS_UNIX
    if (!isSynced(::fsync(file.handle()))) {
        file.cancelWriting();
        return false;
    }
#endif
    return true;
}

} // namespace

Result<QByteArray> readFile(const QString &path)
{
    QFile file {path};
    if (const auto opened = openRegular(file); !opened)
        return tl::unexpected(opened.error());
    QByteArray content = file.readAll();
    if (file.error() != QFileDevice::NoError)
        return localFailure(path, file.errorString());
    return content;
}

Result<void> writeNew(const QString &path, const QByteArray &content)
{
    QFile file {path};
    const bool isWritten =
        file.open(QIODevice::WriteOnly | QIODevice::NewOnly) && file.write(content) == content.size() && file.flush();
    if (!isWritten)
        return localFailure(path, file.errorString());
    return {};
}

Result<void> replaceFile(const QString &path, const QByteArray &content, Readers readers)
{
    const auto write = [&](QIODevice &file) -> Result<void> {
        if (file.write(content) != content.size())
            return localFailure(path, reasonOf(file));
        return {};
    };
    return replaceFile(path, write, readers);
}

Result<void> replaceFile(const QString &path, const std::function<Result<void>(QIODevice &)> &write, Readers readers)
{
    if (QFileInfo {path}.exists() && !QFileInfo {path}.isFile())
        return localFailure(path, QStringLiteral("is not a regular file"));
    QSaveFile file {path};
    if (!file.open(QIODevice::WriteOnly))
        return localFailure(path, file.errorString());
    if (readers == Readers::OwnerOnly && !file.setPermissions(ownerOnly))
        return localFailure(path, file.errorString());
    errno = 0;
    if (const auto written = write(file); !written)
        return written;
    if (!isOnDisk(file) || !file.commit())
        return localFailure(path, reasonOf(file));
    return sync(QFileInfo(path).absolutePath());
}

void removeLeftovers(const QString &path)
{
    const QFileInfo file {path};
    const QRegularExpression form {QRegularExpression::anchoredPattern(
        QRegularExpression::escape(file.fileName()) + QStringLiteral("\\.[A-Za-z]{6}"))};
    QDir folder {file.absolutePath()};
    for (const QString &name : folder.entryList(QDir::Files | QDir::Hidden | QDir::NoSymLinks)) {
        if (form.match(name).hasMatch())
            folder.remove(name);
    }
}

Result<void> makePrivateFolder(const QString &path)
{
    if (!QDir {}.mkpath(path) || !QFile::setPermissions(path, ownerOnly | QFileDevice::ExeOwner))
        return localFailure(path, qt_error_string());
    return {};
}

Result<void> sync(const QString &path)
{
#ifdef Q_OS_UNIX
    return syncBy(::fsync, path);
#else
    Q_UNUSED(path)
    return {};
#endif
}

Result<void> syncTree(const QString &folder)
{
#ifdef Q_OS_LINUX
    return syncBy(::syncfs, folder); // one call for the file system; a thousand fsync() can take ten seconds
#else
    QDirIterator entries {folder, QDir::AllEntries | QDir::NoDotAndDotDot | QDir::Hidden, QDirIterator::Subdirectories};
    while (entries.hasNext()) {
        if (const auto synced = sync(entries.next()); !synced)
            return synced;
    }
    return sync(folder);
#endif
}

} // namespace disk
