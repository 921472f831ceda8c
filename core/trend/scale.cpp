// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "trend/scale.h"

#include <algorithm>

namespace trend {

double roundLength(double length)
{
    if (!(length > 0) || !std::isfinite(length))
        return 1;
    const double ten = std::pow(10, std::floor(std::log10(length)));
    for (const double factor : {5.0, 2.0}) {
        if (factor * ten <= length)
            return factor * ten;
    }
    return ten;
}

Scale scaleFor(const Extent &extent)
{
    if (extent.isEmpty())
        return {};
    // Below this a double has no digits left to tell the ticks apart.
    const double least = std::max({std::abs(extent.lowest), std::abs(extent.highest), 1.0}) * 1e-9;
    const double span = extent.highest - extent.lowest;
    const double step = roundLength(span > least ? span / 2 : 1);
    Scale scale {std::floor(extent.lowest / step) * step, std::ceil(extent.highest / step) * step, step};
    if (span <= least)
        scale = {scale.lowest - step, scale.lowest + step, step};
    return scale;
}

Scale kept(const Scale &current, const Extent &extent)
{
    const bool isInside = extent.lowest >= current.lowest && extent.highest <= current.highest;
    const bool fills = (extent.highest - extent.lowest) * 3 >= current.highest - current.lowest;
    const Scale fresh = scaleFor(extent);
    const bool isAsWide = fresh.highest - fresh.lowest >= current.highest - current.lowest;
    return extent.isEmpty() || (isInside && (fills || isAsWide)) ? current : fresh;
}

} // namespace trend
