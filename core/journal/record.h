// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "values/alarm.h"
#include <QDateTime>
#include <QString>
#include <chrono>

namespace journal {

/// How a try ended. "Failed" is not among them: what was not answered may have happened.
enum class Outcome {
    Done, ///< The controller accepted it.
    Refused, ///< The controller refused it; see OrderRecord::reply.
    Unknown, ///< Sent once and not answered.
    Withheld, ///< A condition was not met, so nothing was sent.
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

} // namespace journal
