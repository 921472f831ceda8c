// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "trend/track.h"
#include "values/error.h"
#include <QJsonObject>
#include <QList>

namespace trend {

/// Something that happened, in words: an alarm with its code, another job.
struct Note {
    Moment at;
    QString text;

    bool operator==(const Note &) const = default;
};

/// What was recorded around an alarm.
struct Incident {
    QString controller; ///< The profile's name.
    QString title; ///< What happened: "Alarm 4315 …".
    Moment at; ///< The alarm edge.
    Range range {};
    QList<Note> notes; ///< In the order of time.
    std::vector<Track> tracks;
};

/// As a file: times in UTC, samples as milliseconds after the edge and value, null for a gap.
[[nodiscard]] QJsonObject toJson(const Incident &incident);
/// BadInput says what is wrong with it. Tracks whose signal this version does not know are left out.
[[nodiscard]] values::Result<Incident> incidentFromJson(const QJsonObject &json);

} // namespace trend
