// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "cell/waiting.h"

#include <algorithm>
#include <cmath>

using inform::Relation;
using inform::Term;
using inform::TermKind;
using inform::Wait;

namespace cell {

namespace {

using namespace std::chrono_literals;

Side constant(const Term &term, double value) { return {Side::Kind::Constant, term.written.toByteArray(), value}; }

Side keyword(const Term &term)
{
    if (term.text == "ON" || term.text == "OFF")
        return constant(term, term.text == "ON" ? 1 : 0);
    return {Side::Kind::Unknown, term.written.toByteArray()};
}

QByteArray referenceOf(const Term &term, int number)
{
    const QByteArray digits = QByteArray::number(number);
    if (term.kind == TermKind::Variable)
        return term.type.toByteArray() + digits.rightJustified(3, '0');
    return term.type.toByteArray() + "#(" + digits + ')';
}

/// What an index says: a variable, or nothing that can be read.
std::optional<Subject> indexOf(const Term &term, const inform::Aliases &aliases)
{
    const Term index = inform::termOf(term.index, aliases);
    if (index.kind != TermKind::Variable || index.isLocal || index.isSystem || !index.number)
        return std::nullopt;
    const auto subjects = subjectsOf(referenceOf(index, *index.number));
    return subjects.isEmpty() ? std::nullopt : std::optional {subjects.first()};
}

Side place(const Term &term, const inform::Aliases &aliases)
{
    Side side {Side::Kind::Live, term.written.toByteArray()};
    if (term.isLocal) {
        side.kind = Side::Kind::Local;
    } else if (term.type == "S") {
        side.kind = Side::Kind::Text;
    } else if (term.isIndirect()) {
        side.kind = Side::Kind::Indirect;
        side.type = term.type.toByteArray() + (term.kind == TermKind::Variable ? "" : "#");
        side.index = indexOf(term, aliases);
    } else if (term.number && !term.isSystem) {
        side.subjects = subjectsOf(referenceOf(term, *term.number));
    }
    if (side.kind == Side::Kind::Live
        && (side.subjects.isEmpty() || side.subjects.first().kind == Subject::Kind::Numbered))
        side.kind = Side::Kind::Unknown;
    return side;
}

Side sideOf(const Term &term, const inform::Aliases &aliases)
{
    switch (term.kind) {
    case TermKind::Number: return constant(term, term.value);
    case TermKind::Keyword: return keyword(term);
    case TermKind::Text: return {Side::Kind::Text, term.written.toByteArray()};
    case TermKind::Variable:
    case TermKind::Signal:
    case TermKind::Numbered: return place(term, aliases);
    default: return {Side::Kind::Unknown, term.written.toByteArray()};
    }
}

/// T= in seconds, or a variable in hundredths or thousandths of a second (INFORM reference §5.3).
void takeTime(Waiting &waiting, const Term *time, const inform::Aliases &aliases, protocol::Model model)
{
    if (!time)
        return;
    const bool isFine = model == protocol::Model::FS100 || model == protocol::Model::YRC1000micro;
    waiting.timeUnit = isFine ? 1ms : 10ms;
    const Side side = sideOf(*time, aliases);
    if (side.kind == Side::Kind::Constant)
        waiting.time = std::chrono::milliseconds {std::llround(side.value * 1000)};
    else if (side.kind == Side::Kind::Live)
        waiting.timeVariable = side.subjects.first();
}

int numberOf(const inform::Part &part)
{
    for (const inform::Operand &operand : part.operands) {
        const QByteArrayView text = operand.term.text;
        if (text.startsWith("SUB"))
            return text.sliced(3).toInt();
        if (operand.tag.isEmpty() && operand.term.kind == TermKind::Number)
            return int(operand.term.value);
    }
    return 0;
}

bool isJudged(const inform::Condition &condition, Wait wait)
{
    const bool isOfMove = condition.joiner == "UNTIL" || condition.joiner.endsWith("SRCH");
    return wait == Wait::Condition || isOfMove;
}

bool isEqual(double left, double right) { return left == right; }

bool compares(double left, Relation relation, double right)
{
    switch (relation) {
    case Relation::Equal: return isEqual(left, right);
    case Relation::Unequal: return !isEqual(left, right);
    case Relation::Less: return left < right;
    case Relation::LessOrEqual: return left <= right;
    case Relation::Greater: return left > right;
    case Relation::GreaterOrEqual: return left >= right;
    }
    return false;
}

/// Several bits make one number, lowest first.
std::optional<double> numberFrom(const QList<Subject> &subjects, const ValueOf &valueOf)
{
    if (subjects.size() == 1)
        return valueOf(subjects.first());
    double number = 0;
    for (qsizetype bit = 0; bit < subjects.size(); ++bit) {
        const auto value = valueOf(subjects[bit]);
        if (!value)
            return std::nullopt;
        number += *value != 0 ? std::ldexp(1.0, int(bit)) : 0.0;
    }
    return subjects.isEmpty() ? std::nullopt : std::optional {number};
}

} // namespace

Waiting waitingAt(const inform::Job &job, int line, protocol::Model model)
{
    Waiting waiting;
    if (line < 0 || line >= job.lineCount())
        return waiting;
    const inform::Statement statement = inform::statement(job, line);
    const inform::Instruction *row = statement.isCommentedOut ? nullptr : statement.row();
    if (!row || row->wait == Wait::No)
        return waiting;
    waiting.wait = row->wait;
    const inform::Part &part = statement.parts.front();
    waiting.number = row->wait == Wait::Task || row->wait == Wait::Tasks ? numberOf(part) : 0;
    takeTime(waiting, part.tagged("T"), job.aliases, model);
    for (const inform::Condition &condition : part.conditions) {
        if (isJudged(condition, row->wait))
            waiting.comparisons.push_back({condition.joiner.startsWith("OR"), sideOf(condition.left, job.aliases),
                condition.relation, sideOf(condition.right, job.aliases)});
    }
    if (waiting.wait == Wait::Condition && waiting.comparisons.empty())
        waiting.wait = Wait::Time; // WAIT T= alone
    return waiting;
}

QList<Subject> resolved(const Side &side, const ValueOf &valueOf)
{
    if (side.kind == Side::Kind::Live)
        return side.subjects;
    const auto index = side.kind == Side::Kind::Indirect && side.index ? valueOf(*side.index) : std::nullopt;
    if (!index)
        return {};
    const QByteArray number = QByteArray::number(int(*index));
    return subjectsOf(
        side.type.endsWith('#') ? side.type + '(' + number + ')' : side.type + number.rightJustified(3, '0'));
}

std::optional<double> valueOf(const Side &side, const ValueOf &valueOf)
{
    if (side.kind == Side::Kind::Constant)
        return side.value;
    return numberFrom(resolved(side, valueOf), valueOf);
}

std::optional<bool> holds(const Comparison &comparison, const ValueOf &valueOf)
{
    const auto left = cell::valueOf(comparison.left, valueOf);
    const auto right = cell::valueOf(comparison.right, valueOf);
    if (!left || !right)
        return std::nullopt;
    return compares(*left, comparison.relation, *right);
}

/// Alternatives of comparisons that must all hold. One that is known to be false decides its row, a row that is known
/// to hold decides all.
std::optional<bool> holds(const std::vector<Comparison> &comparisons, const ValueOf &valueOf)
{
    bool isUnknown = false;
    std::optional<bool> row = true;
    const auto finishRow = [&] {
        isUnknown = isUnknown || !row;
        return row.value_or(false);
    };
    for (std::size_t i = 0; i < comparisons.size(); ++i) {
        if (i > 0 && comparisons[i].isAlternative) {
            if (finishRow())
                return true;
            row = true;
        }
        const auto one = holds(comparisons[i], valueOf);
        if (one == std::optional {false} || row == std::optional {false})
            row = false;
        else if (!one)
            row = std::nullopt;
    }
    if (comparisons.empty() || finishRow())
        return !comparisons.empty() ? std::optional {true} : std::nullopt;
    return isUnknown ? std::nullopt : std::optional {false};
}

QList<Subject> neededFor(const Waiting &waiting, const ValueOf &valueOf)
{
    QList<Subject> needed;
    const auto add = [&needed](const QList<Subject> &subjects) {
        for (const Subject &subject : subjects) {
            if (!needed.contains(subject))
                needed << subject;
        }
    };
    for (const Comparison &comparison : waiting.comparisons) {
        for (const Side *side : {&comparison.left, &comparison.right}) {
            if (side->index)
                add({*side->index});
            add(resolved(*side, valueOf));
        }
    }
    if (waiting.timeVariable)
        add({*waiting.timeVariable});
    return needed;
}

} // namespace cell
