// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "inform/references.h"

#include <algorithm>

namespace inform {

namespace {

/// 'r', 'w', 'm' or '-' for the operand at `position` (Instruction::operands).
char accessAt(const Instruction *row, int position)
{
    const QByteArrayView pattern = row ? row->operands : "";
    if (pattern.isEmpty())
        return 'r';
    if (position < pattern.size() && pattern[position] != '*')
        return pattern[position];
    return pattern.endsWith('*') ? pattern[pattern.size() - 2] : 'r';
}

QByteArray digits(int number, int width) { return QByteArray::number(number).rightJustified(width, '0'); }

/// Gathers what one statement refers to.
class Gatherer
{
public:
    explicit Gatherer(const Job &job) : m_job {job} { }
    void take(const Part &part);
    [[nodiscard]] QList<Reference> result() const { return m_result; }

private:
    void takeOperand(const Part &part, const Operand &operand, int &position);
    void takeTerm(const Term &term, char access);
    void takeVariable(const Term &term, Access access);
    void takeJob(const Part &part, const Term &term);
    void takeIndex(QByteArrayView index);
    void takeCount(const Part &part);
    void takeBesides(const Part &part, const char *names, Access access);
    void add(Reference reference);
    [[nodiscard]] QByteArrayList typesOf(QByteArrayView type) const;

    const Job &m_job;
    QList<Reference> m_result;
    int m_depth = 0; ///< Of brackets.
};

void Gatherer::add(Reference reference)
{
    if (!m_result.contains(reference))
        m_result << std::move(reference);
}

/// PX is each kind of position that the job's groups have (reference §5.1).
QByteArrayList Gatherer::typesOf(QByteArrayView type) const
{
    if (type != "PX")
        return {type.toByteArray()};
    QByteArrayList types;
    for (const QByteArrayList &group : m_job.groups) {
        for (const QByteArray &each : group) {
            const QByteArray kind = each.startsWith("BS") ? "BP" : each.startsWith("ST") ? "EX" : "P";
            if (!types.contains(kind))
                types << kind;
        }
    }
    return types.isEmpty() ? QByteArrayList {"P"} : types;
}

/// B[I000] reads I000. What stands in its own brackets is read too, but not without end.
void Gatherer::takeIndex(QByteArrayView index)
{
    constexpr int deepest = 4;
    if (index.isEmpty() || m_depth >= deepest)
        return;
    ++m_depth;
    takeTerm(termOf(index, m_job.aliases), 'r');
    --m_depth;
}

void Gatherer::takeVariable(const Term &term, Access access)
{
    if (term.isSystem) {
        const QByteArray number = term.number ? digits(*term.number, 3) : QByteArray {};
        return add({access, '$' + term.type.toByteArray() + number});
    }
    for (const QByteArray &type : typesOf(term.type)) {
        const QByteArray name = (term.isLocal ? "L" : "") + type;
        const QByteArray number = term.number ? digits(*term.number, 3) : QByteArray {};
        add({access, name + number, term.isIndirect(), term.isLocal, term.element.toByteArray()});
    }
}

void Gatherer::takeTerm(const Term &term, char access)
{
    if (access == '-')
        return;
    if (access == 'm') {
        takeTerm(term, 'r');
        return takeTerm(term, 'w');
    }
    const Access how = access == 'w' ? Access::Writes : Access::Reads;
    takeIndex(term.index);
    takeIndex(term.element);
    switch (term.kind) {
    case TermKind::Variable: return takeVariable(term, how);
    case TermKind::Point: return add({how, term.type.toByteArray() + digits(term.number.value_or(0), 5)});
    case TermKind::Signal:
    case TermKind::Numbered: {
        const QByteArray type = term.type.toByteArray() + '#';
        const QByteArray name = term.number ? type + '(' + QByteArray::number(*term.number) + ')' : type;
        return add({how, name, term.isIndirect(), false,
            term.kind == TermKind::Numbered ? term.element.toByteArray() : QByteArray {}});
    }
    default: return;
    }
}

void Gatherer::takeJob(const Part &part, const Term &term)
{
    const Access access = part.word == "PSTART" ? Access::Starts
        : part.word == "JUMP"                   ? Access::JumpsTo
                                                : Access::Calls;
    add({access, term.text.toByteArray()});
}

void Gatherer::takeOperand(const Part &part, const Operand &operand, int &position)
{
    const Term &term = operand.term;
    if (term.kind == TermKind::Job)
        return takeJob(part, term);
    if (term.kind == TermKind::Numbered && term.type == "MJ") {
        takeIndex(term.index);
        return add(
            {Access::Macro, "MJ#(" + (term.number ? QByteArray::number(*term.number) : term.index.toByteArray()) + ')',
                term.isIndirect()});
    }
    if (!operand.tag.isEmpty())
        return takeTerm(term, 'r');
    if (term.kind != TermKind::Keyword)
        takeTerm(term, term.kind == TermKind::Point ? 'r' : accessAt(part.row, position++));
}

/// CLEAR B003 10 writes ten of them, CLEAR B003 ALL all from there on.
void Gatherer::takeCount(const Part &part)
{
    const Term *first = part.positional(0);
    const Term *count = part.positional(1);
    if (part.word != "CLEAR" || !first || first->kind != TermKind::Variable || !first->number)
        return;
    Term each = *first;
    if (part.has("ALL")) {
        each.number.reset();
        each.index = "ALL";
        for (const QByteArray &type : typesOf(each.type))
            add({Access::Writes, (each.isLocal ? "L" : "") + type, true, each.isLocal});
        return;
    }
    const int last = *first->number + std::clamp(count ? count->number.value_or(1) : 1, 1, 10000);
    for (int number = *first->number; number < last; ++number) {
        each.number = number;
        takeVariable(each, Access::Writes);
    }
}

/// "$PX01#" with the number of the first operand.
void Gatherer::takeBesides(const Part &part, const char *names, Access access)
{
    const Term *first = part.positional(0);
    const QByteArray number = first && first->kind == TermKind::Number ? first->text.toByteArray() : QByteArray {};
    for (const QByteArrayView each : splitAt(names, ' ')) {
        if (!each.isEmpty() && !(each.contains('#') && number.isEmpty()))
            add({access, each.toByteArray().replace('_', ' ').replace('#', number)});
    }
}

void Gatherer::take(const Part &part)
{
    int position = 0;
    for (const Operand &operand : part.operands)
        takeOperand(part, operand, position);
    takeCount(part);
    for (const Term &term : part.expression)
        takeTerm(term, 'r');
    bool isSearch = false;
    for (const Condition &condition : part.conditions) {
        takeTerm(condition.left, 'r');
        takeTerm(condition.right, 'r');
        isSearch = isSearch || condition.joiner.endsWith("SRCH");
    }
    if (isSearch) // reference §6.8
        takeBesides(part, "$B002 $PX002 $PX003", Access::Writes);
    if (!part.row)
        return;
    takeBesides(part, part.row->alsoReads, Access::Reads);
    if (part.word != "RET" || part.positional(0))
        takeBesides(part, part.row->alsoWrites, Access::Writes);
}

} // namespace

QList<Reference> references(const Job &job, int number)
{
    const Statement line = statement(job, number);
    if (line.isCommentedOut)
        return {};
    Gatherer gatherer {job};
    for (const Part &part : line.parts)
        gatherer.take(part);
    return gatherer.result();
}

QList<LabelUse> labelUses(const Statement &statement)
{
    QList<LabelUse> uses;
    for (const Part &part : statement.parts) {
        for (const Operand &operand : part.operands) {
            if (operand.term.kind == TermKind::Label)
                uses << LabelUse {operand.term.text.toByteArray()};
            else if (operand.tag == "LABEL")
                uses << LabelUse {
                    operand.term.kind == TermKind::Number ? operand.term.text.toByteArray() : QByteArray {}};
        }
    }
    return uses;
}

} // namespace inform
