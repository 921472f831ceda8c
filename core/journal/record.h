// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "values/alarm.h"
#include <QDateTime>
#include <QList>
#include <QString>
#include <chrono>

namespace journal {

/// How a try ended. "Failed" is not among them: what was not answered may have happened.
enum class Outcome {
    Done, ///< The controller accepted it.
    Refused, ///< The controller refused it; see OrderRecord::reply.
    Unknown, ///< Sent once and not answered.
    Withheld, ///< A condition was not met, so nothing was sent.
    Cancelled, ///< The person cancelled it under way.
};

/// One try to change something at a controller. Everything is kept as it was at that moment and never edited.
struct OrderRecord {
    QDateTime at; ///< UTC, by this computer's clock, when it was tried.
    QString user; ///< Of this computer.
    QString host; ///< This computer.
    QString level; ///< Access level at that moment, untranslated: "Operate".
    QString controller; ///< Name of the profile.
    QString action; ///< Untranslated key of what was tried: "start", "write-register".
    QString subject; ///< What it was done to, as on the pendant: "M005", "#27010", "WELD_A12".
    QString oldValue; ///< As last read, empty if it was not.
    QString newValue;
    Outcome outcome = Outcome::Done;
    quint16 status = 0; ///< Status byte of a refusal.
    quint16 added = 0; ///< Added status of a refusal (reference §9).
    QString reply; ///< The reply, or the condition that withheld it, in plain English.
    std::chrono::milliseconds duration {0}; ///< From the try to its end.

    bool operator==(const OrderRecord &) const = default;
};

/// An alarm as the journal keeps it: what the controller told, and when this computer saw it.
struct AlarmRecord {
    QString controller; ///< Name of the profile.
    values::AlarmHistoryClass list = values::AlarmHistoryClass::Major;
    values::AlarmWithTexts alarm; ///< Bytes as received; the time in it is the controller's own.
    QDateTime seen; ///< UTC, by this computer's clock, when it was first read.

    bool operator==(const AlarmRecord &) const = default;
};

/// Where an active alarm stands with the people at this desk (ISA-18.2). The robot never hears of it.
enum class AlarmState {
    Unacknowledged, ///< Active, and nobody has said that they saw it.
    Acknowledged, ///< Active and seen by a person.
    ClearedUnacknowledged, ///< Gone before anybody said that they saw it.
    Cleared,
};

/// One alarm, known by its code and sub code, as it came and went among the active ones.
struct Sighting {
    QString controller; ///< Name of the profile.
    values::AlarmWithTexts alarm; ///< As last read; the time in it is the controller's own.
    QDateTime firstSeen; ///< UTC, by this computer's clock: when it was read for the first time ever.
    QDateTime lastSeen; ///< UTC, when it was last read.
    quint32 count = 1; ///< How often it came since `firstSeen`.
    AlarmState state = AlarmState::Unacknowledged;

    bool operator==(const Sighting &) const = default;
};

/// What the people of a plant know about an alarm code.
struct Note {
    quint32 code = 0;
    QString cause; ///< What it came from.
    QString remedy; ///< What was done.
    QString author;
    QDateTime changed; ///< UTC.

    /// A note without words is none.
    [[nodiscard]] bool isEmpty() const { return cause.isEmpty() && remedy.isEmpty(); }
    bool operator==(const Note &) const = default;
};

/// A list of past alarms as it was read from a controller, to be merged into the history; see history.h.
struct HistoryReading {
    QString controller; ///< Name of the profile.
    values::AlarmHistoryClass list = values::AlarmHistoryClass::Major;
    QList<values::AlarmWithTexts>
        entries; ///< The newest first, down to where isEnough() became true or the list ended.
    QDateTime seen; ///< UTC.
};

/// Untranslated names, as in exported files: "done"; "major", "user-system".
[[nodiscard]] const char *key(Outcome outcome);
[[nodiscard]] const char *key(values::AlarmHistoryClass list);

} // namespace journal
