// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "inform/jobdiffparts.h"
#include "inform/statement.h"

#include <algorithm>

namespace inform {

namespace {

using Edits = QList<JobEdit>;

/// Something of an instruction that can differ: an operand, a condition, an expression.
struct Item {
    QByteArray tag; ///< "V", "IF", "EXPRESS", "ARGF"; empty for operands that have none.
    QByteArray text;

    bool operator==(const Item &other) const = default;
};

/// From the first byte of one view to the last byte of another one of the same line.
QByteArray stretch(QByteArrayView first, QByteArrayView last)
{
    return QByteArray(first.data(), last.data() + last.size() - first.data());
}

QByteArray textOf(const Term &term)
{
    const QByteArray written = term.written.toByteArray();
    return term.element.isEmpty() ? written : written + " (" + term.element.toByteArray() + ')';
}

bool continues(const Condition &condition)
{
    return condition.joiner.startsWith("AND") || condition.joiner.startsWith("OR");
}

/// "IF IN#(1)=ON" is one item, what is joined to it by ANDEXP and the like belongs to it.
void addConditions(QList<Item> &items, const Part &part)
{
    for (auto first = part.conditions.begin(); first != part.conditions.end();) {
        const auto end = std::find_if_not(first + 1, part.conditions.end(), continues);
        items << Item {first->joiner.toByteArray(), stretch(first->left.written, (end - 1)->right.written)};
        first = end;
    }
}

QList<Item> itemsOf(const Part &part)
{
    QList<Item> items;
    for (const Operand &operand : part.operands) {
        if (operand.term.kind != TermKind::Point)
            items << Item {operand.tag.toByteArray(), textOf(operand.term)};
    }
    addConditions(items, part);
    if (!part.expression.empty())
        items << Item {"EXPRESS", stretch(part.expression.front().written, part.expression.back().written)};
    return items;
}

/// The points' kinds, in their order: their numbers say nothing.
QByteArrayList pointsOf(const Part &part)
{
    QByteArrayList kinds;
    for (const Operand &operand : part.operands) {
        if (operand.term.kind == TermKind::Point)
            kinds << operand.term.type.toByteArray();
    }
    return kinds;
}

QByteArrayList untagged(const QList<Item> &items)
{
    QByteArrayList texts;
    for (const Item &item : items) {
        if (item.tag.isEmpty())
            texts << item.text;
    }
    return texts;
}

/// The n-th item with a tag; nullptr if there are fewer.
const Item *find(const QList<Item> &items, const QByteArray &tag, int index)
{
    for (const Item &item : items) {
        if (item.tag == tag && index-- == 0)
            return &item;
    }
    return nullptr;
}

bool isSame(const Item &older, const Item &newer)
{
    const auto a = tokenize("X " + older.text); // behind the word
    const auto b = tokenize("X " + newer.text);
    return std::ranges::equal(a, b, [&](const Token &x, const Token &y) {
        return canonical(x, "X " + older.text) == canonical(y, "X " + newer.text);
    });
}

/// Two versions of one instruction with the same word.
class PartDiff
{
public:
    PartDiff(const Part &older, const Part &newer, JobEdit edit)
        : m_older {itemsOf(older)}, m_newer {itemsOf(newer)}, m_edit {std::move(edit)}
    {
        m_edit.instruction += newer.word.toByteArray();
        m_isAlike = pointsOf(older) == pointsOf(newer) && untagged(m_older).size() == untagged(m_newer).size();
    }

    /// They can be compared operand by operand.
    [[nodiscard]] bool isAlike() const { return m_isAlike; }
    [[nodiscard]] Edits edits();

private:
    void add(const Item *older, const Item *newer, const QByteArray &tag);

    QList<Item> m_older;
    QList<Item> m_newer;
    JobEdit m_edit;
    bool m_isAlike = false;
    Edits m_edits;
};

/// "SET B005: 1 → 2" names the target, which is its first operand.
void PartDiff::add(const Item *older, const Item *newer, const QByteArray &tag)
{
    if (older && newer && isSame(*older, *newer))
        return;
    JobEdit edit = m_edit;
    const QByteArrayList texts = untagged(m_newer);
    const bool hasTarget =
        tag.isEmpty() && newer && newer->text != texts.value(0) && untagged(m_older).value(0) == texts.value(0);
    if (hasTarget)
        edit.instruction += ' ' + texts.first();
    edit.subject = tag;
    edit.older = older ? older->text : QByteArray {};
    edit.newer = newer ? newer->text : QByteArray {};
    m_edits << edit;
}

Edits PartDiff::edits()
{
    QHash<QByteArray, int> seen;
    for (const Item &item : m_newer)
        add(find(m_older, item.tag, seen[item.tag]++), &item, item.tag);
    QHash<QByteArray, int> known;
    for (const Item &item : m_older) {
        if (!find(m_newer, item.tag, known[item.tag]++))
            add(&item, nullptr, item.tag);
    }
    return m_edits;
}

bool haveSameWords(const Statement &older, const Statement &newer)
{
    return !newer.parts.empty() && std::ranges::equal(older.parts, newer.parts, {}, &Part::word, &Part::word);
}

/// The groups of the n-th part of a line (reference §2.2).
QByteArray groupOf(const Job &job, std::size_t part)
{
    return part == 0 ? QByteArray {} : job.groups.value(qsizetype(part)).join(',');
}

/// nullopt if the lines have to be shown as a whole.
std::optional<Edits> diffParts(const Statement &older, const Statement &newer, const Job &job, int line)
{
    if (!haveSameWords(older, newer))
        return std::nullopt;
    Edits edits;
    for (std::size_t part = 0; part < newer.parts.size(); ++part) {
        JobEdit edit {EditKind::OperandChanged, line, part > 0 ? "+" : "", groupOf(job, part)};
        PartDiff diff {older.parts[part], newer.parts[part], edit};
        if (!diff.isAlike())
            return std::nullopt;
        edits << diff.edits();
    }
    return edits;
}

/// The line without EDTLCK, COMM and the trailing comment, for telling whether anything else changed.
QByteArray bare(const Job &job, int number)
{
    QByteArray key;
    for (const Token &token : job.tokensOf(job.at(number))) {
        const QByteArrayView text = job.at(number).text;
        if (token.kind == TokenKind::Point && job.point(token.in(text)))
            key += pointName(token.in(text))->kind.toByteArray() + ' ';
        else if (token.kind != TokenKind::Prefix && token.kind != TokenKind::TrailingComment)
            key += canonical(token, text) + ' ';
    }
    return key;
}

void addPrefixes(Edits &edits, const Statement &older, const Statement &newer, const JobEdit &edit)
{
    const auto add = [&](bool was, bool is, EditKind on, EditKind off) {
        if (was == is)
            return;
        edits << edit;
        edits.last().kind = is ? on : off;
    };
    add(older.isCommentedOut, newer.isCommentedOut, EditKind::CommentedOut, EditKind::CommentedIn);
    add(older.isLocked, newer.isLocked, EditKind::Locked, EditKind::Unlocked);
}

} // namespace

QList<JobEdit> diffStatements(const Job &older, int oldLine, const Job &newer, int newLine, const Clean &clean)
{
    const Statement before = statement(older, oldLine);
    const Statement after = statement(newer, newLine);
    const JobEdit edit {EditKind::LineChanged, newLine, {}, {}, {}, older.instruction(oldLine).toByteArray(),
        newer.instruction(newLine).toByteArray()};
    Edits edits;
    addPrefixes(edits, before, after, edit);
    const bool hasRemark = before.kind == LineKind::Instruction && after.kind == LineKind::Instruction;
    const auto cleaned = [&clean](
                             QByteArrayView text) { return clean ? clean(text.toByteArray()) : text.toByteArray(); };
    if (hasRemark && cleaned(before.comment) != cleaned(after.comment))
        edits << JobEdit {
            EditKind::RemarkChanged, newLine, {}, {}, {}, before.comment.toByteArray(), after.comment.toByteArray()};
    if (bare(older, oldLine) == bare(newer, newLine))
        return edits;
    const auto operands = diffParts(before, after, newer, newLine);
    return edits << (operands && !operands->isEmpty() ? *operands : Edits {edit});
}

} // namespace inform
