// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include <algorithm>
#include <chrono>

namespace session {

/// The wait before a read is repeated, from the round trips seen so far (RFC 6298). A lost packet on a link of 2 ms is
/// noticed after 20 ms instead of after the whole time-out.
class Retransmission
{
public:
    using Duration = std::chrono::microseconds;

    /// `ceiling` is the wait while nothing was measured, and the longest one ever; `floor` the shortest.
    explicit Retransmission(Duration ceiling, Duration floor = std::chrono::milliseconds {20})
        : m_ceiling {ceiling}, m_floor {floor}
    {
    }

    /// A round trip of a request that was sent once. A repeated one does not count: nobody knows which try was
    /// answered.
    void measure(Duration roundTrip)
    {
        if (!m_isMeasured) {
            m_smooth = roundTrip;
            m_variation = roundTrip / 2;
            m_isMeasured = true;
            return;
        }
        m_variation = (3 * m_variation + std::chrono::abs(m_smooth - roundTrip)) / 4;
        m_smooth = (7 * m_smooth + roundTrip) / 8;
    }

    /// The wait after try number `tries` (1 for the first): it doubles with each.
    [[nodiscard]] Duration wait(int tries) const
    {
        if (!m_isMeasured)
            return m_ceiling;
        const Duration first = std::max(m_floor, m_smooth + 4 * m_variation);
        return std::min(m_ceiling, first * (1 << std::min(tries - 1, 8)));
    }

private:
    Duration m_ceiling;
    Duration m_floor;
    Duration m_smooth {};
    Duration m_variation {};
    bool m_isMeasured = false;
};

} // namespace session
