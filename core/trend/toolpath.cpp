// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "trend/toolpath.h"

namespace trend {

namespace {

double distance(const PathPoint &a, const PathPoint &b)
{
    return std::hypot(a.mm[0] - b.mm[0], a.mm[1] - b.mm[1], a.mm[2] - b.mm[2]);
}

} // namespace

void ToolPath::append(const values::Position &position)
{
    if (position.type != values::PositionType::Base || position.axes.count() < 3)
        return;
    PathPoint point {{position.axes[0] / 1e3, position.axes[1] / 1e3, position.axes[2] / 1e3}, m_isApart};
    if (m_isLastPassing && !point.isApart)
        m_points.pop_back();
    m_isLastPassing = !point.isApart && distance(point, m_anchor) < leastStep;
    if (m_isLastPassing && point.mm == m_anchor.mm) {
        m_isLastPassing = false;
        return;
    }
    if (!m_isLastPassing)
        m_anchor = point;
    m_points.push_back(point);
    if (m_points.size() > capacity)
        m_points.pop_front();
    m_isApart = false;
}

void ToolPath::clear()
{
    m_points.clear();
    m_isApart = true;
    m_isLastPassing = false;
}

} // namespace trend
