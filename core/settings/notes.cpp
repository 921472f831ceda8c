// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "settings/notes.h"

#include <QJsonDocument>
#include <QSettings>

namespace settings {

Notes::Notes(QSettings &settings, const QString &controller)
    : m_settings {settings},
      m_group {QStringLiteral("notes/") + QString::fromLatin1(controller.toUtf8().toPercentEncoding())}
{
}

QString Notes::key(const QString &subject) const { return m_group + u'/' + subject; }

QJsonObject Notes::read(const QString &subject) const
{
    return QJsonDocument::fromJson(m_settings.value(key(subject)).toString().toUtf8()).object();
}

void Notes::write(const QString &subject, const QJsonObject &json)
{
    if (json.isEmpty())
        return m_settings.remove(key(subject));
    const QByteArray text = QJsonDocument {json}.toJson(QJsonDocument::Compact);
    m_settings.setValue(key(subject), QString::fromUtf8(text));
}

} // namespace settings
