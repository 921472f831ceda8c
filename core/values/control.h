// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "values/error.h"
#include "values/job.h"

namespace values {

/// The word of 0x82, 0x83 and 0x86 (reference §6): 1 is on or do, 2 is off.
struct ControlWord {
    quint32 value = 1;

    bool operator==(const ControlWord &) const = default;
};

/// What the start button does next (reference §6, 0x84).
enum class CycleMode : quint32 { Step = 1, OneCycle = 2, Continuous = 3 };

struct CycleSelection {
    CycleMode mode = CycleMode::Step;

    bool operator==(const CycleSelection &) const = default;
};

/// A message for the pendant (reference §6, 0x85): 30 half-width characters in a field of 32 bytes.
struct PendantText {
    static constexpr qsizetype maxBytes = 30;
    FixedText<32> text; ///< In the pendant's encoding.

    /// BadInput if `bytes` is longer than 30.
    static Result<PendantText> create(QByteArrayView bytes)
    {
        if (bytes.size() > maxBytes)
            return badInput(QStringLiteral("a pendant message has at most 30 bytes"));
        return PendantText {FixedText<32> {bytes}};
    }
    bool operator==(const PendantText &) const = default;
};

/// The job to execute next, or a master job (reference §6.1).
struct JobSelection {
    JobName job;
    quint32 line = 0; ///< 0 to 9999; 0 is the top. Without meaning for master jobs.

    bool operator==(const JobSelection &) const = default;
};

/// What a job is selected as: the instance of 0x87.
struct JobTarget {
    quint16 instance = 1;

    static constexpr JobTarget toExecute() { return {1}; }
    /// `task` 0 is the master task, 1.. the sub tasks.
    static constexpr JobTarget masterOf(int task) { return {quint16(10 + task)}; }
    bool operator==(const JobTarget &) const = default;
};

} // namespace values
