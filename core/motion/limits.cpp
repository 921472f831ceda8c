// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "motion/limits.h"

#include <algorithm>
#include <cmath>

namespace motion {

namespace {

struct Row {
    const char *name;
    std::optional<double> Wishes::*wish;
    double Limits::*limit;
};
constexpr Row rows[] {
    {"tool speed", &Wishes::toolSpeed, &Limits::toolSpeed},
    {"rotation speed", &Wishes::rotationSpeed, &Limits::rotationSpeed},
    {"joint speed", &Wishes::jointSpeed, &Limits::jointSpeed},
    {"step length", &Wishes::stepLength, &Limits::stepLength},
    {"step angle", &Wishes::stepAngle, &Limits::stepAngle},
    {"step in pulses", &Wishes::stepPulses, &Limits::stepPulses},
};

tl::unexpected<values::Error> damaged(const char *name)
{
    return values::badInput(QStringLiteral("motion limit: %1").arg(QLatin1String(name)));
}

bool hasInside(const Box &box)
{
    for (std::size_t axis = 0; axis < 3; ++axis) {
        if (!std::isfinite(box.least[axis]) || !std::isfinite(box.most[axis]) || box.least[axis] >= box.most[axis])
            return false;
    }
    return true;
}

} // namespace

values::Result<Limits> limits(const Wishes &wishes)
{
    Limits result; // at the ceilings
    for (const Row &row : rows) {
        const std::optional<double> &wish = wishes.*row.wish;
        if (wish && !(*wish > 0))
            return damaged(row.name);
        if (wish)
            result.*row.limit = std::min(*wish, result.*row.limit);
    }
    if (wishes.box && !hasInside(*wishes.box))
        return damaged("box");
    result.box = wishes.box;
    result.areFramesChecked = wishes.areFramesChecked;
    return result;
}

} // namespace motion
