// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "inform/job.h"

namespace inform {

enum class AxisUnit : quint8 { Pulse, Millimetre, Degree };

/// How far one axis of a position moved.
struct Shift {
    int axis = 0; ///< From 0.
    double amount = 0;
    AxisUnit unit = AxisUnit::Pulse;

    bool operator==(const Shift &) const = default;
};

/// Something in the older job and in the newer one.
struct Versions {
    QByteArray older;
    QByteArray newer;

    [[nodiscard]] bool isChanged() const { return older != newer; }
    bool operator==(const Versions &) const = default;
};

/// How one position differs in two versions of a job (reference §10.4).
struct PointChange {
    bool isOfRobot = true; ///< Axes have names: S L U R B T E, or X Y Z Rx Ry Rz Re.
    Versions type; ///< "PULSE", "BASE" …
    Versions tool;
    Versions user;
    QList<int> form; ///< The fields of RCONF that differ, from 1; positive if it is 1 now, negative if it was.
    Versions limit; ///< "ON", "OFF"
    Versions values; ///< As written, where `shifts` cannot say it: another type or user frame, another number of axes.
    QList<Shift> shifts;
    double distance = 0; ///< In mm, over X, Y and Z of a Cartesian position.
    double angle = 0; ///< In degrees, of the shortest turn from one posture to the other.

    [[nodiscard]] bool isEmpty() const;
    bool operator==(const PointChange &) const = default;
};

/// nullopt if they are the same position.
[[nodiscard]] std::optional<PointChange> diffPoints(const Point &older, const Point &newer);

} // namespace inform
