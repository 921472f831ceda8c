// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "trend/decimate.h"

#include <algorithm>

namespace trend {

namespace {

using namespace std::chrono_literals;

/// The lowest and the highest sample of one column so far.
class Column
{
public:
    void take(const Sample &sample)
    {
        if (m_isEmpty || sample.value < m_lowest.value)
            m_lowest = sample;
        if (m_isEmpty || sample.value > m_highest.value)
            m_highest = sample;
        m_isEmpty = false;
    }
    void flushTo(std::vector<Sample> &out)
    {
        if (m_isEmpty)
            return;
        out.push_back(m_lowest.at <= m_highest.at ? m_lowest : m_highest);
        if (m_lowest.at != m_highest.at)
            out.push_back(m_lowest.at <= m_highest.at ? m_highest : m_lowest);
        m_isEmpty = true;
    }

private:
    Sample m_lowest;
    Sample m_highest;
    bool m_isEmpty = true;
};

} // namespace

std::vector<Sample> decimate(const Series &series, const Range &range, int columns)
{
    const auto view = series.around(range);
    const auto width = std::max((range.to - range.from) / std::max(columns, 1), std::chrono::milliseconds {1});
    std::vector<Sample> result;
    result.reserve(std::min(view.size(), std::size_t(std::max(columns, 1)) * 2 + 4));
    Column column;
    auto current = std::numeric_limits<std::int64_t>::min();
    for (const Sample &sample : view) {
        const auto index = sample.at.time_since_epoch() / width;
        if (sample.isGap() || index != current)
            column.flushTo(result);
        current = index;
        if (sample.isGap())
            result.push_back(sample);
        else
            column.take(sample);
    }
    column.flushTo(result);
    return result;
}

void Extent::include(double value)
{
    if (!std::isfinite(value))
        return;
    lowest = std::min(lowest, value);
    highest = std::max(highest, value);
}

Extent extentOf(std::span<const Sample> samples)
{
    Extent extent;
    for (const Sample &sample : samples)
        extent.include(sample.value);
    return extent;
}

} // namespace trend
