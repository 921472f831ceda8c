// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "settings/settingsfile.h"

#include "settings/settingsdisk.h"
#include <QDeadlineTimer>
#include <QLoggingCategory>
#include <QStandardPaths>

using namespace std::chrono_literals;

namespace settings {

namespace {

Q_LOGGING_CATEGORY(settingsLog, "pendesk.settings")

constexpr auto retry = 2s; ///< A locked file or a full disk may be well by then.
constexpr auto patience = 2s; ///< At the end of the program.

bool isBeneath(const QString &key, const QString &above) { return key == above || key.startsWith(above + u'/'); }

void put(QJsonObject &values, const QString &key, const std::optional<QJsonValue> &value)
{
    if (value)
        values.insert(key, *value);
    else
        values.remove(key);
}

} // namespace

QString SettingsFile::defaultPath()
{
    return QStandardPaths::writableLocation(QStandardPaths::GenericConfigLocation)
        + QStringLiteral("/pendesk/settings.json");
}

SettingsFile::SettingsFile(const QString &path, QObject *parent) : QObject {parent}, m_path {path}
{
    const Content content = onDisk::read(path);
    m_values = content.values;
    m_notice = content.notice;
    if (!m_notice.isEmpty())
        qCWarning(settingsLog).noquote() << m_notice;
    connect(&m_saving, &QFutureWatcherBase::finished, this, [this] { onSaved(); });
}

SettingsFile::~SettingsFile()
{
    m_saving.disconnect(this);
    const QDeadlineTimer end {patience};
    bool isWorking = m_worker.waitForDone(patience);
    if (m_underWay && isWorking)
        isWorking = keepUnsaved();
    if (isWorking && !m_changes.empty()) {
        save();
        isWorking = m_worker.waitForDone(std::chrono::milliseconds {end.remainingTime()}) && keepUnsaved();
    }
    if (!isWorking)
        qCWarning(settingsLog).noquote()
            << tr("Settings could not be saved in time and are lost: %1").arg(unsavedKeys().join(QStringLiteral(", ")));
}

bool SettingsFile::keepUnsaved()
{
    auto sent = *std::exchange(m_underWay, std::nullopt);
    if (m_saving.future().result())
        return true;
    m_changes.merge(sent); // what was changed since stays
    return false;
}

QStringList SettingsFile::unsavedKeys() const
{
    QStringList keys;
    for (const auto &[key, value] : m_changes)
        keys << key;
    if (m_underWay) {
        for (const auto &[key, value] : *m_underWay)
            keys << key;
    }
    return keys;
}

QStringList SettingsFile::keys(const QString &group) const
{
    QStringList found;
    for (const QString &key : m_values.keys()) {
        if (key.startsWith(group + u'/'))
            found << key.mid(group.size() + 1);
    }
    return found;
}

void SettingsFile::setValue(const QString &key, const QJsonValue &value)
{
    if (m_values.value(key) != value)
        change(key, value);
}

void SettingsFile::remove(const QString &key)
{
    for (const QString &one : m_values.keys()) {
        if (isBeneath(one, key))
            change(one, std::nullopt);
    }
}

void SettingsFile::change(const QString &key, std::optional<QJsonValue> value)
{
    put(m_values, key, value);
    m_changes[key] = std::move(value);
    saveSoon();
}

void SettingsFile::saveSoon()
{
    if (std::exchange(m_isSavingSoon, true))
        return;
    QTimer::singleShot(m_trouble.isEmpty() ? 0ms : std::chrono::milliseconds {retry}, this, [this] {
        m_isSavingSoon = false;
        save();
    });
}

void SettingsFile::save()
{
    if (m_underWay || m_changes.empty())
        return;
    m_underWay = std::exchange(m_changes, {});
    m_saving.setFuture(m_worker.run([path = m_path, changes = *m_underWay] { return onDisk::write(path, changes); }));
}

void SettingsFile::onSaved()
{
    const Written written = m_saving.result();
    if (!keepUnsaved())
        return fail(written.error().detail);
    m_values = written->values;
    for (const auto &[key, value] : m_changes)
        put(m_values, key, value);
    if (!written->notice.isEmpty())
        Q_EMIT noticed(written->notice);
    if (!std::exchange(m_trouble, {}).isEmpty())
        Q_EMIT recovered();
    if (m_changes.empty())
        Q_EMIT saved();
    else
        saveSoon();
}

void SettingsFile::fail(const QString &why)
{
    const QString reason = tr("Settings cannot be saved: %1. Work goes on; it is tried again.").arg(why);
    if (std::exchange(m_trouble, reason) != reason)
        Q_EMIT failed(reason);
    saveSoon();
}

} // namespace settings
