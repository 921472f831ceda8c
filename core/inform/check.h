// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "inform/job.h"
#include <QString>
#include <functional>

/// What is found in a file before it is sent to a controller (reference §10.1).
namespace inform {

enum class Fault {
    // The file as a whole; files::preflight() finds these.
    Empty,
    NotLoadable, ///< No type that a controller takes; `detail` is the type.
    LowerCaseType,
    NameDiffers, ///< The header names another job than the file; `detail` is that name.
    Running,
    ReplacesNames,
    // The text.
    ByteOrderMark,
    Utf16,
    CarriageReturns, ///< Lines end in CR alone.
    LineFeeds, ///< Lines of a job end in LF alone.
    LineFeedsInData, ///< Those of another file.
    NoLastLineEnd,
    ControlZ, ///< The end-of-file mark of old systems.
    ControlCharacter,
    // The header.
    NotAJob,
    SeveralJobs,
    BadName, ///< `detail` is the name.
    StrayText, ///< Text that belongs to no section.
    UnknownHeader, ///< `detail` is the pseudo instruction.
    LongJobComment,
    FrameWithoutRelative, ///< A frame, and the attribute RJ is missing.
    RelativeWithoutFrame,
    // The positions.
    NoPointCount,
    WrongPointCount, ///< `detail`: "C 3 2", the kind, what ///NPOS says, what there is.
    NoPosition, ///< Text in //POS.
    PointTwice,
    PointUnused,
    PointUndefined,
    PointShared, ///< Two places name it.
    WrongAxisCount, ///< `detail`: name and number of values.
    BadValue,
    WrongLayout, ///< ///PULSE, ///RECTAN or ///ANGLE does not fit ///POSTYPE.
    PulseInRelativeJob,
    NoGroup, ///< Points, and no control group.
    GroupLacksAxes, ///< Points of a base or station, and no group has one.
    // The instructions.
    NoNop,
    NoEnd,
    EndInside,
    NoInstruction, ///< A line that begins with no word: an instruction cut in two.
    UnknownWord,
    UnknownCharacters,
    BlankLine,
    TooManyLines,
    LongText, ///< A comment or message.
    LongLabel,
    LabelTwice,
    NoLabel,
    NotClosed, ///< `detail` is the word that opens.
    NotOpened,
    TooDeep,
    OutOfRange, ///< `detail` is the operand.
    TooManyArguments,
    LocalBeyond, ///< A local variable beyond ///LVARS.
};

struct Finding {
    Fault fault;
    int fileLine = 0; ///< From 1, as an editor counts; 0: the file as a whole.
    int jobLine = -1; ///< The controller's line number, NOP being 0; -1 outside of the instructions.
    QByteArray detail = {}; ///< In the pendant's encoding.

    /// The controller refuses such a file, must not get it now, or stops when it executes the line. All else may well
    /// do.
    [[nodiscard]] bool isError() const;
    bool operator==(const Finding &) const = default;
};

/// Everything that is wrong or odd with a job, in the order of the file. A fault that every line would have is found
/// once.
[[nodiscard]] QList<Finding> check(const Job &job);

/// The part of it that holds for every text file.
[[nodiscard]] QList<Finding> checkText(const Job &job);

/// What it is, in a sentence with the line.
[[nodiscard]] QString explain(const Finding &finding, const std::function<QString(QByteArrayView)> &decode);
/// What comes of it: the likely answer of the controller, or what to think of. Never empty.
[[nodiscard]] QString reason(const Finding &finding);

} // namespace inform
