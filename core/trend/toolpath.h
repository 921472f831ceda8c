// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "trend/series.h"
#include "values/position.h"
#include <array>

namespace trend {

/// A place of the tool point in the base frame.
struct PathPoint {
    std::array<double, 3> mm {}; ///< X Y Z
    bool isApart = false; ///< Nothing is known of the way to here from the point before.

    bool operator==(const PathPoint &) const = default;
};

/// The way of a tool point: what was read, and no point between. A robot that stands adds nothing.
class ToolPath
{
public:
    static constexpr std::size_t capacity = 6000; ///< Ten minutes of motion at 10 Hz; the oldest go first.
    static constexpr double leastStep = 0.05; ///< Millimetres; nearer points add nothing but the present place.

    /// Positions that are not in the base frame are none of its business.
    void append(const values::Position &position);
    /// What comes next is not joined to what was.
    void breakOff() { m_isApart = true; }
    void clear();

    [[nodiscard]] bool isEmpty() const { return m_points.empty(); }
    /// In the order of time. The last one is where the tool point was read last.
    [[nodiscard]] const std::deque<PathPoint> &points() const { return m_points; }

private:
    std::deque<PathPoint> m_points;
    PathPoint m_anchor; ///< The last point that stays.
    bool m_isApart = true;
    bool m_isLastPassing = false; ///< The last point is the present place only and gives way to the next.
};

} // namespace trend
