// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "cell/subject.h"
#include "protocol/dialect.h"
#include <chrono>
#include <functional>

/// What the line that runs waits for (INFORM reference §8). Pure: values are asked of whoever reads them, and what
/// cannot be read stays unknown.
namespace cell {

/// One side of a comparison.
struct Side {
    enum class Kind : quint8 {
        Constant, ///< `value`; ON is 1, OFF is 0.
        Live, ///< A variable, a signal, or a group of signals.
        Indirect, ///< `index` says which one: read it first.
        Local, ///< A local variable: HSES cannot read it.
        Text, ///< A string, or an S variable: not judged.
        Unknown,
    };

    Kind kind = Kind::Unknown;
    QByteArray written; ///< As in the job: "IN#(5)".
    double value = 0;
    QList<Subject> subjects {}; ///< Of Live: one variable or register, or the signals of a group, lowest bit first.
    std::optional<Subject> index {}; ///< Of Indirect; nullopt if a local variable says it.
    QByteArray type {}; ///< Of Indirect: "IN#", "B".

    bool operator==(const Side &) const = default;
};

struct Comparison {
    bool isAlternative = false; ///< OREXP or ORIF stands before it; AND binds first (INFORM reference §5.4).
    Side left;
    inform::Relation relation = inform::Relation::Equal;
    Side right;
};

struct Waiting {
    inform::Wait wait = inform::Wait::No;
    std::vector<Comparison> comparisons; ///< Of WAIT, and of UNTIL in a move.
    /// After which it goes on all the same, or which it lasts; nullopt if no time is given, or `timeVariable` says it.
    std::optional<std::chrono::milliseconds> time;
    std::optional<Subject> timeVariable; ///< In units of `timeUnit`.
    std::chrono::milliseconds timeUnit {10};
    int number = 0; ///< Of the sub task of PWAIT, or of the point where the tasks meet (TSYNC).

    [[nodiscard]] bool isWaiting() const { return wait != inform::Wait::No; }
};

/// What the line with a controller's number waits for, if it lasts.
[[nodiscard]] Waiting waitingAt(const inform::Job &job, int line, protocol::Model model);

/// The last value read of a variable, register or signal (0 or 1); nullopt if it was not read or is old.
using ValueOf = std::function<std::optional<double>(const Subject &)>;

/// The subject that an indirect side names at the moment; nullopt if its index was not read.
[[nodiscard]] QList<Subject> resolved(const Side &side, const ValueOf &valueOf);
[[nodiscard]] std::optional<double> valueOf(const Side &side, const ValueOf &valueOf);
/// nullopt if a side is not known.
[[nodiscard]] std::optional<bool> holds(const Comparison &comparison, const ValueOf &valueOf);
/// All comparisons together; nullopt if those that are not known decide it.
[[nodiscard]] std::optional<bool> holds(const std::vector<Comparison> &comparisons, const ValueOf &valueOf);
/// What must be read to judge them, each once; indices first.
[[nodiscard]] QList<Subject> neededFor(const Waiting &waiting, const ValueOf &valueOf);

} // namespace cell
