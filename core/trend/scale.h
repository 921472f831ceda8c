// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "trend/decimate.h"

namespace trend {

/// The largest of 1, 2, 5 times a power of ten that is not above `length`; 1 for a length that is not above 0.
[[nodiscard]] double roundLength(double length);

/// An axis with round numbers: from a multiple of the step to another.
struct Scale {
    double lowest = 0;
    double highest = 1;
    double step = 0.5;

    [[nodiscard]] int ticks() const { return int(std::lround((highest - lowest) / step)) + 1; }
    bool operator==(const Scale &) const = default;
};

/// The narrowest such axis around `extent` with three to seven ticks; one that shows a constant has it inside. An empty
/// extent gives 0 to 1.
[[nodiscard]] Scale scaleFor(const Extent &extent);
/// `current` as long as `extent` lies in it and fills a third of it; else a new one. So an axis does not jump with
/// every sample.
[[nodiscard]] Scale kept(const Scale &current, const Extent &extent);

} // namespace trend
