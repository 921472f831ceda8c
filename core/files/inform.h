// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include <QByteArrayList>
#include <QByteArrayView>
#include <optional>

namespace files {

enum class LineKind {
    Blank,
    Header, ///< A pseudo instruction: it begins with a slash.
    Position, ///< C00000=…
    Label, ///< *NAME
    Comment, ///< 'TEXT
    Instruction,
    Foreign, ///< Anything else, such as text before the first section.
};

/// One line of a file as it stands there.
struct Line {
    LineKind kind = LineKind::Foreign;
    QByteArray text; ///< Without its ending; in the pendant's encoding.
    QByteArray ending; ///< "\r\n" or "\n"; empty for the last line of a file that does not end in one.

    bool operator==(const Line &) const = default;
};

/// The lines of any text, kind Foreign. Joined again they are the same bytes, whatever those are.
[[nodiscard]] QList<Line> splitLines(QByteArrayView content);
[[nodiscard]] QByteArray joinLines(const QList<Line> &lines);

/// A position as a job carries it.
struct TaughtPosition {
    QByteArray name; ///< "C00012", "P012"
    QByteArray type; ///< As ///POSTYPE says: "PULSE", "BASE", "ROBOT", "TOOL", "USER", "MTOOL".
    QByteArray tool; ///< As written after ///TOOL and ///USER; empty if it was not said.
    QByteArray userFrame;
    QByteArrayList values; ///< As written: pulses; or mm for the first three and degrees for the others.
    int line = 0; ///< Index in Job::lines.

    [[nodiscard]] bool isPulse() const { return type == "PULSE"; }
    bool operator==(const TaughtPosition &) const = default;
};

/// A place in the instructions with a name.
struct Mark {
    QByteArray name; ///< A label without its star, or the job that is called.
    int number = 0; ///< The controller's line number.

    bool operator==(const Mark &) const = default;
};

/// The text of a job (JBI file) taken apart, nothing lost: print() gives the bytes back. What is not INFORM is kept as
/// it is and means nothing (reference §7.8).
struct Job {
    QList<Line> lines;
    bool isJob = false; ///< It begins with /JOB.
    QByteArray name;
    QByteArray comment;
    QByteArray date; ///< "2026/01/31 08:30"
    QByteArrayList attributes; ///< "SC", "RW"
    QByteArrayList groups; ///< "RB1"
    std::optional<int> announcedPositions; ///< The sum of ///NPOS; empty if it is missing or no list of numbers.
    QList<TaughtPosition> positions;
    QList<int> instructions; ///< By the controller's line number, NOP being 0: the index in `lines`.

    /// The text at a controller's line number, without blanks around it.
    [[nodiscard]] QByteArray instruction(int number) const;
    [[nodiscard]] QList<Mark> labels() const;
    /// CALL, JUMP or PSTART of another job.
    [[nodiscard]] QList<Mark> calls() const;
};

[[nodiscard]] Job parseJob(QByteArrayView content);
[[nodiscard]] QByteArray print(const Job &job);

/// 1 to 32 bytes that a job name may have (reference §8).
[[nodiscard]] bool isJobName(QByteArrayView name);

} // namespace files
