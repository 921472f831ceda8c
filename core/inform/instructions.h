// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include <QByteArrayView>
#include <span>

/// The one table of INFORM's instructions (reference §6): compare, pre-flight, cross reference, waiting, highlighting,
/// teaching and execution read it. A word that is not in it is unknown, and no error by itself: application options
/// add many words.
namespace inform {

enum class Group : quint8 { Move, InputOutput, Control, Operating, Shift, Process };

/// What a line can last for (reference §8).
enum class Wait : quint8 {
    No,
    Motion, ///< The robot's move.
    MotionEnd, ///< CWAIT: the move before it.
    Time, ///< TIMER, DELAY.
    Condition, ///< WAIT: a comparison, a time, or both.
    Callee, ///< The job that was called.
    Task, ///< PWAIT: the end of a sub task.
    Tasks, ///< TSYNC: the other tasks.
    Person, ///< PAUSE, INPUT: somebody presses or types something.
    Process, ///< An answer of the process: arc, weld timer, tool, sensor, conveyor.
};

/// Its place in IFTHEN … ENDIF, WHILE … ENDWHILE, FOR … NEXT, SWITCH … ENDSWITCH.
enum class Block : quint8 { None, Opens, Divides, Closes };
enum class Structure : quint8 { None, If, While, For, Switch };

/// The oldest controllers that have the word (reference §13).
enum class Generation : quint8 { Nx100, Dx100, Dx200, Yrc1000 };

/// One row.
struct Instruction {
    const char *word;
    Group group;
    /// What is done to the operands without a tag, in their order and without words such as ON or LOW: `r` reads,
    /// `w` writes, `m` reads and writes, `-` neither; `*` repeats the one before it for all that follow. Tagged
    /// operands and conditions are read. What is missing here is read.
    const char *operands = "";
    Wait wait = Wait::No;
    Block block = Block::None;
    Structure structure = Structure::None;
    bool isStep = false; ///< Counts as a step of the job (reference §4).
    bool ownsPoints = false; ///< Its C, BC and EC points belong to it alone (reference §3.1).
    /// What it reads and writes besides, by blanks; # is the number of its first operand: "$PX01#", "alarm_#".
    const char *alsoReads = "";
    const char *alsoWrites = "";
    Generation since = Generation::Nx100;
};

[[nodiscard]] std::span<const Instruction> instructions();
/// nullptr for a word that is not in the table. Words are upper case.
[[nodiscard]] const Instruction *findInstruction(QByteArrayView word);

/// A tag of an operand, "VJ" of "VJ=50.00" (reference §5.3).
struct Tag {
    const char *name;
    const char *unit; ///< "%", "mm/s", "s"; empty if it has none.
    double least = 0; ///< least and most are equal where no range is known.
    double most = 0;
};
/// nullptr for a tag without a known unit or range.
[[nodiscard]] const Tag *findTag(QByteArrayView name);

/// Words between operands that begin a condition: IF, IFEXPRESS, ANDIF, ORIF, ANDEXP, OREXP, FOREXPRESS, UNTIL, SRCH
/// and its variants (reference §5.3, §5.4).
[[nodiscard]] bool beginsCondition(QByteArrayView keyword);

} // namespace inform
