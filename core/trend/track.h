// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "trend/series.h"
#include "trend/signal.h"

namespace trend {

/// One signal over time, with all it takes to draw it.
struct Track {
    Signal signal;
    QString label;
    Unit unit = Unit::Plain;
    Series series;

    /// A quantity of another unit begins anew: a P variable that was taught in pulses and now holds millimetres.
    void append(Moment at, const Quantity &quantity, void (Series::*put)(Moment, double) = &Series::append)
    {
        if (quantity.unit != unit)
            series.clear();
        unit = quantity.unit;
        (series.*put)(at, quantity.value);
    }
};

} // namespace trend
