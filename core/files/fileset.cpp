// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "files/fileset.h"

using values::ErrorKind;
using values::FileName;
using values::Result;

namespace files {

FileSet fileSetOf(std::map<FileName, QByteArray> contents)
{
    FileSet set;
    for (const auto &[name, content] : contents)
        set.hashes[name] = sha256(content);
    set.content = [contents = std::move(contents)](const FileName &name) -> Result<QByteArray> {
        const auto found = contents.find(name);
        if (found == contents.end())
            return values::failure(
                ErrorKind::LocalFile, QStringLiteral("%1 was not read").arg(QString::fromLatin1(name.bytes())));
        return found->second;
    };
    return set;
}

void markUnread(FileSet &set, const QList<FileResult> &results)
{
    for (const FileResult &result : results) {
        if (!result.error)
            continue;
        if (const auto name = FileName::create(result.name))
            set.unread.insert(*name);
        else if (result.name.startsWith("*."))
            set.unlisted.insert(result.name.sliced(2));
    }
}

} // namespace files
