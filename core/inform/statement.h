// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "inform/instructions.h"
#include "inform/job.h"

/// What one line of a job says, typed: for the cross reference, for what a line waits for, for teaching and execution.
namespace inform {

enum class TermKind : quint8 {
    None,
    Number, ///< `value`
    Text, ///< A string: `text` without its quotation marks.
    Keyword, ///< ON, OFF, INVERT, LOW, BF, SUB1, NWAIT: `text`.
    Variable, ///< Also $B002 and $RV: see `isSystem`. An alias is the variable behind it.
    Point, ///< C, BC, EC
    Signal, ///< IN, OT, OG …
    Numbered, ///< UF, TL, ASF, MJ, STEP, IARG …
    Label, ///< `text` without its star.
    Job, ///< `text` without JOB:
    Operator, ///< In expressions: + - * / ( )
    Unknown,
};

/// One value, place or name. Views point into the job.
struct Term {
    TermKind kind = TermKind::None;
    QByteArrayView written; ///< As in the line, such as the alias.
    QByteArrayView text; ///< See TermKind; otherwise as written.
    QByteArrayView type = {}; ///< "B", "PX" without L and $; "IN"; "UF"; "C".
    bool isLocal = false;
    bool isSystem = false;
    std::optional<int> number = {}; ///< 12 of B012, IN#(12), C00012. nullopt if `index` says it, and for $RV.
    QByteArrayView index = {}; ///< "I000" of B[I000] and IN#(I000); read it with termOf(). Empty if there is `number`.
    QByteArrayView element = {}; ///< "3" of "P001 (3)": a number, or a variable for termOf().
    double value = 0;

    /// It names some of its type: which one is known when it runs.
    [[nodiscard]] bool isIndirect() const { return !index.isEmpty(); }
};

enum class Relation : quint8 { Equal, Unequal, Less, LessOrEqual, Greater, GreaterOrEqual };

/// One comparison of a condition. ANDEXP binds before OREXP (reference §5.4).
struct Condition {
    QByteArrayView joiner; ///< "IF", "ANDEXP", "ORIF", "UNTIL" …; empty for the first of IFTHEN, WHILE and WAIT.
    Term left;
    Relation relation = Relation::Equal;
    Term right;
};

struct Operand {
    QByteArrayView tag; ///< "VJ" of VJ=50.00, "ARGF", "START", "TO", "LABEL"; empty without one.
    Term term;
};

/// One instruction. A line has more than one where further groups move with the first (reference §5).
struct Part {
    QByteArrayView word;
    const Instruction *row = nullptr; ///< nullptr: not in the table.
    std::vector<Operand> operands; ///< In the order of the line.
    std::vector<Condition> conditions;
    std::vector<Term> expression; ///< What follows EXPRESS, operators and brackets included.

    /// The n-th operand that has no tag and is no keyword, from 0; nullptr if there are fewer.
    [[nodiscard]] const Term *positional(int index) const;
    /// The value of a tag; nullptr without it.
    [[nodiscard]] const Term *tagged(QByteArrayView tag) const;
    /// A bare word such as NWAIT stands among the operands.
    [[nodiscard]] bool has(QByteArrayView keyword) const;
};

struct Statement {
    LineKind kind = LineKind::Instruction; ///< Or Label, Comment.
    bool isLocked = false; ///< EDTLCK: it is executed.
    bool isCommentedOut = false; ///< COMM: it is not executed and keeps its points.
    QByteArrayView label = {}; ///< Of a label line, without its star.
    QByteArrayView comment = {}; ///< Of a comment line, or the trailing comment, without ' and //.
    std::vector<Part> parts = {}; ///< Empty for comments and labels.

    [[nodiscard]] const Instruction *row() const { return parts.empty() ? nullptr : parts.front().row; }
};

/// The line with a controller's number.
[[nodiscard]] Statement statement(const Job &job, int number);
/// A single term: "B012", "LI000", "12", an alias.
[[nodiscard]] Term termOf(QByteArrayView text, const Aliases &aliases = {});

} // namespace inform
