// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "settings/appearance.h"
#include "settings/notes.h"
#include "settings/profile.h"
#include "values/error.h"
#include <QJsonObject>
#include <QList>
#include <optional>

namespace settings {

class SettingsFile;

/// A profile as JSON and back, with a sentence for the first value that is missing or out of range.
[[nodiscard]] QJsonObject toJson(const Profile &profile);
[[nodiscard]] values::Result<Profile> profileFromJson(const QJsonObject &json);

/// What is wrong with a profile, as a translated sentence; empty if nothing is.
[[nodiscard]] QString complaint(const Profile &profile);

/// A controller of the list "recent".
struct RecentProfile {
    Profile profile;
    QDateTime connected; ///< When it answered last, UTC; invalid: never, or nobody wrote it down.
};

/// The controllers that this user knows, kept in the settings file.
class ProfileStore
{
public:
    /// `settings` must outlive the store. Profiles, notes and memories that still go by a name get an id, and lose
    /// nothing by it.
    explicit ProfileStore(SettingsFile &settings);

    /// In the order of their names; an entry that cannot be read is left out and left alone.
    [[nodiscard]] QList<Profile> profiles() const;
    [[nodiscard]] std::optional<Profile> find(const QString &name) const;
    [[nodiscard]] std::optional<Profile> find(const QUuid &id) const;
    /// Replaces the profile of the same id, or of the same name if it has none, else adds it. Another name is a change
    /// of label and nothing more: the name before is remembered. What was saved, with its id.
    Profile save(const Profile &profile);
    void remove(const QString &name);

    /// The profile that was connected last; empty if none.
    [[nodiscard]] QString lastUsed() const;
    void setLastUsed(const QString &name);

    /// At most `most`, the one that answered last first; those that never did come after it, by their names.
    [[nodiscard]] QList<RecentProfile> recent(int most) const;
    /// The profile's controller answered. A profile that is not in the store leaves no trace.
    void noteConnected(const QString &name, const QDateTime &at);
    /// The readiness of the profile's controller was shown once.
    [[nodiscard]] bool isReadinessSeen(const QString &name) const;
    void setReadinessSeen(const QString &name);

    /// Ids of the pages that had windows of their own; they come back after a restart.
    [[nodiscard]] QStringList pagesInWindows() const;
    void setPagesInWindows(const QStringList &ids);

    [[nodiscard]] Appearance appearance() const;
    void setAppearance(const Appearance &appearance);

    /// Ids of the stations that were open; they are opened again after a restart if somebody wants that.
    [[nodiscard]] QList<QUuid> openStations() const;
    void setOpenStations(const QList<QUuid> &ids);

    /// What people keep about that controller.
    [[nodiscard]] Notes notes(const Profile &profile) const { return {m_settings, keyOf(profile)}; }
    [[nodiscard]] Notes notes(const QString &name) const;

private:
    /// What is kept about a profile goes by it: its id, or the name of one that was never stored.
    [[nodiscard]] static QString keyOf(const Profile &profile);
    [[nodiscard]] QString freeFolder(const Profile &profile) const;
    void takeOver(const QString &key);
    void move(const QString &from, const QString &to);

    SettingsFile &m_settings;
};

} // namespace settings
