// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "trend/archive.h"

#include "disk/durable.h"
#include "trend/moment.h"
#include "values/utc.h"
#include <QJsonArray>
#include <QJsonDocument>
#include <QStandardPaths>
#include <QUrl>

namespace trend {

using values::ErrorKind;
using values::failure;
using values::Result;

namespace {

/// Larger files are none of ours.
constexpr qint64 largestFile = 64 << 20;

QString signalsFile() { return QStringLiteral("signals.json"); }

Result<void> write(const QString &path, const QJsonDocument &json)
{
    return disk::replaceFile(path, json.toJson(QJsonDocument::Compact));
}

Result<QJsonDocument> read(const QString &path)
{
    if (QFileInfo {path}.size() > largestFile)
        return values::badInput(QStringLiteral("%1 is too large").arg(path));
    const auto text = disk::readFile(path);
    if (!text)
        return tl::unexpected(text.error());
    const QJsonDocument json = QJsonDocument::fromJson(*text);
    if (json.isNull())
        return values::badInput(QStringLiteral("%1 holds no JSON").arg(path));
    return json;
}

/// "20261122T091517123Z 4315 collision.json" is sorted by time, and tells the title without opening it.
QString fileName(const Incident &incident)
{
    const QString stamp = toLocalTime(incident.at).toUTC().toString(QStringLiteral("yyyyMMdd'T'HHmmsszzz'Z'"));
    return QStringLiteral("%1 %2.json")
        .arg(stamp, QString::fromLatin1(incident.title.left(60).toUtf8().toPercentEncoding(" ")));
}

std::optional<IncidentEntry> entryOf(const QFileInfo &file)
{
    const QString name = file.completeBaseName();
    const QString stamp = name.section(u' ', 0, 0);
    const QDateTime at = values::utc(QDate::fromString(stamp.left(8), QStringLiteral("yyyyMMdd")),
        QTime::fromString(stamp.mid(8), QStringLiteral("'T'HHmmsszzz'Z'")));
    if (!at.isValid())
        return std::nullopt;
    return IncidentEntry {file.filePath(), toMoment(at), QUrl::fromPercentEncoding(name.section(u' ', 1).toLatin1())};
}

} // namespace

QString Archive::folderOf(const QString &controller)
{
    return QStringLiteral("%1/trend/%2")
        .arg(QStandardPaths::writableLocation(QStandardPaths::AppDataLocation),
            QString::fromLatin1(controller.toUtf8().toPercentEncoding()));
}

QDir Archive::incidentFolder() const { return QDir {m_folder.filePath(QStringLiteral("incidents"))}; }

QList<Signal> Archive::signalSet() const
{
    QList<Signal> result;
    const auto json = read(m_folder.filePath(signalsFile()));
    if (!json)
        return result;
    for (const QJsonValue value : json->array()) {
        if (const auto signal = fromKey(value.toString()); signal && !result.contains(*signal))
            result << *signal;
    }
    return result;
}

Result<void> Archive::saveSignalSet(const QList<Signal> &list) const
{
    QJsonArray json;
    for (const Signal &signal : list)
        json << key(signal);
    if (!m_folder.mkpath(QStringLiteral(".")))
        return failure(ErrorKind::LocalFile, m_folder.path());
    return write(m_folder.filePath(signalsFile()), QJsonDocument {json});
}

QList<IncidentEntry> Archive::incidents() const
{
    QList<IncidentEntry> result;
    for (const QFileInfo &file : incidentFolder().entryInfoList(
             {QStringLiteral("*.json")}, QDir::Files | QDir::NoSymLinks, QDir::Name | QDir::Reversed)) {
        if (const auto entry = entryOf(file))
            result << *entry;
    }
    return result;
}

Result<Incident> Archive::load(const IncidentEntry &entry) const
{
    const auto json = read(entry.file);
    return json ? incidentFromJson(json->object()) : tl::unexpected(json.error());
}

Result<IncidentEntry> Archive::keep(const Incident &incident) const
{
    const QDir folder = incidentFolder();
    if (!folder.mkpath(QStringLiteral(".")))
        return failure(ErrorKind::LocalFile, folder.path());
    const QString path = folder.filePath(fileName(incident));
    if (const auto written = write(path, QJsonDocument {toJson(incident)}); !written)
        return tl::unexpected(written.error());
    for (const IncidentEntry &old : incidents().mid(mostIncidents))
        QFile::remove(old.file);
    return IncidentEntry {path, incident.at, incident.title};
}

} // namespace trend
