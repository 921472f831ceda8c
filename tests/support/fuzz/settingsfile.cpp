// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "support/fuzz/target.h"

#include "settings/accesssettings.h"
#include "settings/profilestore.h"
#include <QFile>
#include <QSettings>
#include <QTemporaryDir>

namespace fuzz {

namespace {

/// The file of settings, whatever stands in it: all is read, and the profiles in it have no fault.
void take(QByteArrayView data)
{
    static const QTemporaryDir folder;
    static int count = 0;
    const QString path = folder.filePath(QString::number(++count)); // QSettings remembers files by their names
    QFile file {path};
    require(file.open(QIODevice::WriteOnly) && file.write(data.data(), data.size()) == data.size(), "no room");
    file.close();
    {
        QSettings settings {path, QSettings::IniFormat};
        const settings::ProfileStore store {settings};
        for (const auto &profile : store.profiles())
            require(settings::complaint(profile).isEmpty(), "a faulty profile was read");
        (void)store.recent(10);
        (void)store.pagesInWindows();
        (void)store.appearance();
        (void)settings::readAccess(settings);
        (void)store.notes(QStringLiteral("CELL 4")).read(QStringLiteral("names"));
    }
    QFile::remove(path);
}

Seeds seeds()
{
    return {"lastProfile=CELL 4\n[profiles]\nCELL%204=\"{\\\"name\\\":\\\"CELL 4\\\"}\"\n[access]\nidleMinutes=5\n",
        "[appearance]\nlanguage=de\nscheme=dark\n[window]\npagesInWindows=overview, io\n",
        "[access]\npasscodeSalt=@ByteArray(00)\npasscodeHash=zz\nidleMinutes=-1\n",
        "[connections]\nA\\connected=@Invalid()\n"};
}

} // namespace

extern const Target settingsFile;
const Target settingsFile {"settingsFile", take, seeds, 320, 200};

} // namespace fuzz
