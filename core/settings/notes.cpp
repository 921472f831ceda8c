// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "settings/notes.h"

#include "settings/settingsfile.h"

namespace settings {

Notes::Notes(SettingsFile &settings, const QString &controller)
    : m_settings {settings},
      m_group {QStringLiteral("notes/") + QString::fromLatin1(controller.toUtf8().toPercentEncoding())}
{
}

QString Notes::key(const QString &subject) const { return m_group + u'/' + subject; }

QJsonObject Notes::read(const QString &subject) const { return m_settings.value(key(subject)).toObject(); }

void Notes::write(const QString &subject, const QJsonObject &json)
{
    if (json.isEmpty())
        m_settings.remove(key(subject));
    else
        m_settings.setValue(key(subject), json);
}

} // namespace settings
