// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include <chrono>
#include <cmath>
#include <deque>
#include <limits>
#include <optional>
#include <span>

namespace trend {

/// A moment by this computer's clock, UTC.
using Moment = std::chrono::sys_time<std::chrono::milliseconds>;

/// From..to, both included.
struct Range {
    Moment from;
    Moment to;

    [[nodiscard]] bool contains(Moment at) const { return at >= from && at <= to; }
    bool operator==(const Range &) const = default;
};

/// What a signal was at a moment; or that from then on nothing is known of it.
struct Sample {
    Moment at;
    double value = 0;

    [[nodiscard]] static Sample gap(Moment at) { return {at, std::numeric_limits<double>::quiet_NaN()}; }
    /// Until the next sample nothing is known. A value that is no number says the same.
    [[nodiscard]] bool isGap() const { return !std::isfinite(value); }
    /// Gaps are equal to gaps.
    friend bool operator==(const Sample &a, const Sample &b)
    {
        return a.at == b.at && (a.value == b.value || (a.isGap() && b.isGap()));
    }
};

/// The latest samples of one signal in the order of time. It never holds more than its capacity, and a gap in it is
/// never closed.
class Series
{
public:
    using Samples = std::deque<Sample>;
    /// Samples one after another; good until the series changes.
    struct View {
        Samples::const_iterator first;
        Samples::const_iterator last;

        [[nodiscard]] auto begin() const { return first; }
        [[nodiscard]] auto end() const { return last; }
        [[nodiscard]] std::size_t size() const { return std::size_t(last - first); }
        [[nodiscard]] bool isEmpty() const { return first == last; }
    };

    /// `capacity` is at least 2. The oldest samples make room for new ones.
    explicit Series(std::size_t capacity) : m_capacity {capacity} { }

    /// What is newly said counts: samples at `at` or later are dropped, so that setting the clock back never mixes the
    /// order.
    void append(Moment at, double value);
    /// The same, but a value that stays takes two samples only: the first and the last that said so. Drawn as a line it
    /// looks the same.
    void extend(Moment at, double value);
    /// From `at` on nothing is known. Saying so again adds nothing.
    void breakOff(Moment at);
    /// Drops what was before `moment`.
    void forgetBefore(Moment moment);
    void clear() { m_samples.clear(); }

    [[nodiscard]] bool isEmpty() const { return m_samples.empty(); }
    [[nodiscard]] std::size_t count() const { return m_samples.size(); }
    [[nodiscard]] const Sample &back() const { return m_samples.back(); }
    [[nodiscard]] const Samples &samples() const { return m_samples; }
    /// The samples within `range`.
    [[nodiscard]] View within(const Range &range) const;
    /// The same with the nearest ones outside, so that a line reaches both edges.
    [[nodiscard]] View around(const Range &range) const;
    /// The last sample at `at` or before; nullptr if there is none or a gap lies there.
    [[nodiscard]] const Sample *valueAt(Moment at) const;
    /// The value at a moment between two samples that are equal; nullopt elsewhere.
    [[nodiscard]] std::optional<double> heldAt(Moment at) const;

private:
    void put(const Sample &sample);

    std::size_t m_capacity;
    Samples m_samples;
};

} // namespace trend
