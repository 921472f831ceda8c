// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "disk/worker.h"
#include "values/error.h"
#include <QJsonObject>
#include <QObject>
#include <QStringList>
#include <map>
#include <optional>

namespace settings {

/// What this user has set: JSON values under keys such as "access/idleMinutes", in one file.
///
/// The file is read once, when the object is made. From then on what is in memory counts, and no call waits: changes
/// are written a moment later by a worker, onto what the file holds by then, so that two programs lose nothing of each
/// other. A copy ("….last-good") is written beside it. A file that cannot be understood is kept under another name and
/// the copy is used. File and copy are for their owner alone (0600), the folder too (0700).
class SettingsFile : public QObject
{
    Q_OBJECT

public:
    /// What the file is to hold under a key; nullopt: nothing.
    using Changes = std::map<QString, std::optional<QJsonValue>>;
    struct Content {
        QJsonObject values;
        QString notice; ///< As notice().
    };

    /// settings.json in the user's folder for settings.
    [[nodiscard]] static QString defaultPath();

    explicit SettingsFile(const QString &path = defaultPath(), QObject *parent = nullptr);
    /// Writes what is not written yet, for at most two seconds; what then is not is said in the log.
    ~SettingsFile() override;

    /// Undefined if there is none.
    [[nodiscard]] QJsonValue value(const QString &key) const { return m_values.value(key); }
    [[nodiscard]] bool contains(const QString &key) const { return m_values.contains(key); }
    /// The keys beneath `group`, without it.
    [[nodiscard]] QStringList keys(const QString &group) const;
    void setValue(const QString &key, const QJsonValue &value);
    /// With everything beneath it.
    void remove(const QString &key);

    /// What was wrong with the file when it was read, in sentences; empty if nothing was.
    [[nodiscard]] QString notice() const { return m_notice; }
    /// Why changes cannot be written, as a sentence; empty while they can.
    [[nodiscard]] QString trouble() const { return m_trouble; }
    /// Whether every change is on the disk.
    [[nodiscard]] bool isSaved() const { return m_changes.empty() && !m_underWay; }

Q_SIGNALS:
    /// It is tried again, and again.
    void failed(const QString &reason);
    /// After failed(): all is written.
    void recovered();
    /// Every change is on the disk.
    void saved();
    /// The file was damaged while the program ran.
    void noticed(const QString &notice);

private:
    using Written = values::Result<Content>;

    void change(const QString &key, std::optional<QJsonValue> value);
    void saveSoon();
    void save();
    void onSaved();
    /// Whether what was under way is written. If not, it is a change again.
    bool keepUnsaved();
    [[nodiscard]] QStringList unsavedKeys() const;
    void fail(const QString &why);

    QString m_path;
    QJsonObject m_values;
    QString m_notice;
    QString m_trouble;
    Changes m_changes; ///< Not on their way yet.
    std::optional<Changes> m_underWay;
    QFutureWatcher<Written> m_saving;
    disk::Worker m_worker;
    bool m_isSavingSoon = false;
};

} // namespace settings
