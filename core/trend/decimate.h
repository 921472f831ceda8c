// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "trend/series.h"
#include <vector>

namespace trend {

/// What a line of `columns` pixels over `range` needs to look as if every sample were drawn: the lowest and the highest
/// sample of each column, in the order of time, and every gap. At most two samples a column and three more a gap.
/// Columns are counted from the epoch, not from the edge, so that a picture that wanders does not flicker. The cost
/// grows with the samples in sight and with nothing else. `columns` under 1 counts as 1.
[[nodiscard]] std::vector<Sample> decimate(const Series &series, const Range &range, int columns);

/// The lowest and the highest value of some samples.
struct Extent {
    double lowest = std::numeric_limits<double>::infinity();
    double highest = -std::numeric_limits<double>::infinity();

    [[nodiscard]] bool isEmpty() const { return lowest > highest; }
    /// What is no number changes nothing.
    void include(double value);
    bool operator==(const Extent &) const = default;
};
[[nodiscard]] Extent extentOf(std::span<const Sample> samples);

} // namespace trend
