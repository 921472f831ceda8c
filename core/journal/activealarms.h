// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "journal/record.h"
#include <QList>

namespace journal {

/// The active alarms of one controller, with first seen, count and acknowledgement, made from what its four slots hold
/// (reference §3.1). A pure value: the clock is a parameter, and what must be kept is returned.
///
/// An alarm has cleared when all slots are empty, or when it was in none of them twice in a row (the list moves while
/// it is read). With all slots full nothing is known of an alarm that is in none of them: it is left as it was.
class ActiveAlarms
{
public:
    static constexpr qsizetype mostListed = 200; ///< Beyond this the oldest leave the list, cleared ones first.
    static constexpr qsizetype mostRemembered = 5000; ///< Alarms whose first seen and count go on when they come again.

    struct Entry {
        Sighting sighting;
        bool isInSlot = true; ///< Read in the last round.
        int misses = 0;
    };
    struct Changes {
        QList<Sighting> came; ///< Newly active, or active again.
        QList<Sighting> toKeep; ///< Whatever the store should have, `came` included.
    };

    explicit ActiveAlarms(QString controller) : m_controller {std::move(controller)} { }

    /// What the store kept of this controller. What has come meanwhile counts on from there.
    void restore(const QList<Sighting> &kept);
    /// A round over all slots, the newest first, empty ones included. `now` is UTC.
    Changes take(const QList<values::AlarmWithTexts> &slotValues, const QDateTime &now);
    /// A person has seen these alarms (only `alarm` is looked at).
    Changes acknowledge(const QList<values::AlarmWithTexts> &alarms);

    /// Active alarms and those that cleared unacknowledged; the newest first.
    [[nodiscard]] const QList<Entry> &entries() const { return m_entries; }

private:
    Entry *find(const values::AlarmWithTexts &alarm);
    void see(const values::AlarmWithTexts &alarm, const QDateTime &now, Changes &changes);
    void come(Sighting sighting, const values::AlarmWithTexts &alarm, const QDateTime &now, Changes &changes);
    void miss(Entry &entry, bool isCertain, Changes &changes);
    void remember(const Sighting &sighting);
    void tidy();

    QString m_controller;
    QList<Entry> m_entries;
    QList<Sighting> m_past; ///< Cleared, the one that was seen last at the end.
};

/// Known as the same alarm: equal code and sub code.
[[nodiscard]] bool isSameAlarm(const values::AlarmWithTexts &a, const values::AlarmWithTexts &b);

} // namespace journal
