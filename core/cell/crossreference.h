// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "cell/cell.h"
#include "inform/references.h"

namespace cell {

enum class How : quint8 {
    Writes,
    Reads,
    Waits, ///< The line lasts until what it reads is so.
    Calls,
    JumpsTo,
    Starts, ///< As a task of its own.
    Names, ///< A file of names has it.
};

/// Where a thing is used.
struct Place {
    enum class Kind : quint8 { Job, Ladder, Macro, NameFile };

    Kind kind = Kind::Job;
    QByteArray name; ///< The job, or the file.
    int line = 0; ///< In a job the controller's line number, NOP being 0; elsewhere the line of the file, from 1.

    bool operator==(const Place &) const = default;
};

struct Use {
    How how = How::Reads;
    Place place;
    bool isMaybe = false; ///< Some of its kind is used: which one is known when the line runs.
    QByteArray through = {}; ///< As what it is used: "OG#(3)", "C00002", "BMOV"; empty if by its own name.
    QByteArray element = {}; ///< "3" of P021 (3).

    bool operator==(const Use &) const = default;
};

/// Where every thing of a cell is used (INFORM reference §7; ladder: controller files reference §8). A pure function
/// of the cell. COMM lines are no uses.
class CrossReference
{
public:
    CrossReference() = default;
    explicit CrossReference(const Cell &cell);

    /// Certain uses first, then those that may be; each in the order of jobs, ladder, names.
    [[nodiscard]] QList<Use> uses(const Subject &subject) const;
    /// Everything that is used for certain or has a name, in order.
    [[nodiscard]] QList<Subject> subjects() const;
    /// How often any of this kind is used indirectly, such as through P[I007].
    [[nodiscard]] qsizetype indirectUses(Subject::Kind kind) const;

private:
    struct AnyUse {
        AnyOf of;
        Use use;
    };

    void takeJob(const QByteArray &name, const inform::Job &job);
    void takeLine(const QByteArray &name, const inform::Job &job, int line);
    void takePoints(const QByteArray &name, const inform::Job &job, int line, const inform::Reference &reference);
    void takeLadder(const cellfiles::Ladder &ladder);
    void takeMacros(const QList<cellfiles::Macro> &macros);
    void takeNames(const Cell &cell);
    void add(const Subject &subject, const Use &use) { m_uses[subject].append(use); }

    std::map<Subject, QList<Use>> m_uses;
    QList<AnyUse> m_any;
};

} // namespace cell
