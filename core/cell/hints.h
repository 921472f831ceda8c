// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "cell/calltree.h"

namespace cell {

/// Something in the files that is worth a look. It is never an error by itself, and nothing is ever changed for it.
struct Hint {
    enum class Kind : quint8 {
        MissingJob, ///< A line leads into a job that no file has.
        SeveralWriters, ///< An output that the ladder and a job, several instructions or several jobs write.
        NeverWritten, ///< A B, I, D, R or S that lines read and nothing in the files writes.
        SeveralNames, ///< A variable with more than one name.
        ToolNotEntered, ///< Positions use a tool that nobody has entered.
        UnusedJob, ///< No job and no macro names it.
    };

    Kind kind = Kind::MissingJob;
    Subject subject;
    QList<Place> places; ///< Where to look, in order.

    bool operator==(const Hint &) const = default;
};

/// In the order of Hint::Kind. Files that are missing give no hints: without MACRO.DAT a job that only a macro runs is
/// among the unused ones, so those are left out where lines use macros and MACRO.DAT is not there.
[[nodiscard]] QList<Hint> hintsOf(const Cell &cell, const CrossReference &uses, const CallTree &calls);

} // namespace cell
