// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "settings/settingsdisk.h"

#include "disk/durable.h"
#include <QCoreApplication>
#include <QDateTime>
#include <QDir>
#include <QFileInfo>
#include <QJsonDocument>
#include <QLocale>
#include <QLockFile>

using namespace std::chrono_literals;
using values::Result;

namespace settings::onDisk {

namespace {

using Content = SettingsFile::Content;

constexpr int format = 1;
/// Longer than any writing takes. Whoever holds the lock longer is stopped; the file is replaced at once or not at all,
/// so that nothing breaks if it goes on one day.
constexpr auto longestWriting = 10s;
constexpr auto patience = 1s;

struct Texts {
    Q_DECLARE_TR_FUNCTIONS(settings::SettingsFile)
};

QString copyOf(const QString &path) { return path + QStringLiteral(".last-good"); }
QString earlierOf(const QString &path) { return QFileInfo {path}.dir().filePath(QStringLiteral("pendesk.conf")); }

/// Nothing if it is damaged, or of a form that is not known.
std::optional<QJsonObject> parsed(const QByteArray &text)
{
    const QJsonObject file = QJsonDocument::fromJson(text).object();
    if (file.value(u"format").toInt() != format || !file.value(u"values").isObject())
        return std::nullopt;
    return file.value(u"values").toObject();
}

std::optional<QJsonObject> goodOne(const QString &path)
{
    const auto text = disk::readFile(path);
    return text ? parsed(*text) : std::nullopt;
}

/// Renames the damaged file; answers its new name, or the old one if that cannot be.
QString setAside(const QString &path)
{
    const QString now = QDateTime::currentDateTimeUtc().toString(QStringLiteral("yyyyMMdd-HHmmss-zzz"));
    const QString aside = QStringLiteral("%1.damaged-%2").arg(path, now);
    return QFile::rename(path, aside) ? aside : path;
}

/// In place of a file that is not there, or not good. The copy takes its place.
Content fromCopy(const QString &path, const QString &trouble)
{
    const QString copy = copyOf(path);
    if (const auto values = goodOne(copy)) {
        const QString at = QLocale {}.toString(QFileInfo {copy}.lastModified(), QLocale::ShortFormat);
        QFile::copy(copy, path); // never over a file that is there
        return {*values, trouble + u' ' + Texts::tr("The last good ones, of %1, are used.").arg(at)};
    }
    const Content earlier = takeOver(earlierOf(path));
    const QString words = trouble + u' ' + Texts::tr("There is no good copy of them.") + u' ' + earlier.notice;
    return {earlier.values, words.trimmed()};
}

} // namespace

Content read(const QString &path)
{
    if (!QFileInfo::exists(path)) {
        if (QFileInfo::exists(copyOf(path)))
            return fromCopy(path, Texts::tr("The settings in %1 are gone.").arg(path));
        return takeOver(earlierOf(path));
    }
    const auto text = disk::readFile(path);
    if (!text)
        return fromCopy(path, Texts::tr("The settings cannot be read: %1.").arg(text.error().detail));
    if (const auto values = parsed(*text))
        return {*values, {}};
    return fromCopy(path, Texts::tr("The settings are damaged; they are kept as %1.").arg(setAside(path)));
}

Result<Content> write(const QString &path, const SettingsFile::Changes &changes)
{
    if (const auto made = disk::makePrivateFolder(QFileInfo {path}.absolutePath()); !made)
        return tl::unexpected(made.error());
    QLockFile lock {path + QStringLiteral(".lock")};
    lock.setStaleLockTime(int(std::chrono::milliseconds {longestWriting}.count()));
    if (!lock.tryLock(int(std::chrono::milliseconds {patience}.count())))
        return values::failure(values::ErrorKind::LocalFile, Texts::tr("another program holds %1").arg(path));
    Content content = read(path);
    for (const auto &[key, value] : changes) {
        if (value)
            content.values.insert(key, *value);
        else
            content.values.remove(key);
    }
    const QByteArray text =
        QJsonDocument {{{QStringLiteral("format"), format}, {QStringLiteral("values"), content.values}}}.toJson();
    for (const QString &file : {path, copyOf(path)}) {
        disk::removeLeftovers(file);
        if (const auto done = disk::replaceFile(file, text, disk::Readers::OwnerOnly); !done)
            return tl::unexpected(done.error());
    }
    disk::removeLeftovers(earlierOf(path));
    return content;
}

} // namespace settings::onDisk
