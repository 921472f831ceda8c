// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "files/zip.h"

#include "disk/durable.h"
#include <QDateTime>
#include <QDir>
#include <QDirIterator>
#include <archive.h>
#include <archive_entry.h>
#include <memory>

namespace files {

namespace {

using values::Result;

using Writer = std::unique_ptr<archive, decltype(&archive_write_free)>;
using Entry = std::unique_ptr<archive_entry, decltype(&archive_entry_free)>;

la_ssize_t writeBytes(archive *, void *device, const void *bytes, size_t size)
{
    return static_cast<QIODevice *>(device)->write(static_cast<const char *>(bytes), qint64(size));
}

tl::unexpected<values::Error> failed(const QString &path, const QString &why)
{
    return values::failure(values::ErrorKind::LocalFile, QStringLiteral("%1: %2").arg(path, why));
}

tl::unexpected<values::Error> failed(const QString &path, archive *zip)
{
    return failed(path, QString::fromUtf8(archive_error_string(zip)));
}

QStringList filesUnder(const QString &folder)
{
    QStringList paths;
    QDirIterator walk {folder, QDir::Files | QDir::Hidden | QDir::NoSymLinks, QDirIterator::Subdirectories};
    while (walk.hasNext())
        paths << walk.next();
    paths.sort();
    return paths;
}

Result<void> add(archive *zip, const QString &path, const QString &name)
{
    const auto content = disk::readFile(path);
    if (!content)
        return tl::unexpected(content.error());
    const Entry entry {archive_entry_new(), &archive_entry_free};
    archive_entry_set_pathname_utf8(entry.get(), name.toUtf8().constData());
    archive_entry_set_filetype(entry.get(), AE_IFREG);
    archive_entry_set_perm(entry.get(), 0644);
    archive_entry_set_size(entry.get(), content->size());
    archive_entry_set_mtime(entry.get(), QFileInfo {path}.lastModified().toSecsSinceEpoch(), 0);
    if (archive_write_header(zip, entry.get()) != ARCHIVE_OK
        || archive_write_data(zip, content->constData(), size_t(content->size())) != content->size())
        return failed(path, zip);
    return {};
}

} // namespace

namespace {

Result<void> writeTo(QIODevice &file, const QString &folder, const QString &target, const disk::IsWanted &isWanted)
{
    const Writer zip {archive_write_new(), &archive_write_free};
    archive_write_set_format_zip(zip.get());
    archive_write_set_options(zip.get(), "zip:hdrcharset=UTF-8");
    archive_write_set_bytes_in_last_block(zip.get(), 1);
    if (archive_write_open2(zip.get(), &file, nullptr, writeBytes, nullptr, nullptr) != ARCHIVE_OK)
        return failed(target, zip.get());
    const QDir above = QFileInfo {folder}.absoluteDir();
    for (const QString &path : filesUnder(folder)) {
        if (isWanted && !isWanted())
            return values::failure(values::ErrorKind::Cancelled);
        if (auto added = add(zip.get(), path, above.relativeFilePath(path)); !added)
            return added;
    }
    if (archive_write_close(zip.get()) != ARCHIVE_OK)
        return failed(target,
            file.errorString().isEmpty() ? QString::fromUtf8(archive_error_string(zip.get())) : file.errorString());
    return {};
}

} // namespace

Result<void> writeZip(const QString &folder, const QString &target, const disk::IsWanted &isWanted)
{
    return disk::replaceFile(target, [&](QIODevice &file) { return writeTo(file, folder, target, isWanted); });
}

} // namespace files
