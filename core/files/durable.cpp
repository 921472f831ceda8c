// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "files/durable.h"

#include <QDirIterator>
#include <QFile>
#include <QFileInfo>
#include <QSaveFile>
#ifdef Q_OS_UNIX
#include <fcntl.h>
#include <unistd.h>
#endif

using values::ErrorKind;
using values::Result;

namespace files {

namespace {

tl::unexpected<values::Error> localFailure(const QString &path, const QString &why)
{
    return values::failure(ErrorKind::LocalFile, QStringLiteral("%1: %2").arg(path, why));
}

} // namespace

Result<QByteArray> readFile(const QString &path)
{
    QFile file {path};
    if (!file.open(QIODevice::ReadOnly))
        return localFailure(path, file.errorString());
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

Result<void> replaceFile(const QString &path, const QByteArray &content)
{
    QSaveFile file {path};
    // commit() does not notice that the last buffer did not fit onto a full disk; flush() does.
    const bool isWritten =
        file.open(QIODevice::WriteOnly) && file.write(content) == content.size() && file.flush() && file.commit();
    if (!isWritten)
        return localFailure(path, file.errorString());
    return sync(QFileInfo(path).absolutePath());
}

namespace {

#ifdef Q_OS_UNIX
/// Calls a function of the fsync() kind on a file or folder.
Result<void> syncBy(int (*synchronize)(int), const QString &path)
{
    const int handle = ::open(QFile::encodeName(path).constData(), O_RDONLY | O_CLOEXEC);
    const bool isSynced = handle >= 0 && synchronize(handle) == 0;
    const QString why = qt_error_string();
    if (handle >= 0)
        ::close(handle);
    if (!isSynced)
        return localFailure(path, why);
    return {};
}
#endif

} // namespace

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

} // namespace files
