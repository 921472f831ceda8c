// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "session/policy.h"
#include <QtGlobal>
#include <array>
#include <deque>
#include <optional>

namespace session {

/// The 256 request ids (reference §1.1): each new request takes the next one. An id is not given out again while an
/// answer to its last request could still come.
class IdPool
{
public:
    /// The first id should be random: a controller may still answer a program that ended a moment ago.
    explicit IdPool(quint8 first)
    {
        for (int i = 0; i < 256; ++i)
            m_free.push_back(quint8(first + i));
    }

    /// The id that has rested longest; nullopt while all are in use or resting.
    [[nodiscard]] std::optional<quint8> take(Time now)
    {
        wake(now);
        if (m_free.empty())
            return std::nullopt;
        const quint8 id = m_free.front();
        m_free.pop_front();
        return id;
    }

    /// As take(), but for a stop, which waits for nothing: the id that has rested longest even if its rest is not over.
    [[nodiscard]] std::optional<quint8> takeAnyway(Time now)
    {
        if (auto id = take(now); id || m_resting.empty())
            return id;
        const quint8 id = m_resting.front().id;
        m_resting.pop_front();
        return id;
    }

    /// Every try of the id was answered: it may be used again when its turn comes.
    void giveBack(quint8 id) { m_free.push_back(id); }
    /// A try of the id was not answered: it rests until `until`.
    void rest(quint8 id, Time until) { m_resting.push_back({id, until}); }
    /// When an id can be taken: `now`, or later if all others are in use or resting.
    [[nodiscard]] Time nextFree(Time now) const
    {
        if (!m_free.empty())
            return now;
        return m_resting.empty() ? Time::max() : std::max(now, m_resting.front().until);
    }

private:
    struct Resting {
        quint8 id;
        Time until;
    };

    void wake(Time now)
    {
        while (!m_resting.empty() && m_resting.front().until <= now) {
            m_free.push_back(m_resting.front().id);
            m_resting.pop_front();
        }
    }

    std::deque<quint8> m_free;
    std::deque<Resting> m_resting; // in the order of `until`, since the rest is always equally long
};

} // namespace session
