// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "settings/accesssettings.h"

#include <QPasswordDigestor>
#include <QRandomGenerator>
#include <QSettings>
#include <array>

namespace settings {

namespace {

constexpr int iterations = 20'000;
constexpr quint64 hashSize = 32;
constexpr std::chrono::minutes leastIdle {1};
constexpr std::chrono::minutes mostIdle {480};

QByteArray hashOf(const QString &text, const QByteArray &salt)
{
    return QPasswordDigestor::deriveKeyPbkdf2(QCryptographicHash::Sha256, text.toUtf8(), salt, iterations, hashSize);
}

QString idleKey() { return QStringLiteral("access/idleMinutes"); }
QString saltKey() { return QStringLiteral("access/passcodeSalt"); }
QString hashKey() { return QStringLiteral("access/passcodeHash"); }

QByteArray bytes(const QSettings &settings, const QString &key)
{
    return QByteArray::fromHex(settings.value(key).toByteArray());
}

} // namespace

Passcode Passcode::of(const QString &text)
{
    std::array<quint32, 4> random {};
    QRandomGenerator::system()->generate(random.begin(), random.end());
    const QByteArray salt {reinterpret_cast<const char *>(random.data()), sizeof random};
    return {salt, hashOf(text, salt)};
}

bool Passcode::matches(const QString &text) const { return !hash.isEmpty() && hashOf(text, salt) == hash; }

AccessSettings readAccess(const QSettings &settings)
{
    AccessSettings access;
    const std::chrono::minutes idle {settings.value(idleKey()).toInt()};
    if (idle >= leastIdle && idle <= mostIdle)
        access.idleTime = idle;
    if (settings.contains(hashKey()))
        access.passcode = Passcode {bytes(settings, saltKey()), bytes(settings, hashKey())};
    return access;
}

void writeAccess(QSettings &settings, const AccessSettings &access)
{
    settings.setValue(idleKey(), int(access.idleTime.count()));
    settings.remove(saltKey());
    settings.remove(hashKey());
    if (!access.passcode)
        return;
    settings.setValue(saltKey(), access.passcode->salt.toHex());
    settings.setValue(hashKey(), access.passcode->hash.toHex());
}

} // namespace settings
