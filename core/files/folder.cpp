// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "files/folder.h"

#include "disk/durable.h"
#include "files/localname.h"
#include <QDir>

using values::ErrorKind;
using values::FileName;
using values::Result;

namespace files {

namespace {

bool isLeftBehind(const QString &name)
{
    return name.startsWith(u'.') || name.compare(u"Thumbs.db", Qt::CaseInsensitive) == 0
        || name.compare(u"desktop.ini", Qt::CaseInsensitive) == 0;
}

QFileInfoList filesAt(const QString &path)
{
    const QFileInfo at {path};
    if (at.isFile())
        return {at};
    QFileInfoList found = QDir {path}.entryInfoList(QDir::Files | QDir::NoSymLinks, QDir::Name);
    found.removeIf([](const QFileInfo &file) { return isLeftBehind(file.fileName()); });
    return found;
}

} // namespace

Result<FileSet> folderFiles(const QString &path)
{
    std::map<FileName, QByteArray> contents;
    qint64 bytes = 0;
    for (const QFileInfo &file : filesAt(path)) {
        const auto name = fromLocalName(file.fileName());
        bytes += file.size();
        if (bytes > mostFolderBytes)
            return values::failure(ErrorKind::LocalFile, QStringLiteral("%1: more than 256 MB").arg(path));
        const auto content = name ? disk::readFile(file.absoluteFilePath()) : Result<QByteArray> {QByteArray {}};
        if (!content)
            return tl::unexpected(content.error());
        if (name)
            contents[*name] = *content;
    }
    if (contents.empty())
        return values::failure(ErrorKind::LocalFile, QStringLiteral("%1: there are no files").arg(path));
    return fileSetOf(std::move(contents));
}

} // namespace files
