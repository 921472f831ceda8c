// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include <QByteArray>
#include <QString>
#include <chrono>
#include <optional>

namespace settings {

class SettingsFile;

/// A passcode as it is kept: salted and hashed (PBKDF2 with SHA-256). It guards against mistakes, not against
/// attackers: whoever can change this user's files can change it.
struct Passcode {
    static constexpr int iterationsToday = 600'000;

    QByteArray salt;
    QByteArray hash;
    int iterations = iterationsToday;

    /// With a salt of its own. Takes the better part of a second: for a worker.
    [[nodiscard]] static Passcode of(const QString &text, int iterations = iterationsToday);
    /// Takes as long, whether it matches or not.
    [[nodiscard]] bool matches(const QString &text) const;
    /// It was made when fewer iterations were enough, and is to be made anew when it is next entered.
    [[nodiscard]] bool isOutdated() const { return iterations < iterationsToday; }
    bool operator==(const Passcode &) const = default;
};

/// How the access levels are entered and left.
struct AccessSettings {
    std::chrono::minutes idleTime {10}; ///< Until the level falls back to Monitor; 1 to 480.
    std::optional<Passcode> passcode; ///< None: the levels are entered without.

    bool operator==(const AccessSettings &) const = default;
};

/// What is not there, or not a number in range, is as in a new AccessSettings; a damaged passcode matches nothing.
[[nodiscard]] AccessSettings readAccess(const SettingsFile &settings);
void writeAccess(SettingsFile &settings, const AccessSettings &access);

} // namespace settings
