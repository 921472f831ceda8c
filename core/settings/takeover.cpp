// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "disk/durable.h"
#include "settings/settingsdisk.h"
#include <QCoreApplication>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QSettings>

namespace settings::onDisk {

namespace {

struct TakeOverTexts {
    Q_DECLARE_TR_FUNCTIONS(settings::SettingsFile)
};

bool isJsonText(const QString &key) { return key.startsWith(u"profiles/") || key.startsWith(u"notes/"); }

/// INI knows texts alone; what they stand for follows from the key. Undefined if it cannot be read.
QJsonValue valueOf(const QString &key, const QVariant &value)
{
    if (isJsonText(key)) {
        const auto json = QJsonDocument::fromJson(value.toString().toUtf8());
        return json.isObject() ? json.object() : QJsonValue {QJsonValue::Undefined};
    }
    if (key.endsWith(u"/readinessSeen"))
        return value.toBool();
    if (key == u"access/idleMinutes")
        return value.toInt();
    if (key == u"window/pagesInWindows")
        return QJsonArray::fromStringList(value.toStringList());
    return value.toString();
}

/// QSettings ends a file with a line end.
bool isCut(const QString &path)
{
    const auto text = disk::readFile(path);
    return !text || (!text->isEmpty() && !text->endsWith('\n'));
}

QString notice(const QString &path, int unreadable)
{
    if (unreadable == 0)
        return {};
    return TakeOverTexts::tr(
        "%n entry(ies) of the earlier settings cannot be read; they stay in %1.", nullptr, unreadable)
        .arg(path);
}

} // namespace

SettingsFile::Content takeOver(const QString &path)
{
    if (!QFileInfo {path}.isFile()) // a pipe would keep the reader waiting
        return {};
    const QSettings earlier {path, QSettings::IniFormat};
    SettingsFile::Content content;
    int unreadable = earlier.status() != QSettings::NoError || isCut(path) ? 1 : 0;
    for (const QString &key : earlier.allKeys()) {
        const QJsonValue value = valueOf(key, earlier.value(key));
        if (value.isUndefined())
            ++unreadable;
        else
            content.values.insert(key, value);
    }
    content.notice = notice(path, unreadable);
    return content;
}

} // namespace settings::onDisk
