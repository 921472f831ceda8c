// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "inform/check.h"

#include <QCoreApplication>
#include <algorithm>
#include <array>

namespace inform {

namespace {

struct CheckTexts {
    Q_DECLARE_TR_FUNCTIONS(inform::Check)
};

/// What a fault is and what comes of it. %1 is Finding::detail.
struct Row {
    Fault fault;
    bool isError;
    const char *what;
    const char *why;
};

constexpr std::array rows {
    Row {Fault::Empty, true, QT_TRANSLATE_NOOP("inform::Check", "The file is empty."),
        QT_TRANSLATE_NOOP("inform::Check", "HSES cannot carry it.")},
    Row {Fault::NotLoadable, true, QT_TRANSLATE_NOOP("inform::Check", "“%1” is no type of file that can be sent."),
        QT_TRANSLATE_NOOP("inform::Check", "Controllers take JBI, JBR, CND, DAT, PRM and LST.")},
    Row {Fault::LowerCaseType, false,
        QT_TRANSLATE_NOOP("inform::Check", "The type of the file is written in small letters."),
        QT_TRANSLATE_NOOP("inform::Check", "Controllers write it in capitals.")},
    Row {Fault::NameDiffers, true, QT_TRANSLATE_NOOP("inform::Check", "The header names the job “%1”."),
        QT_TRANSLATE_NOOP("inform::Check", "The name in the header counts: that job would be written.")},
    Row {Fault::Running, true, QT_TRANSLATE_NOOP("inform::Check", "The job is being executed."),
        QT_TRANSLATE_NOOP("inform::Check", "A running job cannot be replaced.")},
    Row {Fault::ReplacesNames, false,
        QT_TRANSLATE_NOOP("inform::Check", "All names in the controller become those in this file."),
        QT_TRANSLATE_NOOP("inform::Check", "Back them up first.")},
    Row {Fault::ByteOrderMark, true, QT_TRANSLATE_NOOP("inform::Check", "The file begins with a byte order mark."),
        QT_TRANSLATE_NOOP("inform::Check", "Controllers know no such mark: save the file without it.")},
    Row {Fault::Utf16, true, QT_TRANSLATE_NOOP("inform::Check", "The file is UTF-16 text."),
        QT_TRANSLATE_NOOP("inform::Check", "Controllers take one byte for a letter.")},
    Row {Fault::CarriageReturns, true, QT_TRANSLATE_NOOP("inform::Check", "The lines end in CR alone."),
        QT_TRANSLATE_NOOP(
            "inform::Check", "Lines end in CR LF; the controller finds neither NOP nor END (pendant 3200).")},
    Row {Fault::LineFeeds, true, QT_TRANSLATE_NOOP("inform::Check", "Lines end in LF alone."),
        QT_TRANSLATE_NOOP(
            "inform::Check", "Lines end in CR LF; the controller finds neither NOP nor END (0x5130, pendant 3200).")},
    Row {Fault::LineFeedsInData, false, QT_TRANSLATE_NOOP("inform::Check", "Lines end in LF alone."),
        QT_TRANSLATE_NOOP("inform::Check", "Lines end in CR LF; a controller may read such a file as empty.")},
    Row {Fault::NoLastLineEnd, false, QT_TRANSLATE_NOOP("inform::Check", "The last line does not end."),
        QT_TRANSLATE_NOOP("inform::Check", "Controllers end each line in CR LF.")},
    Row {Fault::ControlZ, true, QT_TRANSLATE_NOOP("inform::Check", "There is a Ctrl-Z at the end."),
        QT_TRANSLATE_NOOP("inform::Check", "It stands behind END, which must be last (0x5130).")},
    Row {Fault::ControlCharacter, true, QT_TRANSLATE_NOOP("inform::Check", "There is a control character."),
        QT_TRANSLATE_NOOP("inform::Check", "No line of a job may have one.")},
    Row {Fault::NotAJob, true, QT_TRANSLATE_NOOP("inform::Check", "This is no job: it does not have the line /JOB."),
        QT_TRANSLATE_NOOP("inform::Check", "A job begins with it (0x5310).")},
    Row {Fault::SeveralJobs, false, QT_TRANSLATE_NOOP("inform::Check", "The file holds more than one job."),
        QT_TRANSLATE_NOOP("inform::Check", "Only the first one was looked at.")},
    Row {Fault::BadName, true, QT_TRANSLATE_NOOP("inform::Check", "“%1” is no name for a job."),
        QT_TRANSLATE_NOOP("inform::Check",
            "A name has 1 to 32 bytes, no blanks and none of the signs that names of files may not have (0x4190).")},
    Row {Fault::StrayText, true, QT_TRANSLATE_NOOP("inform::Check", "There is text that belongs to no section."),
        QT_TRANSLATE_NOOP("inform::Check", "It is no INFORM (0x5310).")},
    Row {Fault::UnknownHeader, false, QT_TRANSLATE_NOOP("inform::Check", "%1 is no known pseudo instruction."),
        QT_TRANSLATE_NOOP("inform::Check", "A controller that does not know it refuses the file (0x5340).")},
    Row {Fault::LongJobComment, false,
        QT_TRANSLATE_NOOP("inform::Check", "The comment of the job is longer than 32 bytes."),
        QT_TRANSLATE_NOOP("inform::Check", "Controllers cut it or refuse it.")},
    Row {Fault::FrameWithoutRelative, false,
        QT_TRANSLATE_NOOP("inform::Check", "A frame is given, and the attribute RJ is missing."),
        QT_TRANSLATE_NOOP("inform::Check", "Only relative jobs have a frame (0x4490).")},
    Row {Fault::RelativeWithoutFrame, false,
        QT_TRANSLATE_NOOP("inform::Check", "The job is relative, and no frame is given."),
        QT_TRANSLATE_NOOP("inform::Check", "A relative job names its frame (0x3390).")},
    Row {Fault::NoPointCount, true,
        QT_TRANSLATE_NOOP("inform::Check", "There are positions, and no ///NPOS that counts them."),
        QT_TRANSLATE_NOOP("inform::Check", "The controller compares them (0x5180).")},
    Row {Fault::WrongPointCount, true,
        QT_TRANSLATE_NOOP(
            "inform::Check", "///NPOS does not count the positions of each kind: %1 (kind, said, found)."),
        QT_TRANSLATE_NOOP("inform::Check", "The controller compares them (0x5180).")},
    Row {Fault::NoPosition, true, QT_TRANSLATE_NOOP("inform::Check", "There is text among the positions that is none."),
        QT_TRANSLATE_NOOP("inform::Check", "Every line of //POS is a position or a pseudo instruction (0x5120).")},
    Row {Fault::PointTwice, true, QT_TRANSLATE_NOOP("inform::Check", "%1 is there twice."),
        QT_TRANSLATE_NOOP("inform::Check", "Each position has one entry (0x5120).")},
    Row {Fault::PointUnused, true, QT_TRANSLATE_NOOP("inform::Check", "%1 is named by no line."),
        QT_TRANSLATE_NOOP("inform::Check", "Each taught point belongs to one instruction (pendant 3190).")},
    Row {Fault::PointUndefined, true, QT_TRANSLATE_NOOP("inform::Check", "%1 has no entry among the positions."),
        QT_TRANSLATE_NOOP("inform::Check", "The robot would not know where to go (0x4130).")},
    Row {Fault::PointShared, false, QT_TRANSLATE_NOOP("inform::Check", "%1 is named in two places."),
        QT_TRANSLATE_NOOP("inform::Check", "Controllers give each place a point of its own.")},
    Row {Fault::WrongAxisCount, true,
        QT_TRANSLATE_NOOP("inform::Check", "The number of values does not fit the axes: %1 (position, values)."),
        QT_TRANSLATE_NOOP("inform::Check", "A robot has 6 or 7 axes, a base 1 to 3, a station 1 to 6 (0x5180).")},
    Row {Fault::BadValue, true, QT_TRANSLATE_NOOP("inform::Check", "%1 has a value that is no number."),
        QT_TRANSLATE_NOOP("inform::Check", "The controller cannot read it (0x5120).")},
    Row {Fault::WrongLayout, false,
        QT_TRANSLATE_NOOP(
            "inform::Check", "The line ///PULSE, ///RECTAN or ///ANGLE before %1 does not fit its ///POSTYPE."),
        QT_TRANSLATE_NOOP(
            "inform::Check", "PULSE goes with ///PULSE, ANGLE with ///ANGLE, the others with ///RECTAN (0x5120).")},
    Row {Fault::PulseInRelativeJob, false,
        QT_TRANSLATE_NOOP("inform::Check", "%1 is in pulses, and the job is relative."),
        QT_TRANSLATE_NOOP("inform::Check", "The points of a relative job stand in its frame.")},
    Row {Fault::NoGroup, true,
        QT_TRANSLATE_NOOP("inform::Check", "There are taught points (%1), and the job has no control group."),
        QT_TRANSLATE_NOOP("inform::Check", "A job without a group cannot move (0x5430).")},
    Row {Fault::GroupLacksAxes, true,
        QT_TRANSLATE_NOOP("inform::Check", "There are %1 points, and no control group of the job has such axes."),
        QT_TRANSLATE_NOOP("inform::Check", "C needs a robot, BC a base, EC a station among the groups (0x3370).")},
    Row {Fault::NoNop, true, QT_TRANSLATE_NOOP("inform::Check", "The first instruction is not NOP."),
        QT_TRANSLATE_NOOP("inform::Check", "Every job begins with NOP (0x5130, pendant 3200).")},
    Row {Fault::NoEnd, true, QT_TRANSLATE_NOOP("inform::Check", "The last instruction is not END."),
        QT_TRANSLATE_NOOP("inform::Check", "Every job ends with END (0x5130, pendant 3200).")},
    Row {Fault::EndInside, true, QT_TRANSLATE_NOOP("inform::Check", "There is an END before the last line."),
        QT_TRANSLATE_NOOP("inform::Check", "What follows it is no job (0x5130).")},
    Row {Fault::NoInstruction, true, QT_TRANSLATE_NOOP("inform::Check", "The line begins with no instruction."),
        QT_TRANSLATE_NOOP("inform::Check", "An instruction was cut in two: it belongs to the line before (0x5110).")},
    Row {Fault::UnknownWord, false, QT_TRANSLATE_NOOP("inform::Check", "%1 is no instruction that this program knows."),
        QT_TRANSLATE_NOOP(
            "inform::Check", "It may belong to an option; a controller without it refuses the job (0x5110).")},
    Row {Fault::UnknownCharacters, false,
        QT_TRANSLATE_NOOP("inform::Check", "There are characters beyond ASCII outside of comments and texts."),
        QT_TRANSLATE_NOOP("inform::Check", "Instructions are ASCII.")},
    Row {Fault::BlankLine, false, QT_TRANSLATE_NOOP("inform::Check", "There is an empty line among the instructions."),
        QT_TRANSLATE_NOOP("inform::Check", "Controllers write none.")},
    Row {Fault::TooManyLines, false, QT_TRANSLATE_NOOP("inform::Check", "The job has more than 10,000 lines."),
        QT_TRANSLATE_NOOP("inform::Check", "Controllers number lines to 9999.")},
    Row {Fault::LongText, false, QT_TRANSLATE_NOOP("inform::Check", "A comment or message is longer than 32 bytes."),
        QT_TRANSLATE_NOOP("inform::Check", "Controllers cut it.")},
    Row {Fault::LongLabel, false, QT_TRANSLATE_NOOP("inform::Check", "The label *%1 is longer than 8 bytes."),
        QT_TRANSLATE_NOOP("inform::Check", "Labels have 1 to 8 (0x4200).")},
    Row {Fault::LabelTwice, true, QT_TRANSLATE_NOOP("inform::Check", "The label *%1 is there twice."),
        QT_TRANSLATE_NOOP("inform::Check", "A jump would have two goals (0x4200).")},
    Row {Fault::NoLabel, true, QT_TRANSLATE_NOOP("inform::Check", "There is no label *%1."),
        QT_TRANSLATE_NOOP("inform::Check", "The jump gives an alarm when it is executed.")},
    Row {Fault::NotClosed, true, QT_TRANSLATE_NOOP("inform::Check", "%1 is not closed."),
        QT_TRANSLATE_NOOP("inform::Check", "IFTHEN needs ENDIF, WHILE ENDWHILE, FOR NEXT, SWITCH ENDSWITCH (0x5110).")},
    Row {Fault::NotOpened, true, QT_TRANSLATE_NOOP("inform::Check", "%1 stands outside of what it belongs to."),
        QT_TRANSLATE_NOOP("inform::Check", "Structures are closed in the reverse order (0x5110).")},
    Row {Fault::TooDeep, false, QT_TRANSLATE_NOOP("inform::Check", "Structures are nested more than 10 deep."),
        QT_TRANSLATE_NOOP("inform::Check", "Controllers allow 10.")},
    Row {Fault::OutOfRange, false, QT_TRANSLATE_NOOP("inform::Check", "%1 is out of range."),
        QT_TRANSLATE_NOOP("inform::Check", "The controller may refuse it (0x5200).")},
    Row {Fault::TooManyArguments, true, QT_TRANSLATE_NOOP("inform::Check", "There are more than 8 arguments."),
        QT_TRANSLATE_NOOP("inform::Check", "A job takes 8 (0x5110).")},
    Row {Fault::LocalBeyond, false, QT_TRANSLATE_NOOP("inform::Check", "%1 is beyond what ///LVARS provides."),
        QT_TRANSLATE_NOOP("inform::Check", "The job has fewer local variables (0x5110).")},
};

const Row &rowOf(Fault fault) { return *std::ranges::find(rows, fault, &Row::fault); }

QString placed(const Finding &finding, const QString &sentence)
{
    const bool isEntry = finding.fault == Fault::NoGroup || finding.fault == Fault::GroupLacksAxes;
    if (isEntry && finding.jobLine >= 0)
        return CheckTexts::tr("Line %1 of the file, named by line %2: %3")
            .arg(QString::number(finding.fileLine), QString::number(finding.jobLine), sentence);
    if (finding.jobLine >= 0 && finding.fileLine > 0)
        return CheckTexts::tr("Line %1 (%2 in the file): %3")
            .arg(QString::number(finding.jobLine), QString::number(finding.fileLine), sentence);
    return finding.fileLine > 0
        ? CheckTexts::tr("Line %1 of the file: %2").arg(QString::number(finding.fileLine), sentence)
        : sentence;
}

} // namespace

bool Finding::isError() const
{
    // Without positions there is nothing to count.
    return rowOf(fault).isError && (fault != Fault::NoPointCount || !detail.isEmpty());
}

QString explain(const Finding &finding, const std::function<QString(QByteArrayView)> &decode)
{
    if (finding.fault == Fault::NoPointCount && finding.detail.isEmpty())
        return placed(finding, CheckTexts::tr("There is no ///NPOS."));
    const QString sentence = CheckTexts::tr(rowOf(finding.fault).what);
    return placed(finding, sentence.contains(QStringLiteral("%1")) ? sentence.arg(decode(finding.detail)) : sentence);
}

QString reason(const Finding &finding) { return CheckTexts::tr(rowOf(finding.fault).why); }

} // namespace inform
