// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "settings/accesssettings.h"

#include "settings/settingsfile.h"
#include <QPasswordDigestor>
#include <QRandomGenerator>
#include <array>

namespace settings {

namespace {

constexpr int firstIterations = 20'000; ///< Of a passcode that is kept without a number.
constexpr int mostIterations = 10'000'000; ///< A damaged number must not keep the worker for hours.
constexpr quint64 hashSize = 32;
constexpr std::chrono::minutes leastIdle {1};
constexpr std::chrono::minutes mostIdle {480};

QByteArray hashOf(const QString &text, const QByteArray &salt, int iterations)
{
    return QPasswordDigestor::deriveKeyPbkdf2(QCryptographicHash::Sha256, text.toUtf8(), salt, iterations, hashSize);
}

/// In a time that does not say where they differ.
bool isSame(const QByteArray &a, const QByteArray &b)
{
    if (a.size() != b.size())
        return false;
    uchar difference = 0;
    for (qsizetype i = 0; i < a.size(); ++i)
        difference |= uchar(a[i] ^ b[i]);
    return difference == 0;
}

QString idleKey() { return QStringLiteral("access/idleMinutes"); }
QString saltKey() { return QStringLiteral("access/passcodeSalt"); }
QString hashKey() { return QStringLiteral("access/passcodeHash"); }
QString iterationsKey() { return QStringLiteral("access/passcodeIterations"); }

QByteArray bytes(const SettingsFile &settings, const QString &key)
{
    return QByteArray::fromHex(settings.value(key).toString().toLatin1());
}

} // namespace

Passcode Passcode::of(const QString &text, int iterations)
{
    std::array<quint32, 4> random {};
    QRandomGenerator::system()->generate(random.begin(), random.end());
    const QByteArray salt {reinterpret_cast<const char *>(random.data()), sizeof random};
    return {salt, hashOf(text, salt, iterations), iterations};
}

bool Passcode::matches(const QString &text) const
{
    return quint64(hash.size()) == hashSize && isSame(hashOf(text, salt, iterations), hash);
}

AccessSettings readAccess(const SettingsFile &settings)
{
    AccessSettings access;
    const std::chrono::minutes idle {settings.value(idleKey()).toInt()};
    if (idle >= leastIdle && idle <= mostIdle)
        access.idleTime = idle;
    if (settings.contains(hashKey())) {
        const int iterations = settings.value(iterationsKey()).toInt(firstIterations);
        access.passcode = Passcode {
            bytes(settings, saltKey()), bytes(settings, hashKey()), std::clamp(iterations, 1, mostIterations)};
    }
    return access;
}

void writeAccess(SettingsFile &settings, const AccessSettings &access)
{
    settings.setValue(idleKey(), int(access.idleTime.count()));
    if (!access.passcode) {
        for (const QString &key : {saltKey(), hashKey(), iterationsKey()})
            settings.remove(key);
        return;
    }
    settings.setValue(saltKey(), QString::fromLatin1(access.passcode->salt.toHex()));
    settings.setValue(hashKey(), QString::fromLatin1(access.passcode->hash.toHex()));
    settings.setValue(iterationsKey(), access.passcode->iterations);
}

} // namespace settings
