// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "files/jobdiff.h"

#include "inform/linediff.h"
#include <QCoreApplication>
#include <cmath>
#include <map>

namespace files {

using inform::Hunk;
using inform::diffLines;

namespace {

struct JobDiffTexts {
    Q_DECLARE_TR_FUNCTIONS(files::JobDiff)
};

using Edits = QList<JobEdit>;

Edits diffHeaders(const Job &older, const Job &newer)
{
    const std::tuple<const char *, QByteArray, QByteArray> parts[] {
        {"name", older.name, newer.name},
        {"comment", older.comment, newer.comment},
        {"attributes", older.attributes.join(','), newer.attributes.join(',')},
        {"groups", older.groups.join(','), newer.groups.join(',')},
    };
    Edits edits;
    for (const auto &[subject, before, after] : parts) {
        if (before != after)
            edits << JobEdit {EditKind::HeaderChanged, subject, -1, before, after};
    }
    return edits;
}

/// nullopt for what is no number, or "nan" and "inf", which Qt reads as numbers.
std::optional<double> numberOf(const QByteArray &text)
{
    bool isNumber = false;
    const double number = text.toDouble(&isNumber);
    return isNumber && std::isfinite(number) ? std::optional(number) : std::nullopt;
}

/// The axes that differ; nullopt if the values cannot be compared number by number.
std::optional<QList<Shift>> shiftsBetween(const TaughtPosition &older, const TaughtPosition &newer)
{
    if (older.values.size() != newer.values.size())
        return std::nullopt;
    QList<Shift> shifts;
    for (int axis = 0; axis < older.values.size(); ++axis) {
        const auto before = numberOf(older.values[axis]);
        const auto after = numberOf(newer.values[axis]);
        if (!before || !after)
            return std::nullopt;
        if (*before != *after)
            shifts << Shift {axis, std::round((*after - *before) * 1e4) / 1e4};
    }
    return shifts;
}

QByteArray frameOf(const TaughtPosition &position)
{
    QByteArray result = position.type;
    if (!position.tool.isEmpty())
        result += " TOOL " + position.tool;
    if (!position.userFrame.isEmpty())
        result += " USER " + position.userFrame;
    return result;
}

std::optional<JobEdit> diffPosition(const TaughtPosition &older, const TaughtPosition &newer)
{
    if (frameOf(older) != frameOf(newer))
        return JobEdit {EditKind::PositionRetyped, newer.name, -1, frameOf(older), frameOf(newer)};
    if (older.values == newer.values)
        return std::nullopt;
    const auto shifts = shiftsBetween(older, newer);
    if (shifts && shifts->isEmpty())
        return std::nullopt;
    return JobEdit {EditKind::PositionMoved, newer.name, -1, older.values.join(','), newer.values.join(','),
        newer.isPulse(), shifts.value_or(QList<Shift> {})};
}

std::map<QByteArray, const TaughtPosition *> byName(const Job &job)
{
    std::map<QByteArray, const TaughtPosition *> result;
    for (const TaughtPosition &position : job.positions)
        result[position.name] = &position;
    return result;
}

Edits diffPositions(const Job &older, const Job &newer)
{
    const auto before = byName(older);
    const auto after = byName(newer);
    Edits edits;
    for (const auto &[name, position] : before) {
        const auto found = after.find(name);
        if (found == after.end())
            edits << JobEdit {EditKind::PositionRemoved, name, -1, position->values.join(','), {}};
        else if (const auto edit = diffPosition(*position, *found->second))
            edits << *edit;
    }
    for (const auto &[name, position] : after) {
        if (!before.contains(name))
            edits << JobEdit {EditKind::PositionAdded, name, -1, {}, position->values.join(',')};
    }
    return edits;
}

/// "V" of "V=50.0"; empty where there is no equals sign, or it is a comparison.
QByteArray keyOf(const QByteArray &word)
{
    const qsizetype equals = word.indexOf('=');
    const bool isKey =
        equals > 0 && std::all_of(word.begin(), word.begin() + equals, [](char c) { return c >= 'A' && c <= 'Z'; });
    return isKey ? word.first(equals) : QByteArray {};
}

JobEdit operandEdit(const QByteArray &before, const QByteArray &after, int line)
{
    const QByteArray key = keyOf(after);
    if (key.isEmpty() || key != keyOf(before))
        return {EditKind::OperandChanged, {}, line, before, after};
    return {EditKind::OperandChanged, key, line, before.sliced(key.size() + 1), after.sliced(key.size() + 1)};
}

/// Operand by operand if both are the same instruction with as many operands; else as a whole.
Edits diffLine(const QByteArray &before, const QByteArray &after, int line)
{
    const bool isText = before.startsWith('\'') || after.startsWith('\'') || after.startsWith('*');
    const QByteArrayList oldWords = before.simplified().split(' ');
    const QByteArrayList newWords = after.simplified().split(' ');
    if (isText || oldWords.size() != newWords.size() || oldWords[0] != newWords[0])
        return {{EditKind::LineChanged, {}, line, before, after}};
    Edits edits;
    for (int index = 1; index < oldWords.size(); ++index) {
        if (oldWords[index] != newWords[index])
            edits << operandEdit(oldWords[index], newWords[index], line);
    }
    return edits;
}

Edits diffBlock(const Job &older, const Job &newer, const Hunk &block)
{
    Edits edits;
    const int common = std::min(block.oldCount, block.newCount);
    for (int index = 0; index < common; ++index)
        edits << diffLine(
            older.instruction(block.oldFrom + index), newer.instruction(block.newFrom + index), block.newFrom + index);
    for (int number = block.oldFrom + common; number < block.oldFrom + block.oldCount; ++number)
        edits << JobEdit {EditKind::LineRemoved, {}, number, older.instruction(number), {}};
    for (int number = block.newFrom + common; number < block.newFrom + block.newCount; ++number)
        edits << JobEdit {EditKind::LineAdded, {}, number, {}, newer.instruction(number)};
    return edits;
}

QByteArrayList instructionsOf(const Job &job, const NoiseFilter &noise)
{
    QByteArrayList result;
    for (int number = 0; number < job.instructions.size(); ++number)
        result << noise.clean(job.instruction(number)).simplified();
    return result;
}

Edits diffInstructions(const Job &older, const Job &newer, const NoiseFilter &noise)
{
    Edits edits;
    for (const Hunk &block : diffLines(instructionsOf(older, noise), instructionsOf(newer, noise)))
        edits << diffBlock(older, newer, block);
    return edits;
}

QString axisName(const JobEdit &edit, int axis)
{
    constexpr const char *pulses = "SLURBTE";
    constexpr const char *cartesian[] {"X", "Y", "Z", "Rx", "Ry", "Rz", "Re"};
    const bool isRobot = edit.subject.startsWith('C') || edit.subject.startsWith('P');
    if (!isRobot || axis > 6)
        return QString::number(axis + 1);
    return edit.isPulse ? QString(QLatin1Char(pulses[axis])) : QString::fromLatin1(cartesian[axis]);
}

/// "3.2 mm in Z"
QString shiftText(const JobEdit &edit, const Shift &shift)
{
    const QString amount = QLocale().toString(shift.amount, 'g', 10);
    const QString axis = axisName(edit, shift.axis);
    if (edit.isPulse)
        return JobDiffTexts::tr("%1 pulses in %2").arg(amount, axis);
    return shift.axis < 3 ? JobDiffTexts::tr("%1 mm in %2").arg(amount, axis)
                          : JobDiffTexts::tr("%1° in %2").arg(amount, axis);
}

QString movedText(const JobEdit &edit, const QString &subject, const QString &older, const QString &newer)
{
    if (edit.shifts.isEmpty())
        return JobDiffTexts::tr("%1 changed: %2 → %3").arg(subject, older, newer);
    QStringList shifts;
    for (const Shift &shift : edit.shifts)
        shifts << shiftText(edit, shift);
    return JobDiffTexts::tr("%1 moved %2").arg(subject, shifts.join(QStringLiteral(", ")));
}

QString headerText(const JobEdit &edit, const QString &older, const QString &newer)
{
    if (edit.subject == "name")
        return JobDiffTexts::tr("Job name changed: “%1” → “%2”").arg(older, newer);
    if (edit.subject == "comment")
        return JobDiffTexts::tr("Comment changed: “%1” → “%2”").arg(older, newer);
    if (edit.subject == "attributes")
        return JobDiffTexts::tr("Attributes changed: %1 → %2").arg(older, newer);
    return JobDiffTexts::tr("Control groups changed: %1 → %2").arg(older, newer);
}

} // namespace

QList<JobEdit> diffJobs(const Job &older, const Job &newer, const NoiseFilter &noise)
{
    return diffHeaders(older, newer) + diffPositions(older, newer) + diffInstructions(older, newer, noise);
}

QString explain(const JobEdit &edit, const protocol::TextCodec &codec)
{
    const QString subject = codec.decode(edit.subject);
    const QString older = codec.decode(edit.older);
    const QString newer = codec.decode(edit.newer);
    switch (edit.kind) {
    case EditKind::HeaderChanged: return headerText(edit, older, newer);
    case EditKind::PositionAdded: return JobDiffTexts::tr("%1 added: %2").arg(subject, newer);
    case EditKind::PositionRemoved: return JobDiffTexts::tr("%1 removed: %2").arg(subject, older);
    case EditKind::PositionMoved: return movedText(edit, subject, older, newer);
    case EditKind::PositionRetyped:
        return JobDiffTexts::tr("%1 is taught otherwise: %2 → %3").arg(subject, older, newer);
    case EditKind::OperandChanged:
        return JobDiffTexts::tr("%1 %2 → %3 at line %4").arg(subject, older, newer).arg(edit.line).trimmed();
    case EditKind::LineChanged: return JobDiffTexts::tr("Line %1: %2 → %3").arg(edit.line).arg(older, newer);
    case EditKind::LineAdded: return JobDiffTexts::tr("Line %1 added: %2").arg(edit.line).arg(newer);
    case EditKind::LineRemoved: return JobDiffTexts::tr("Line %1 removed: %2").arg(edit.line).arg(older);
    }
    return {};
}

} // namespace files
