// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "support/fuzz/target.h"

#include "settings/accesssettings.h"
#include "settings/profilestore.h"
#include "settings/settingsfile.h"
#include <QFile>
#include <QTemporaryDir>

namespace fuzz {

namespace {

/// The file of settings, whatever stands in it: all is read, and the profiles in it have no fault.
void take(QByteArrayView data)
{
    static const QTemporaryDir folder;
    static int count = 0;
    const QString path = folder.filePath(QString::number(++count)); // a copy of an earlier one must not help
    QFile file {path};
    require(file.open(QIODevice::WriteOnly) && file.write(data.data(), data.size()) == data.size(), "no room");
    file.close();
    {
        settings::SettingsFile settings {path};
        const settings::ProfileStore store {settings};
        for (const auto &profile : store.profiles())
            require(settings::complaint(profile).isEmpty(), "a faulty profile was read");
        (void)store.recent(10);
        (void)store.pagesInWindows();
        (void)store.appearance();
        (void)settings::readAccess(settings);
        for (const auto &profile : store.profiles())
            (void)store.notes(profile).read(QStringLiteral("names"));
    }
    QFile::remove(path);
}

Seeds seeds()
{
    return {R"({"lastProfile": "CELL 4", "profiles/CELL%204": {"name": "CELL 4", "host": "robot"}})",
        R"({"appearance/language": "de", "appearance/scheme": "dark", "window/pagesInWindows": ["overview", "io"]})",
        R"({"access/passcodeSalt": "00", "access/passcodeHash": "zz", "access/idleMinutes": -1})",
        R"({"connections/A/connected": 7, "profiles": [], "notes/A/names": {"B001": "COUNT"}})", "{"};
}

} // namespace

extern const Target settingsFile;
const Target settingsFile {"settingsFile", take, seeds, 320, 200};

} // namespace fuzz
