// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "inform/lines.h"
#include "inform/token.h"
#include <QByteArrayList>
#include <array>
#include <optional>
#include <span>

/// A job (JBI file) as it stands: bytes → lines → tokens → Job (reference §1 to §5). Nothing is lost and nothing is
/// refused: print() gives the bytes back, what is not understood is LineKind::Foreign or TokenKind::Unknown. Whether a
/// controller takes it is what check() says (check.h), what its instructions mean is in statement.h.
namespace inform {

enum class LineKind : quint8 {
    Blank,
    Header, ///< A pseudo instruction: it begins with a slash.
    Entry, ///< A position, "C00000=1,2,3".
    Declaration, ///< A line of //ALIAS or //ARGINFO.
    Label,
    Comment,
    Instruction,
    Foreign, ///< Anything else, such as text before /JOB.
};

enum class Section : quint8 { None, Job, Positions, Names, Arguments, Instructions };

struct Line {
    LineKind kind = LineKind::Foreign;
    Section section = Section::None;
    QByteArrayView text; ///< Without its ending, blanks in front and behind included.
    QByteArrayView ending;
    int firstToken = 0;
    int tokenCount = 0; ///< 0 for lines that are no labels, comments or instructions.
};

/// C, BC, EC, P, BP, EX: the order of ///NPOS and of the entries (reference §2.2, §3.1).
inline constexpr std::array<const char *, 6> pointKinds {"C", "BC", "EC", "P", "BP", "EX"};
using PointCounts = std::array<int, pointKinds.size()>;
/// LB, LI, LD, LR, LS, LP, LBP, LEX: the order of ///LVARS and ///GVARS.
inline constexpr std::array<const char *, 8> localKinds {"LB", "LI", "LD", "LR", "LS", "LP", "LBP", "LEX"};
using LocalCounts = std::array<int, localKinds.size()>;

/// A position of //POS with what held for it (reference §3).
struct Point {
    QByteArrayView name; ///< "C00012", "P00012"
    QByteArrayView kind; ///< "C", "BC", "EC", "P", "BP", "EX"
    int number = 0;
    QByteArrayView type; ///< As ///POSTYPE says: "PULSE", "BASE", "ROBOT", "USER", "TOOL", "MTOOL", "ANGLE".
    QByteArrayView tool; ///< As written after ///TOOL; empty if it was not said.
    QByteArrayView user; ///< As written after ///USER; empty unless the type is USER.
    QByteArrayView form; ///< As written after ///RCONF; empty unless it is a Cartesian position.
    bool isBeyondLimit = false; ///< ///LIMIT ON
    QByteArrayView layout; ///< "PULSE", "RECTAN" or "ANGLE": the line of that name before it; empty without one.
    QByteArrayView values; ///< As written, commas between.
    int line = 0; ///< Index in Job::lines.

    [[nodiscard]] bool isPulse() const { return type == "PULSE"; }
    [[nodiscard]] bool isAngle() const { return type == "ANGLE"; }
    [[nodiscard]] bool isCartesian() const { return !isPulse() && !isAngle(); }
    /// C and P are positions of a robot, the others of a base or a station.
    [[nodiscard]] bool isOfRobot() const { return kind == "C" || kind == "P"; }
    /// C, BC and EC belong to this job, P, BP and EX are variables of the controller.
    [[nodiscard]] bool isTaught() const { return kind.endsWith('C'); }
    /// In the unit of `type`: pulses; mm and degrees; degrees. nullopt if one of them is no number.
    [[nodiscard]] std::optional<QList<double>> numbers() const;
};

/// A name of //ALIAS.
struct Alias {
    QByteArray variable; ///< "D012", "LI000"
    QByteArray name;

    bool operator==(const Alias &) const = default;
};

/// An argument that the job takes, of //ARGINFO.
struct Argument {
    QByteArray type; ///< "D"; empty if it is not used.
    QByteArray comment;

    bool operator==(const Argument &) const = default;
};

/// A place in the instructions with a name.
struct Mark {
    QByteArray name; ///< A label without its star, or the job that is called.
    int line = 0; ///< The controller's line number.

    bool operator==(const Mark &) const = default;
};

/// All views and tokens point into `text`, whose bytes never change; a Job may be copied and moved.
/// Lines are counted in two ways: an index in `lines` is a line of the file, and the controller's line number, NOP
/// being 0, is an index in `instructions` (reference §4).
struct Job {
    QByteArray text;
    std::vector<Line> lines;
    std::vector<Token> tokens;
    std::vector<Point> points; ///< In the order of the file.
    std::vector<int> instructions; ///< By the controller's line number: the index in `lines`. Blank lines do not count.

    QHash<quint64, int> pointIndexes; ///< For point(): the first one with a name.

    bool isJob = false; ///< It begins with /JOB.
    int jobs = 0; ///< How many /JOB lines there are; only the first job is read.
    QByteArray name;
    QByteArray folder;
    QByteArray comment;
    QByteArray date; ///< "2026/01/31 08:30"
    QByteArrayList attributes; ///< "SC", "RW"
    QByteArray frame; ///< "USER 3" of a relative job.
    QList<QByteArrayList>
        groups; ///< ///GROUP1, ///GROUP2 …: {"RB1", "ST1"}. An empty one for a number that is missing.
    std::optional<PointCounts>
        announced; ///< ///NPOS; old jobs have four numbers. nullopt if it is missing or unreadable.
    LocalCounts locals {}; ///< ///LVARS
    QList<Alias> aliasList;
    Aliases aliases;
    QList<Argument> arguments; ///< Eight, or none.

    /// How many lines a controller counts: the last one is lineCount() - 1.
    [[nodiscard]] int lineCount() const { return int(instructions.size()); }
    /// The line with a controller's number, which must exist.
    [[nodiscard]] const Line &at(int number) const { return lines[std::size_t(instructions[std::size_t(number)])]; }
    /// Its text without the blanks around it.
    [[nodiscard]] QByteArrayView instruction(int number) const { return withoutBlanks(at(number).text); }
    [[nodiscard]] std::span<const Token> tokensOf(const Line &line) const;
    /// The instruction's word at a controller's line number, prefixes left out; empty for comments and labels.
    [[nodiscard]] QByteArrayView word(int number) const;
    /// EDTLCK or COMM stands before it.
    [[nodiscard]] bool isCommentedOut(int number) const;
    [[nodiscard]] bool isLocked(int number) const;
    [[nodiscard]] QList<Mark> labels() const;
    /// Where CALL, JUMP and PSTART name another job; COMM lines are left out.
    [[nodiscard]] QList<Mark> calls() const;
    /// How many steps there are up to and with a controller's line number (reference §4).
    [[nodiscard]] int stepAt(int number) const;
    [[nodiscard]] int steps() const { return stepAt(lineCount() - 1); }
    /// The position that is named so, "P005" being the same as "P00005"; nullptr if the job has none.
    [[nodiscard]] const Point *point(QByteArrayView entry) const;
    [[nodiscard]] PointCounts counted() const;
};

/// What pointIndexes has for an entry.
[[nodiscard]] quint64 pointId(const PointName &name);
/// Never fails; any bytes will do.
[[nodiscard]] Job parse(const QByteArray &text);
[[nodiscard]] QByteArray print(const Job &job);

/// 1 to 32 bytes without blanks and the characters that a job name may not have (reference §2.2, §8). Double-byte
/// characters are taken as a whole.
[[nodiscard]] bool isJobName(QByteArrayView name);

} // namespace inform
