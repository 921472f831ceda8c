// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "support/fuzz/target.h"

#include "files/archive.h"
#include <QDir>
#include <QTemporaryDir>

namespace fuzz {

namespace {

const QString id = QStringLiteral("2026-01-12T083000Z");

/// pinned.txt of a controller's backups: whatever stands in it, a pin is set and taken away again, and keeps a backup.
void take(QByteArrayView data)
{
    static const QTemporaryDir root;
    static const files::Archive archive {root.path(), QStringLiteral("CELL 4")};
    require(QDir {}.mkpath(archive.folder() + u'/' + id), "no folder");
    QFile file {archive.folder() + QStringLiteral("/pinned.txt")};
    require(file.open(QIODevice::WriteOnly) && file.write(data.data(), data.size()) == data.size(), "no room");
    file.close();
    for (const bool isPinned : {true, false}) {
        require(archive.setPinned(id, isPinned).has_value(), "a pin cannot be changed");
        require(archive.entries().size() == 1 && archive.entries().first().isPinned == isPinned, "a pin was not kept");
    }
}

Seeds seeds() { return {"2026-01-12T083000Z\n", "2026-01-12T083000Z\r\n../x\n\n", ""}; }

} // namespace

extern const Target pinned;
const Target pinned {"pinned", take, seeds, 80, 200};

} // namespace fuzz
