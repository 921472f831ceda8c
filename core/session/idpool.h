// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "session/policy.h"
#include <QtGlobal>
#include <algorithm>
#include <deque>
#include <optional>

namespace session {

/// The 256 request ids (reference §1.1): each new request takes the one that is free for longest. A reply names nothing
/// but its id and a service, so an id is not given out again while an answer to its last request, or a second copy of
/// that answer, could still come.
class IdPool
{
public:
    /// So many ids are left to stops, which wait for nothing and must not take another's answer for theirs.
    static constexpr std::size_t keptForStops = 8;

    /// So many requests a second can leave for ever, if an id rests for `linger`. Who asks faster stands still until
    /// ids are free again.
    [[nodiscard]] static constexpr int lastingPace(Milliseconds linger)
    {
        return int(Milliseconds {std::chrono::seconds {256 - keptForStops}} / linger);
    }

    /// The first id should be random: a controller may still answer a program that ended a moment ago.
    explicit IdPool(quint8 first)
    {
        for (int i = 0; i < 256; ++i)
            m_free.push_back(quint8(first + i));
    }

    /// The id that has rested longest; nullopt while all but those for stops are in use or resting.
    [[nodiscard]] std::optional<quint8> take(Time now)
    {
        wake(now);
        return m_free.size() > keptForStops ? std::optional {takeFirst()} : std::nullopt;
    }

    /// For a stop: any free id, and if there is none, the one that has rested longest. nullopt if all are in use.
    [[nodiscard]] std::optional<quint8> takeForStop(Time now)
    {
        wake(now);
        if (m_free.empty() && !m_resting.empty())
            wakeFirst();
        return m_free.empty() ? std::nullopt : std::optional {takeFirst()};
    }

    /// The request with this id is over; until `until` an answer to it may still come.
    void rest(quint8 id, Time until)
    {
        const auto at = std::ranges::upper_bound(m_resting, until, {}, &Resting::until);
        m_resting.insert(at, {id, until});
    }

    /// When take() has an id: `now`, or later if too many are in use or resting.
    [[nodiscard]] Time nextFree(Time now) const
    {
        if (m_free.size() > keptForStops)
            return now;
        const std::size_t missing = keptForStops - m_free.size();
        return missing < m_resting.size() ? std::max(now, m_resting[missing].until) : Time::max();
    }

private:
    struct Resting {
        quint8 id;
        Time until;
    };

    quint8 takeFirst()
    {
        const quint8 id = m_free.front();
        m_free.pop_front();
        return id;
    }
    void wakeFirst()
    {
        m_free.push_back(m_resting.front().id);
        m_resting.pop_front();
    }
    void wake(Time now)
    {
        while (!m_resting.empty() && m_resting.front().until <= now)
            wakeFirst();
    }

    std::deque<quint8> m_free;
    std::deque<Resting> m_resting; // in the order of `until`
};

} // namespace session
