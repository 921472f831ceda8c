// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "inform/statement.h"

/// The cross reference of one line (reference §7).
namespace inform {

enum class Access : quint8 {
    Reads,
    Writes,
    Calls, ///< CALL: it comes back.
    JumpsTo, ///< JUMP JOB: it does not.
    Starts, ///< PSTART
    Macro, ///< MACRO1, MACRO2: MACRO.DAT names the job.
};

/// One thing that a line has to do with.
struct Reference {
    Access access = Access::Reads;
    QByteArray name; ///< "B012", "LD001", "$RV", "P010", "IN#(9)", "UF#(3)", "C00002", "alarm 8021"; a job's name; the
                     ///< type alone of "any".
    bool isAny = false; ///< Some of the type `name`: which one is known when it runs.
    bool isLocal = false; ///< A local variable: it belongs to this job alone.
    QByteArray element = {}; ///< "3" of "P021 (3)": only this one.

    bool operator==(const Reference &) const = default;
};

/// What the line with a controller's number reads, writes, calls. Empty for COMM lines, comments and labels; EDTLCK
/// lines count. PX stands for P, BP and EX as the job's groups have them; CLEAR names each variable that it writes.
/// Every reference once, in the order of the line.
[[nodiscard]] QList<Reference> references(const Job &job, int number);

/// The label a line jumps to is in the job, or "any" of them (JUMP LABEL: with a variable).
struct LabelUse {
    QByteArray label; ///< Without its star; empty if a variable says it.
};
[[nodiscard]] QList<LabelUse> labelUses(const Statement &statement);

} // namespace inform
