// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "files/inform.h"
#include "files/noise.h"
#include "protocol/text.h"
#include <QList>

namespace files {

enum class EditKind {
    HeaderChanged, ///< `subject` says which: "name", "comment", "attributes", "groups".
    PositionAdded,
    PositionRemoved,
    PositionMoved, ///< See `shifts`.
    PositionRetyped, ///< Another type, tool or user frame.
    OperandChanged, ///< `subject` is the operand: "V", "VJ", "T"; empty if it has no name.
    LineChanged,
    LineAdded,
    LineRemoved,
};

/// How far one axis of a position moved.
struct Shift {
    int axis = 0; ///< From 0.
    double amount = 0; ///< In pulses, mm or degrees: see JobEdit::isPulse and the axis.

    bool operator==(const Shift &) const = default;
};

/// One difference between two versions of a job.
struct JobEdit {
    EditKind kind = EditKind::LineChanged;
    QByteArray subject; ///< The position or the operand.
    int line = -1; ///< The controller's line number: in the newer job, or in the older one if it is removed.
    QByteArray older;
    QByteArray newer;
    bool isPulse = false;
    QList<Shift> shifts = {};

    bool operator==(const JobEdit &) const = default;
};

/// What was done to make `newer` of `older`, header first, then positions, then lines.
[[nodiscard]] QList<JobEdit> diffJobs(const Job &older, const Job &newer, const NoiseFilter &noise);

/// "P012 moved 3.2 mm in Z", "V 100 → 150 at line 14"
[[nodiscard]] QString explain(const JobEdit &edit, const protocol::TextCodec &codec);

} // namespace files
