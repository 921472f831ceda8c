// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include <QJsonObject>
#include <QString>

namespace settings {

class SettingsFile;

/// What people keep about one controller at this computer, apart from its profile: names, remarks, watch lists. Each
/// subject is one JSON object; what cannot be read is as if it were not there.
class Notes
{
public:
    /// `settings` must outlive the notes.
    Notes(SettingsFile &settings, const QString &controller);

    [[nodiscard]] QJsonObject read(const QString &subject) const;
    /// An empty object takes the subject away.
    void write(const QString &subject, const QJsonObject &json);

private:
    [[nodiscard]] QString key(const QString &subject) const;

    SettingsFile &m_settings;
    QString m_group;
};

} // namespace settings
