// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "cell/comparisons.h"
#include "cellfiles/homepositions.h"
#include "cellfiles/ladder.h"
#include "cellfiles/logs.h"
#include "cellfiles/systemfile.h"
#include "inform/linediff.h"
#include <set>

/// Parameters, ladder, home positions, system and logs in words.
using namespace cellfiles;

namespace cell {

namespace {

/// "robot 1 limit S + 170.0 → 120.0 deg"; empty for parameters that are no limits.
QString limitChange(const LimitPlace &place, qint32 older, qint32 newer, const Knowledge &knowledge)
{
    if (place.robot < 1 || place.robot > Knowledge::robots)
        return {};
    const Axis &axis = knowledge.arms[std::size_t(place.robot) - 1].axes[std::size_t(place.axis)];
    if (!axis.exists())
        return {};
    const auto degrees = [&](qint32 pulses) { return QString::number(axis.degrees(pulses), 'f', 1); };
    return Sentences::tr("robot %1 limit %2 %3 %4 deg")
        .arg(place.robot)
        .arg(axisName(place.axis), place.isUpper ? QStringLiteral("+") : QStringLiteral("-"),
            change(degrees(older), degrees(newer)));
}

/// One parameter that has another value.
struct ParameterChange {
    QByteArray section;
    int number;
    std::size_t size; ///< Of the section.
    qint32 older;
    qint32 newer;
};

QString parameterText(const ParameterChange &edit, const Knowledge &knowledge)
{
    const ParameterMeaning *known = findMeaning(edit.section, edit.number);
    const bool isSecret = known && known->isSecret;
    const QString values =
        isSecret ? Sentences::tr("changed") : change(QString::number(edit.older), QString::number(edit.newer));
    const auto limit = limitPlace(edit.section, edit.number, edit.size);
    QString meaning = limit ? limitChange(*limit, edit.older, edit.newer, knowledge) : QString {};
    if (meaning.isEmpty())
        meaning = known ? meaningOf(edit.section, edit.number) : Sentences::tr("meaning not known");
    return QStringLiteral("%1 %2 (%3).").arg(parameterName(edit.section, edit.number), values, meaning);
}

void compareSection(const QByteArray &name, const ParameterSection &older, const ParameterSection &newer,
    const Knowledge &knowledge, Statements &statements)
{
    const std::size_t count = std::min(older.values.size(), newer.values.size());
    for (std::size_t number = 0; number < count && statements.size() <= mostStatements; ++number) {
        const auto before = older.values[number];
        const auto after = newer.values[number];
        if (before && after && *before != *after)
            statements << Statement {
                parameterText({name, int(number), newer.values.size(), *before, *after}, knowledge), true};
    }
    if (older.values.size() != newer.values.size())
        statements << Statement {
            Sentences::tr("Section %1 has %2 values.")
                .arg(QString::fromLatin1(name),
                    change(QString::number(older.values.size()), QString::number(newer.values.size()))),
            true};
}

QString partText(int part) { return part == 1 ? Sentences::tr("System part") : Sentences::tr("User part"); }

QString operandText(const LadderOperand &operand, const Knowledge &knowledge)
{
    const QString number = toString(operand);
    const bool isSignal = operand.kind == LadderOperand::Kind::Signal;
    const QString name = isSignal ? knowledge.signalNames.value(operand.number)
                                  : knowledge.variableNames.value({variables::Kind::M, operand.number});
    return name.isEmpty() ? number : QStringLiteral("%1 “%2”").arg(number, name);
}

/// What the branch that an instruction belongs to decides: the next output behind it.
QString decided(const Ladder &ladder, qsizetype index, const Knowledge &knowledge)
{
    for (; index < ladder.instructions.size(); ++index) {
        if (!ladder.instructions[index].writes.isEmpty())
            return Sentences::tr("decides %1").arg(operandText(ladder.instructions[index].writes.first(), knowledge));
    }
    return {};
}

QByteArrayList codeOf(const Ladder &ladder)
{
    QByteArrayList lines;
    for (const LadderInstruction &instruction : ladder.instructions)
        lines << QByteArray::number(instruction.part) + ' ' + instruction.text();
    return lines;
}

Statement codeStatement(const Ladder &ladder, qsizetype index, const QString &what, const Knowledge &knowledge)
{
    const LadderInstruction &at = ladder.instructions[std::clamp<qsizetype>(index, 0, ladder.instructions.size() - 1)];
    QString text = Sentences::tr("%1, instruction %2: %3").arg(partText(at.part)).arg(index + 1).arg(what);
    if (const QString output = decided(ladder, index, knowledge); !output.isEmpty())
        text += QStringLiteral("; ") + output;
    return {text + u'.', true};
}

void compareHunk(
    const Ladder &older, const Ladder &newer, const inform::Hunk &hunk, const Context &context, Statements &statements)
{
    const auto text = [&](const Ladder &ladder, int index) {
        return context.codec.decode(ladder.instructions[index].text());
    };
    const int both = std::min(hunk.oldCount, hunk.newCount);
    for (int index = 0; index < both; ++index)
        statements << codeStatement(newer, hunk.newFrom + index,
            Sentences::tr("%1 became %2").arg(text(older, hunk.oldFrom + index), text(newer, hunk.newFrom + index)),
            context.knowledge);
    for (int index = both; index < hunk.newCount; ++index)
        statements << codeStatement(newer, hunk.newFrom + index,
            Sentences::tr("%1 is new").arg(text(newer, hunk.newFrom + index)), context.knowledge);
    for (int index = both; index < hunk.oldCount; ++index)
        statements << codeStatement(older, hunk.oldFrom + index,
            Sentences::tr("%1 is gone").arg(text(older, hunk.oldFrom + index)), context.knowledge);
}

std::set<LadderOperand> writtenBy(const Ladder &ladder)
{
    std::set<LadderOperand> all;
    for (const LadderInstruction &instruction : ladder.instructions)
        all.insert(instruction.writes.begin(), instruction.writes.end());
    return all;
}

void compareWritten(const Ladder &older, const Ladder &newer, const Knowledge &knowledge, Statements &statements)
{
    const auto before = writtenBy(older);
    const auto after = writtenBy(newer);
    const auto list = [&](const std::set<LadderOperand> &has, const std::set<LadderOperand> &lacks) {
        QStringList texts;
        for (const LadderOperand &operand : has) {
            if (!lacks.contains(operand))
                texts << operandText(operand, knowledge);
        }
        return texts.mid(0, 16).join(QStringLiteral(", "));
    };
    if (const QString added = list(after, before); !added.isEmpty())
        statements << Statement {Sentences::tr("Now also written: %1.").arg(added), true};
    if (const QString removed = list(before, after); !removed.isEmpty())
        statements << Statement {Sentences::tr("No longer written: %1.").arg(removed), true};
}

void compareTexts(const Ladder &older, const Ladder &newer, Statements &statements)
{
    for (const QByteArray &table :
        {QByteArray {"ALARM1"}, QByteArray {"ALARM2"}, QByteArray {"MESSAGE1"}, QByteArray {"MESSAGE2"}}) {
        const auto before = older.texts.value(table);
        auto all = before;
        const auto after = newer.texts.value(table);
        all.insert(after);
        const int first = table.startsWith("ALARM") ? Ladder::firstAlarm : 0;
        for (auto text = all.begin(); text != all.end(); ++text) {
            if (before.value(text.key()) != after.value(text.key()))
                statements << Statement {QStringLiteral("%1 %2: %3.")
                                             .arg(QString::fromLatin1(table))
                                             .arg(first + text.key())
                                             .arg(change(before.value(text.key()), after.value(text.key())))};
        }
    }
}

void compareHomes(
    const HomePositions &older, const HomePositions &newer, const QString &sentence, Statements &statements)
{
    for (qsizetype group = 0; group < std::min(older.groups.size(), newer.groups.size()); ++group) {
        const HomeGroup &before = older.groups[group];
        const HomeGroup &after = newer.groups[group];
        if (!(before.group == after.group))
            statements << Statement {Sentences::tr("The control group %1 is another one.").arg(after.group.name), true};
        for (qsizetype axis = 0; axis < std::min(before.axes.size(), after.axes.size()); ++axis) {
            if (!(before.axes[axis] == after.axes[axis]))
                statements << Statement {
                    sentence.arg(after.group.name, axisName(int(axis)),
                        change(QString::number(before.axes[axis].pulses), QString::number(after.axes[axis].pulses))),
                    true};
        }
    }
    if (older.groups.size() != newer.groups.size())
        statements << Statement {Sentences::tr("Another number of control groups."), true};
}

QString mechanismText(const System &system)
{
    QStringList texts;
    for (const Mechanism &mechanism : system.mechanisms)
        texts << QStringLiteral("%1 %2").arg(mechanism.group, mechanism.model).trimmed();
    return texts.join(QStringLiteral(", "));
}

QString hoursText(std::chrono::seconds value)
{
    const qint64 minutes = value.count() / 60;
    return Sentences::tr("%1 h %2 min").arg(minutes / 60).arg(minutes % 60);
}

void compareHours(const System &older, const System &newer, Statements &statements)
{
    const auto before = older.hoursOf(u"CONTROL POWER", u"TOTAL");
    const auto after = newer.hoursOf(u"CONTROL POWER", u"TOTAL");
    if (before && after && *after < *before)
        statements << Statement {
            Sentences::tr("The hours of control power went back by %1: another controller, or its memory was cleared.")
                .arg(hoursText(*before - *after)),
            true};
    else if (before && after && *after > *before)
        statements << Statement {Sentences::tr("%1 powered in between.").arg(hoursText(*after - *before)), false, true};
}

} // namespace

Statements compareParameters(const Context &context)
{
    const Parameters older = parametersFrom(context.versions.older).value;
    const Parameters newer = parametersFrom(context.versions.newer).value;
    Statements statements;
    for (auto section = newer.sections.begin(); section != newer.sections.end(); ++section) {
        const auto before = older.sections.find(section.key());
        if (before != older.sections.end())
            compareSection(section.key(), *before, *section, context.knowledge, statements);
        else
            statements << Statement {Sentences::tr("Section %1 is new.").arg(QString::fromLatin1(section.key())), true};
    }
    for (auto section = older.sections.begin(); section != older.sections.end(); ++section) {
        if (!newer.sections.contains(section.key()))
            statements << Statement {
                Sentences::tr("Section %1 is not in the newer file.").arg(QString::fromLatin1(section.key())), true};
    }
    return statements;
}

Statements compareLadders(const Context &context)
{
    const Ladder older = ladderFrom(context.versions.older, context.codec).value;
    const Ladder newer = ladderFrom(context.versions.newer, context.codec).value;
    Statements statements;
    for (const inform::Hunk &hunk : inform::diffLines(codeOf(older), codeOf(newer)))
        compareHunk(older, newer, hunk, context, statements);
    compareWritten(older, newer, context.knowledge, statements);
    if (older.presets != newer.presets)
        statements << Statement {Sentences::tr("Presets of timers and counters changed."), true};
    compareTexts(older, newer, statements);
    return statements;
}

Statements compareEncoderOffsets(const Context &context)
{
    Statements statements;
    compareHomes(encoderOffsetsFrom(context.versions.older).value, encoderOffsetsFrom(context.versions.newer).value,
        Sentences::tr("Home position of %1 axis %2 recalibrated (%3): taught points may be off."), statements);
    return statements;
}

Statements compareHomePositions(const Context &context)
{
    Statements statements;
    compareHomes(homePositionsFrom(context.versions.older).value, homePositionsFrom(context.versions.newer).value,
        Sentences::tr("Position of %1 axis %2: %3 pulses."), statements);
    return statements;
}

Statements comparePseudoInputs(const Context &context)
{
    const auto read = [&](const QByteArray &file) {
        const auto on = pseudoInputsFrom(file, context.codec).value.on(0);
        return std::set<int>(on.begin(), on.end());
    };
    const auto before = read(context.versions.older);
    const auto after = read(context.versions.newer);
    Statements statements;
    for (const auto &[has, lacks, state] :
        {std::tuple {&after, &before, Sentences::tr("on")}, std::tuple {&before, &after, Sentences::tr("off")}}) {
        for (const int offset : *has) {
            if (lacks->contains(offset))
                continue;
            const QString remote = offset != commandRemoteSelect ? QString {}
                : has == &after ? Sentences::tr(" Command remote select: HSES control is permitted.")
                                : Sentences::tr(" Command remote select: HSES control will be refused.");
            statements << Statement {Sentences::tr("Pseudo input %1 switched %2.")
                                         .arg(QStringLiteral("#87%1").arg(offset, 3, 10, QLatin1Char {'0'}), state)
                    + remote,
                true};
        }
    }
    return statements;
}

Statements compareSystems(const Context &context)
{
    const System older = systemFrom(context.versions.older, context.codec).value;
    const System newer = systemFrom(context.versions.newer, context.codec).value;
    Statements statements;
    const auto add = [&](const QString &what, const QString &before, const QString &after) {
        if (before != after)
            statements << Statement {QStringLiteral("%1 %2.").arg(what, change(before, after))};
    };
    add(Sentences::tr("Software"), older.version, newer.version);
    add(Sentences::tr("Parameter version"), older.parameters, newer.parameters);
    add(Sentences::tr("Robots"), mechanismText(older), mechanismText(newer));
    add(Sentences::tr("Applications"), older.applications.join(QStringLiteral(", ")),
        newer.applications.join(QStringLiteral(", ")));
    add(Sentences::tr("Boards"), older.revisions.join(QStringLiteral("; ")),
        newer.revisions.join(QStringLiteral("; ")));
    compareHours(older, newer, statements);
    return statements;
}

Statements compareLogs(const Context &context)
{
    const auto older = logFrom(context.versions.older, context.codec).value;
    const auto newer = logFrom(context.versions.newer, context.codec).value;
    // Entries move down as others come: matched by content, the newest known one ends what is new.
    const auto known = older.isEmpty() ? newer.end() : std::find(newer.begin(), newer.end(), older.first());
    const int count = int(known - newer.begin());
    Statements statements;
    if (count > 0)
        statements << Statement {Sentences::tr("%n new entry(ies).", nullptr, count), false, true};
    if (!older.isEmpty() && known == newer.end())
        statements << Statement {Sentences::tr("The log rolled over: edits in between are not known."), false, true};
    return statements;
}

Statements compareAlarms(const Context &context)
{
    const auto older = alarmHistoryFrom(context.versions.older, context.codec).value;
    const auto newer = alarmHistoryFrom(context.versions.newer, context.codec).value;
    QMap<QString, int> fresh;
    int count = 0;
    for (const AlarmRecord &record : newer) {
        if (std::ranges::any_of(older, [&](const AlarmRecord &known) { return known.isSameAs(record); }))
            continue;
        ++fresh[QStringLiteral("%1 %2 %3").arg(record.code).arg(record.name, record.group).trimmed()];
        ++count;
    }
    QStringList texts;
    for (auto alarm = fresh.begin(); alarm != fresh.end(); ++alarm)
        texts << (*alarm > 1 ? QStringLiteral("%1 (%2×)").arg(alarm.key()).arg(*alarm) : alarm.key());
    if (texts.isEmpty())
        return {};
    return {Statement {
        Sentences::tr("%n new alarm(s): %1.", nullptr, count).arg(texts.join(QStringLiteral(", "))), false, true}};
}

} // namespace cell
