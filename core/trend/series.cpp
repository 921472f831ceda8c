// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "trend/series.h"

#include <algorithm>

namespace trend {

void Series::put(const Sample &sample)
{
    while (!m_samples.empty() && m_samples.back().at >= sample.at)
        m_samples.pop_back();
    m_samples.push_back(sample);
    if (m_samples.size() > m_capacity)
        m_samples.pop_front();
}

void Series::append(Moment at, double value) { put({at, value}); }

void Series::extend(Moment at, double value)
{
    const auto count = m_samples.size();
    if (count >= 2 && m_samples[count - 1].value == value && m_samples[count - 2].value == value)
        m_samples.pop_back();
    put({at, value});
}

void Series::breakOff(Moment at)
{
    if (m_samples.empty() || m_samples.back().isGap())
        return;
    put(Sample::gap(std::max(at, m_samples.back().at + std::chrono::milliseconds {1})));
}

void Series::forgetBefore(Moment moment)
{
    const auto first = std::ranges::lower_bound(m_samples, moment, {}, &Sample::at);
    m_samples.erase(m_samples.begin(), first);
}

Series::View Series::within(const Range &range) const
{
    const auto first = std::ranges::lower_bound(m_samples, range.from, {}, &Sample::at);
    return {first, std::ranges::upper_bound(first, m_samples.end(), range.to, {}, &Sample::at)};
}

Series::View Series::around(const Range &range) const
{
    auto [first, last] = within(range);
    return {first == m_samples.begin() ? first : first - 1, last == m_samples.end() ? last : last + 1};
}

std::optional<double> Series::heldAt(Moment at) const
{
    const auto after = std::ranges::upper_bound(m_samples, at, {}, &Sample::at);
    if (after == m_samples.begin() || after == m_samples.end() || std::prev(after)->value != after->value)
        return std::nullopt;
    return after->value;
}

const Sample *Series::valueAt(Moment at) const
{
    const auto after = std::ranges::upper_bound(m_samples, at, {}, &Sample::at);
    if (after == m_samples.begin() || std::prev(after)->isGap())
        return nullptr;
    return &*std::prev(after);
}

} // namespace trend
