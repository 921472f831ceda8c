// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "trend/flightrecorder.h"

#include <algorithm>

namespace trend {

namespace {

constexpr qsizetype mostNotes = 1000; ///< An alarm flood ends here, the oldest first.

} // namespace

void FlightRecorder::take(const Signal &signal, const Quantity &quantity, Moment at)
{
    auto found = m_tracks.find(signal);
    if (found == m_tracks.end())
        found = m_tracks.emplace(signal, Track {signal, label(signal), quantity.unit, Series {capacity}}).first;
    found->second.append(at, quantity, &Series::extend);
}

void FlightRecorder::breakOff(robot::Topic topic, Moment at)
{
    for (auto it = m_tracks.lower_bound({topic, 0}); it != m_tracks.end() && it->first.topic == topic; ++it)
        it->second.series.breakOff(at);
}

void FlightRecorder::note(Moment at, const QString &text)
{
    m_notes << Note {at, text};
    if (m_notes.size() > mostNotes)
        m_notes.removeFirst();
}

void FlightRecorder::trigger(Moment at, const QString &text)
{
    note(at, text);
    if (!m_edge) {
        m_edge = at;
        m_title = text;
    }
    m_due = std::min(at + after, *m_edge - before + span);
}

void FlightRecorder::setTitle(const QString &title) { m_title = title; }

std::optional<Incident> FlightRecorder::tick(Moment now)
{
    for (auto &[signal, track] : m_tracks)
        track.series.forgetBefore(now - span);
    m_notes.removeIf([&](const Note &note) { return note.at < now - span; });
    return m_edge && now >= m_due ? finish(now) : std::nullopt;
}

std::optional<Incident> FlightRecorder::finish(Moment now)
{
    if (!m_edge)
        return std::nullopt;
    Incident incident = cut({*m_edge - before, std::min(m_due, std::max(now, *m_edge))});
    m_edge.reset();
    return incident;
}

Incident FlightRecorder::cut(const Range &range) const
{
    Incident incident {{}, m_title, *m_edge, range, {}, {}};
    std::ranges::copy_if(
        m_notes, std::back_inserter(incident.notes), [&](const Note &note) { return range.contains(note.at); });
    for (const auto &[signal, track] : m_tracks) {
        Track kept {signal, track.label, track.unit, Series {capacity}};
        if (const auto held = track.series.heldAt(range.from))
            kept.series.append(range.from, *held);
        for (const Sample &sample : track.series.within(range))
            kept.series.append(sample.at, sample.value);
        if (const auto held = track.series.heldAt(range.to))
            kept.series.append(range.to, *held); // a value that stays is a line to the end
        if (!std::ranges::all_of(kept.series.samples(), &Sample::isGap))
            incident.tracks.push_back(std::move(kept));
    }
    return incident;
}

} // namespace trend
