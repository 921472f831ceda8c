// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "inform/jobdiff.h"

#include "values/form.h"
#include <QCoreApplication>
#include <cmath>

namespace inform {

namespace {

struct JobDiffTexts {
    Q_DECLARE_TR_FUNCTIONS(inform::JobDiff)
};

/// The words of one field of RCONF, from 1 (reference §3.3).
const values::FormBit *formField(int field)
{
    static constexpr int bits[] {2, 1, 0, 3, 4, 5, 6, 7}; // of the form word, for fields 1 to 8
    const auto plain = values::formBits();
    const auto extended = values::extendedFormBits();
    if (field >= 1 && field <= 8)
        return &plain[std::size_t(bits[field - 1])];
    const auto bit = std::size_t(field - 9);
    return field >= 9 && bit < extended.size() ? &extended[bit] : nullptr;
}

QString formText(int field)
{
    const values::FormBit *words = formField(std::abs(field));
    if (!words)
        return JobDiffTexts::tr("arm form: field %1 of RCONF %2 → %3")
            .arg(std::abs(field))
            .arg(field > 0 ? 0 : 1)
            .arg(field > 0 ? 1 : 0);
    const QString off = QCoreApplication::translate("values", words->off);
    const QString on = QCoreApplication::translate("values", words->on);
    return JobDiffTexts::tr("arm form: %1 → %2").arg(field > 0 ? off : on, field > 0 ? on : off);
}

QString number(double value) { return QString::number(value, 'g', 12); }

QString axisName(const PointChange &change, const Shift &shift)
{
    static constexpr const char *pulses[] {"S", "L", "U", "R", "B", "T", "E"};
    static constexpr const char *cartesian[] {"X", "Y", "Z", "Rx", "Ry", "Rz", "Re"};
    if (!change.isOfRobot || shift.axis >= 7)
        return JobDiffTexts::tr("axis %1").arg(shift.axis + 1);
    return QLatin1StringView(shift.unit == AxisUnit::Pulse ? pulses[shift.axis] : cartesian[shift.axis]);
}

/// "3.2 mm in Z"
QString shiftText(const PointChange &change, const Shift &shift)
{
    const QString axis = axisName(change, shift);
    switch (shift.unit) {
    case AxisUnit::Pulse: return JobDiffTexts::tr("%1 pulses in %2").arg(number(shift.amount), axis);
    case AxisUnit::Millimetre: return JobDiffTexts::tr("%1 mm in %2").arg(number(shift.amount), axis);
    case AxisUnit::Degree: break;
    }
    return JobDiffTexts::tr("%1° in %2").arg(number(shift.amount), axis);
}

/// Distance and turn, where more than one axis makes them.
QString togetherText(const PointChange &change)
{
    QStringList parts;
    const auto count = [&change](AxisUnit unit) { return std::ranges::count(change.shifts, unit, &Shift::unit); };
    if (change.distance != 0 && count(AxisUnit::Millimetre) > 1)
        parts << JobDiffTexts::tr("%1 mm").arg(number(std::round(change.distance * 1e3) / 1e3));
    if (change.angle != 0 && count(AxisUnit::Degree) > 1)
        parts << JobDiffTexts::tr("%1°").arg(number(std::round(change.angle * 1e2) / 1e2));
    return parts.isEmpty() ? QString() : JobDiffTexts::tr("%1 in all").arg(parts.join(QStringLiteral(", ")));
}

QString movedText(const PointChange &change)
{
    QStringList shifts;
    for (const Shift &shift : change.shifts)
        shifts << shiftText(change, shift);
    const QString together = togetherText(change);
    const QString moved = shifts.join(QStringLiteral(", "));
    return together.isEmpty() ? JobDiffTexts::tr("moved %1").arg(moved)
                              : JobDiffTexts::tr("moved %1 (%2)").arg(moved, together);
}

/// Everything that is different about one position, in one sentence.
QString pointText(const PointChange &change, const Decode &decode)
{
    QStringList parts;
    const auto add = [&](const Versions &versions, const QString &sentence) {
        if (versions.isChanged())
            parts << sentence.arg(decode(versions.older), decode(versions.newer));
    };
    add(change.type, JobDiffTexts::tr("type %1 → %2"));
    add(change.tool, JobDiffTexts::tr("tool %1 → %2"));
    add(change.user, JobDiffTexts::tr("user frame %1 → %2"));
    for (const int field : change.form)
        parts << formText(field);
    if (change.limit.isChanged())
        parts << (change.limit.newer == "ON" ? JobDiffTexts::tr("marked as beyond the limit")
                                             : JobDiffTexts::tr("no longer marked as beyond the limit"));
    add(change.values, JobDiffTexts::tr("values %1 → %2"));
    if (!change.shifts.isEmpty())
        parts << movedText(change);
    return parts.join(QStringLiteral("; "));
}

QString attributeText(const JobEdit &edit, const QString &subject)
{
    const bool isNew = edit.kind == EditKind::AttributeAdded;
    if (edit.subject == "RJ")
        return isNew ? JobDiffTexts::tr("Made a relative job") : JobDiffTexts::tr("No longer a relative job");
    if (edit.subject == "RO")
        return isNew ? JobDiffTexts::tr("The job is locked against editing")
                     : JobDiffTexts::tr("The job is no longer locked against editing");
    if (edit.subject == "MC")
        return isNew ? JobDiffTexts::tr("Made a macro job") : JobDiffTexts::tr("No longer a macro job");
    return isNew ? JobDiffTexts::tr("Attribute %1 added").arg(subject)
                 : JobDiffTexts::tr("Attribute %1 removed").arg(subject);
}

/// What `subject` was and is; or that it came, or went.
QString versionsText(const QString &subject, const QString &older, const QString &newer, const QString &changed,
    const QString &added, const QString &removed)
{
    if (older.isEmpty())
        return added.arg(subject, newer);
    return newer.isEmpty() ? removed.arg(subject, older) : changed.arg(subject, older, newer);
}

QString frameText(const QString &older, const QString &newer)
{
    if (older.isEmpty())
        return JobDiffTexts::tr("Relative frame %1 added").arg(newer);
    return newer.isEmpty() ? JobDiffTexts::tr("Relative frame %1 removed").arg(older)
                           : JobDiffTexts::tr("Relative frame: %1 → %2").arg(older, newer);
}

QString headerText(const JobEdit &edit, const QString &subject, const QString &older, const QString &newer)
{
    switch (edit.kind) {
    case EditKind::NameChanged: return JobDiffTexts::tr("Job name: “%1” → “%2”").arg(older, newer);
    case EditKind::FolderChanged: return JobDiffTexts::tr("Job folder: “%1” → “%2”").arg(older, newer);
    case EditKind::CommentChanged: return JobDiffTexts::tr("Comment of the job: “%1” → “%2”").arg(older, newer);
    case EditKind::FrameChanged: return frameText(older, newer);
    case EditKind::GroupChanged:
        return versionsText(subject, older, newer, JobDiffTexts::tr("Control group GROUP%1: %2 → %3"),
            JobDiffTexts::tr("Control group GROUP%1 added: %2"), JobDiffTexts::tr("Control group GROUP%1 removed: %2"));
    case EditKind::LocalsChanged: return JobDiffTexts::tr("Local variables %1: %2 → %3").arg(subject, older, newer);
    case EditKind::AliasChanged:
        return versionsText(subject, older, newer, JobDiffTexts::tr("Alias of %1: %2 → %3"),
            JobDiffTexts::tr("Alias of %1 added: %2"), JobDiffTexts::tr("Alias of %1 removed: %2"));
    default: return JobDiffTexts::tr("Argument %1: “%2” → “%3”").arg(subject, older, newer);
    }
}

/// The line and what is in it: "Line 2 +MOVJ of RB2".
QString placeText(const JobEdit &edit, const QString &instruction, const Decode &decode)
{
    if (edit.group.isEmpty())
        return JobDiffTexts::tr("Line %1 %2").arg(QString::number(edit.line), instruction);
    return JobDiffTexts::tr("Line %1 %2 of %3").arg(QString::number(edit.line), instruction, decode(edit.group));
}

QString operandText(
    const JobEdit &edit, const QString &subject, const QString &older, const QString &newer, const Decode &decode)
{
    const QString place = placeText(edit, decode(edit.instruction), decode);
    if (edit.older.isEmpty())
        return JobDiffTexts::tr("%1: %2 %3 added").arg(place, subject, newer);
    if (edit.newer.isEmpty())
        return JobDiffTexts::tr("%1: %2 %3 removed").arg(place, subject, older);
    if (subject.isEmpty())
        return JobDiffTexts::tr("%1: %2 → %3", "line and instruction, before, after").arg(place, older, newer);
    return JobDiffTexts::tr("%1: %2 %3 → %4", "line and instruction, operand, before, after")
        .arg(place, subject, older, newer);
}

QString lineText(const JobEdit &edit, const QString &older, const QString &newer)
{
    const QString line = QString::number(edit.line);
    switch (edit.kind) {
    case EditKind::LineAdded:
        return newer.isEmpty() ? JobDiffTexts::tr("Line %1 added: %2").arg(line, older)
                               : JobDiffTexts::tr("Line %1 added: %2 (new point: %3)").arg(line, older, newer);
    case EditKind::LineRemoved:
        return newer.isEmpty() ? JobDiffTexts::tr("Line %1 removed: %2").arg(line, older)
                               : JobDiffTexts::tr("Line %1 removed: %2 (with its point: %3)").arg(line, older, newer);
    case EditKind::LinesMoved:
        return JobDiffTexts::tr("%n line(s) moved from line %1 to line %2", nullptr, edit.count)
            .arg(QString::number(edit.oldLine), line);
    case EditKind::CommentedOut: return JobDiffTexts::tr("Line %1 commented out: %2").arg(line, newer);
    case EditKind::CommentedIn: return JobDiffTexts::tr("Line %1 no longer commented out: %2").arg(line, newer);
    case EditKind::Locked: return JobDiffTexts::tr("Line %1 locked against editing: %2").arg(line, newer);
    case EditKind::Unlocked: return JobDiffTexts::tr("Line %1 no longer locked against editing: %2").arg(line, newer);
    case EditKind::RemarkChanged:
        return versionsText(line, older, newer, JobDiffTexts::tr("Line %1, comment: “%2” → “%3”"),
            JobDiffTexts::tr("Line %1, comment added: “%2”"), JobDiffTexts::tr("Line %1, comment removed: “%2”"));
    default: return JobDiffTexts::tr("Line %1: %2 → %3").arg(line, older, newer);
    }
}

QString positionText(
    const JobEdit &edit, const QString &subject, const QString &older, const QString &newer, const Decode &decode)
{
    const QString place =
        edit.line < 0 ? subject : JobDiffTexts::tr("Line %1 %2").arg(QString::number(edit.line), subject);
    switch (edit.kind) {
    case EditKind::PointAdded: return JobDiffTexts::tr("%1 added: %2", "a position").arg(place, newer);
    case EditKind::PointRemoved: return JobDiffTexts::tr("%1 removed: %2", "a position").arg(place, older);
    default: return JobDiffTexts::tr("%1: %2", "a position").arg(place, pointText(edit.point, decode));
    }
}

} // namespace

QString explain(const JobEdit &edit, const Decode &decode)
{
    const QString subject = decode(edit.subject);
    const QString older = decode(edit.older);
    const QString newer = decode(edit.newer);
    if (edit.kind == EditKind::AttributeAdded || edit.kind == EditKind::AttributeRemoved)
        return attributeText(edit, subject);
    if (edit.kind < EditKind::PointAdded)
        return headerText(edit, subject, older, newer);
    if (edit.kind <= EditKind::PointChanged)
        return positionText(edit, subject, older, newer, decode);
    return edit.kind == EditKind::OperandChanged ? operandText(edit, subject, older, newer, decode)
                                                 : lineText(edit, older, newer);
}

} // namespace inform
