// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "cell/crossreference.h"

#include <algorithm>

using inform::Access;
using inform::Job;

namespace cell {

namespace {

using Kind = Subject::Kind;

constexpr QByteArrayView ladderFile {"CIOPRG.LST"};
constexpr QByteArrayView macroFile {"MACRO.DAT"};

How howOf(Access access, bool waits)
{
    switch (access) {
    case Access::Writes: return How::Writes;
    case Access::Calls:
    case Access::Macro: return How::Calls;
    case Access::JumpsTo: return How::JumpsTo;
    case Access::Starts: return How::Starts;
    case Access::Reads: break;
    }
    return waits ? How::Waits : How::Reads;
}

bool isJobAccess(Access access)
{
    return access == Access::Calls || access == Access::JumpsTo || access == Access::Starts;
}

/// The frame of a relative job, "USER 3".
std::optional<int> userFrameOf(const Job &job)
{
    return job.frame.startsWith("USER ") ? std::optional {job.frame.sliced(5).trimmed().toInt()} : std::nullopt;
}

QByteArrayView nameFileOf(Kind kind)
{
    return kind == Kind::Register ? QByteArrayView {"IOMNAME.DAT"} : QByteArrayView {"VARNAME.DAT"};
}

} // namespace

CrossReference::CrossReference(const Cell &cell)
{
    for (const auto &[name, file] : cell.jobs)
        takeJob(name, file.job);
    takeLadder(cell.ladder);
    takeMacros(cell.macros);
    takeNames(cell);
}

void CrossReference::takeJob(const QByteArray &name, const Job &job)
{
    if (const auto frame = userFrameOf(job))
        add({Kind::UserFrame, *frame}, {How::Reads, {Place::Kind::Job, name, 0}, false, "FRAME"});
    for (int line = 0; line < job.lineCount(); ++line)
        takeLine(name, job, line);
}

void CrossReference::takeLine(const QByteArray &name, const Job &job, int line)
{
    const auto references = inform::references(job, line);
    if (references.isEmpty())
        return;
    const auto *row = inform::findInstruction(job.word(line));
    const bool waits = row && row->wait == inform::Wait::Condition;
    for (const inform::Reference &reference : references) {
        Use use {
            howOf(reference.access, waits), {Place::Kind::Job, name, line}, reference.isAny, {}, reference.element};
        if (isJobAccess(reference.access)) {
            add({Kind::Job, 0, reference.name}, use);
        } else if (reference.isAny) {
            if (const auto any = anyOf(reference.name); any && !reference.isLocal)
                m_any << AnyUse {*any, use};
        } else if (!reference.isLocal) {
            const auto subjects = subjectsOf(reference.name);
            if (subjects.size() > 1)
                use.through = reference.name;
            for (const Subject &subject : subjects)
                add(subject, use);
            takePoints(name, job, line, reference);
        }
    }
}

/// The tool and the user frame of a position that the line goes to; those of base and station axes mean nothing.
void CrossReference::takePoints(const QByteArray &name, const Job &job, int line, const inform::Reference &reference)
{
    const inform::Point *point = reference.access == Access::Reads ? job.point(reference.name) : nullptr;
    if (!point || !point->isOfRobot())
        return;
    const Use use {How::Reads, {Place::Kind::Job, name, line}, false, reference.name};
    if (!point->tool.isEmpty())
        add({Kind::Tool, point->tool.toInt()}, use);
    if (!point->user.isEmpty())
        add({Kind::UserFrame, point->user.toInt()}, use);
}

void CrossReference::takeLadder(const cellfiles::Ladder &ladder)
{
    using Operand = cellfiles::LadderOperand;
    const auto subjectOf = [](const Operand &operand) {
        return Subject {operand.kind == Operand::Kind::Signal ? Kind::Signal : Kind::Register, operand.number};
    };
    for (const cellfiles::LadderInstruction &instruction : ladder.instructions) {
        const Place place {Place::Kind::Ladder, ladderFile.toByteArray(), instruction.line};
        const QByteArray through =
            instruction.reads.size() + instruction.writes.size() > 1 ? instruction.text() : QByteArray {};
        for (const Operand &operand : instruction.reads)
            add(subjectOf(operand), {How::Reads, place, false, through});
        for (const Operand &operand : instruction.writes)
            add(subjectOf(operand), {How::Writes, place, false, through});
    }
}

void CrossReference::takeMacros(const QList<cellfiles::Macro> &macros)
{
    for (const cellfiles::Macro &macro : macros) {
        for (const QByteArray &job : {macro.job, macro.otherJob}) {
            if (!job.isEmpty())
                add({Kind::Job, 0, job},
                    {How::Calls, {Place::Kind::Macro, macroFile.toByteArray(), macro.line}, false,
                        "MJ#(" + QByteArray::number(macro.number) + ')'});
        }
    }
}

void CrossReference::takeNames(const Cell &cell)
{
    const auto named = [this](const Subject &subject, QByteArrayView file, int line) {
        add(subject, {How::Names, {Place::Kind::NameFile, file.toByteArray(), line}});
    };
    for (const cellfiles::VariableName &each : cell.variableNames.names)
        named({Kind(each.variable.kind), each.variable.number}, nameFileOf(Kind::B), each.line);
    for (auto each = cell.signalNames.lines.begin(); each != cell.signalNames.lines.end(); ++each)
        named({Kind::Signal, each.key()}, each.key() >= 20'000 ? "EXIONAME.DAT" : "IONAME.DAT", each.value());
    for (auto each = cell.registerNames.names.begin(); each != cell.registerNames.names.end(); ++each)
        named({Kind::Register, each.key()}, nameFileOf(Kind::Register), 0);
}

QList<Use> CrossReference::uses(const Subject &subject) const
{
    const auto found = m_uses.find(subject);
    QList<Use> result = found == m_uses.end() ? QList<Use> {} : found->second;
    for (const AnyUse &any : m_any) {
        const bool mayBe = any.of.kind == subject.kind && any.of.name == subject.name && subject.number >= any.of.first
            && subject.number <= any.of.last;
        if (mayBe)
            result << any.use;
    }
    return result;
}

QList<Subject> CrossReference::subjects() const
{
    QList<Subject> result;
    result.reserve(qsizetype(m_uses.size()));
    for (const auto &[subject, uses] : m_uses)
        result << subject;
    return result;
}

qsizetype CrossReference::indirectUses(Subject::Kind kind) const
{
    return std::ranges::count_if(m_any, [kind](const AnyUse &any) { return any.of.kind == kind; });
}

} // namespace cell
