// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "cell/calltree.h"

#include "inform/references.h"
#include <QSet>
#include <algorithm>

using inform::Access;
using inform::Job;
using inform::TermKind;

namespace cell {

namespace {

/// CALL, JUMP and PSTART whose job is said by something else than its name (INFORM reference §6.3).
bool hasUnknownTarget(const inform::Part &part)
{
    if (part.word != "CALL" && part.word != "PSTART" && part.word != "JUMP")
        return false;
    const bool isNamed = std::ranges::any_of(part.operands, [](const inform::Operand &operand) {
        return operand.term.kind == TermKind::Job || operand.term.kind == TermKind::Label || operand.tag == "LABEL";
    });
    return !isNamed && part.positional(0);
}

QByteArrayList jobsOfMacro(const Cell &cell, QByteArrayView reference)
{
    QByteArrayList jobs;
    for (const cellfiles::Macro &macro : cell.macros) {
        if (reference != "MJ#(" + QByteArray::number(macro.number) + ')')
            continue;
        for (const QByteArray &job : {macro.job, macro.otherJob}) {
            if (!job.isEmpty())
                jobs << job;
        }
    }
    return jobs;
}

How howOf(Access access)
{
    return access == Access::JumpsTo ? How::JumpsTo : access == Access::Starts ? How::Starts : How::Calls;
}

bool runsByItself(const Job &job) { return job.attributes.contains("MC") || job.attributes.contains("SY"); }

} // namespace

CallTree::CallTree(const Cell &cell)
{
    for (const auto &[name, file] : cell.jobs) {
        for (int line = 0; line < file.job.lineCount(); ++line)
            take(cell, name, file.job, line);
    }
    QSet<QByteArray> named;
    for (const Call &call : m_calls) {
        if (call.callee != call.caller)
            named.insert(call.callee);
    }
    for (const cellfiles::Macro &macro : cell.macros)
        named << macro.job << macro.otherJob;
    for (const auto &[name, file] : cell.jobs) {
        if (named.contains(name))
            continue;
        m_heads << name;
        if (!runsByItself(file.job))
            m_unused << name;
    }
}

void CallTree::take(const Cell &cell, const QByteArray &name, const Job &job, int line)
{
    const inform::Statement statement = inform::statement(job, line);
    if (statement.isCommentedOut || statement.parts.empty())
        return;
    const inform::Part &part = statement.parts.front();
    Call call {name, line, How::Calls, {}, {}, !part.conditions.empty()};
    const auto add = [&](const QByteArray &callee) {
        call.callee = callee;
        call.isMissing = !callee.isEmpty() && !cell.jobs.contains(callee);
        m_calls << call;
    };
    for (const inform::Reference &reference : inform::references(job, line)) {
        if (reference.access == Access::Macro) {
            call.through = reference.name;
            const QByteArrayList jobs = jobsOfMacro(cell, reference.name);
            for (const QByteArray &each : jobs.isEmpty() ? QByteArrayList {QByteArray {}} : jobs)
                add(each);
        } else if (reference.access != Access::Reads && reference.access != Access::Writes) {
            call.how = howOf(reference.access);
            add(reference.name);
        }
    }
    if (hasUnknownTarget(part))
        add({});
}

QList<Call> CallTree::callsOf(const QByteArray &job) const
{
    QList<Call> result;
    std::ranges::copy_if(m_calls, std::back_inserter(result), [&](const Call &call) { return call.caller == job; });
    return result;
}

QList<Call> CallTree::callersOf(const QByteArray &job) const
{
    QList<Call> result;
    std::ranges::copy_if(m_calls, std::back_inserter(result), [&](const Call &call) { return call.callee == job; });
    return result;
}

QByteArrayList CallTree::heads() const { return m_heads; }

QByteArrayList CallTree::unused() const { return m_unused; }

bool CallTree::hasUnknownTargets() const
{
    return std::ranges::any_of(
        m_calls, [](const Call &call) { return call.callee.isEmpty() && call.through.isEmpty(); });
}

} // namespace cell
