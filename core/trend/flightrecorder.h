// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "trend/incident.h"
#include <map>
#include <optional>

namespace trend {

/// The last five minutes of whatever it is told. An alarm edge keeps a minute before and twenty seconds after it as an
/// incident. Pure: time is a parameter, and it goes forward.
class FlightRecorder
{
public:
    static constexpr std::chrono::minutes span {5};
    static constexpr std::chrono::seconds before {60};
    static constexpr std::chrono::seconds after {20};
    /// Room for five minutes at the fastest pace, 10 Hz, and some more.
    static constexpr std::size_t capacity = 3200;

    void take(const Signal &signal, const Quantity &quantity, Moment at);
    /// From `at` on nothing is known of the signals of this topic.
    void breakOff(robot::Topic topic, Moment at);
    void note(Moment at, const QString &text);
    /// An alarm edge. One that comes while another is being kept belongs to the same incident, which then lasts until
    /// twenty seconds after this one; five minutes after its beginning at the latest.
    void trigger(Moment at, const QString &text);
    /// What it was turns out later: the title of the incident that is being kept.
    void setTitle(const QString &title);
    /// Ends what is due; call it a few times a second. An incident is told once, with labels that count the axes and
    /// without the controller's name. Signals of which nothing is known in that time are left out.
    [[nodiscard]] std::optional<Incident> tick(Moment now);
    /// Ends the incident that is being kept before its time: the program closes.
    [[nodiscard]] std::optional<Incident> finish(Moment now);
    [[nodiscard]] bool isKeeping() const { return m_edge.has_value(); }
    /// Of the incident that is being kept.
    [[nodiscard]] const std::optional<Moment> &edge() const { return m_edge; }

private:
    [[nodiscard]] Incident cut(const Range &range) const;

    std::map<Signal, Track> m_tracks;
    QList<Note> m_notes;
    std::optional<Moment> m_edge;
    QString m_title;
    Moment m_due {}; ///< When it is over.
};

} // namespace trend
