// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "values/position.h"
#include <optional>

namespace trend {

/// The lowest and the highest word of each axis since clear().
class Extremes
{
public:
    struct Bounds {
        qint32 lowest = 0;
        qint32 highest = 0;

        bool operator==(const Bounds &) const = default;
    };

    void include(const values::AxisWords &axes)
    {
        for (int axis = 0; axis < axes.count(); ++axis) {
            auto &bounds = m_bounds[std::size_t(axis)];
            const qint32 word = axes[axis];
            bounds =
                bounds ? Bounds {std::min(bounds->lowest, word), std::max(bounds->highest, word)} : Bounds {word, word};
        }
    }
    void clear() { m_bounds = {}; }
    /// nullopt for an axis that was never included. `axis` is 0 to 7.
    [[nodiscard]] const std::optional<Bounds> &operator[](int axis) const { return m_bounds[std::size_t(axis)]; }

private:
    std::array<std::optional<Bounds>, values::maxAxes> m_bounds;
};

} // namespace trend
