// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "inform/statement.h"

#include <algorithm>

namespace inform {

namespace {

/// What stands between the first `open` and the last `close`.
QByteArrayView inner(QByteArrayView text, char open, char close)
{
    const qsizetype from = text.indexOf(open) + 1;
    const qsizetype to = text.lastIndexOf(close);
    return withoutBlanks(from > 0 ? text.sliced(from, (to >= from ? to : text.size()) - from) : QByteArrayView {});
}

std::optional<int> whole(QByteArrayView text)
{
    bool isNumber = false;
    const int number = text.toInt(&isNumber);
    return isNumber ? std::optional {number} : std::nullopt;
}

/// The number in brackets, or what says it.
void setIndex(Term &term, QByteArrayView index)
{
    term.number = whole(index);
    if (!term.number)
        term.index = index;
}

Term variable(QByteArrayView text, Term term)
{
    term.kind = TermKind::Variable;
    if (const auto name = variableName(text)) {
        term.type = name->type;
        term.isLocal = name->isLocal;
        term.isSystem = name->isSystem;
        term.number = name->number >= 0 ? std::optional {name->number} : std::nullopt;
        return term;
    }
    const qsizetype open = text.indexOf('[');
    if (open < 0) { // "$ANYTHING"
        term.isSystem = true;
        term.type = text.sliced(1);
        return term;
    }
    QByteArrayView type = text.first(open);
    term.isSystem = type.startsWith('$');
    term.isLocal = type.startsWith('L');
    term.type = term.isSystem || term.isLocal ? type.sliced(1) : type;
    setIndex(term, inner(text, '[', ']'));
    return term;
}

Term numbered(QByteArrayView text, TermKind kind)
{
    Term term {kind, text, text};
    term.type = text.first(text.indexOf('#'));
    setIndex(term, inner(text, '(', ')'));
    return term;
}

Term number(QByteArrayView text)
{
    Term term {TermKind::Number, text, text};
    term.value = text.toDouble();
    term.number = whole(text);
    return term;
}

Term point(QByteArrayView text)
{
    Term term {TermKind::Point, text, text};
    const auto name = pointName(text);
    term.type = name ? name->kind : QByteArrayView {};
    term.number = name ? std::optional {name->number} : std::nullopt;
    return term;
}

QByteArrayView withoutQuotes(QByteArrayView text)
{
    text = text.sliced(1);
    return text.endsWith('"') ? text.chopped(1) : text;
}

Term termOf(const Token &token, QByteArrayView line, const Aliases &aliases)
{
    const QByteArrayView text = token.in(line);
    switch (token.kind) {
    case TokenKind::Variable: return variable(text, {TermKind::Variable, text, text});
    case TokenKind::Alias: {
        const auto found = aliases.constFind(QByteArray::fromRawData(text.data(), text.size()));
        return variable(found == aliases.cend() ? text : QByteArrayView {*found}, {TermKind::Variable, text, text});
    }
    case TokenKind::Point: return point(text);
    case TokenKind::Signal: return numbered(text, TermKind::Signal);
    case TokenKind::Numbered: return numbered(text, TermKind::Numbered);
    case TokenKind::Number: return number(text);
    case TokenKind::String: return {TermKind::Text, text, withoutQuotes(text)};
    case TokenKind::Label: return {TermKind::Label, text, text.sliced(1)};
    case TokenKind::Job: return {TermKind::Job, text, text.sliced(4)};
    case TokenKind::Keyword: return {TermKind::Keyword, text, text};
    case TokenKind::Operator: return {TermKind::Operator, text, text};
    default: return {TermKind::Unknown, text, text};
    }
}

std::optional<Relation> relationOf(const Token &token, QByteArrayView line)
{
    static constexpr const char *signs[] {"=", "<>", "<", "<=", ">", ">="};
    const auto found = std::ranges::find_if(signs, [&](const char *sign) { return token.in(line) == sign; });
    if (token.kind != TokenKind::Operator || found == std::end(signs))
        return std::nullopt;
    return Relation(found - std::begin(signs));
}

/// Reads the tokens of one part from left to right.
class PartReader
{
public:
    PartReader(std::span<const Token> tokens, QByteArrayView line, const Aliases &aliases)
        : m_tokens {tokens}, m_line {line}, m_aliases {aliases}
    {
    }
    Part read();

private:
    void take(const Token &token);
    void takeKeyword(const Token &token);
    void takeElement(QByteArrayView text);
    bool takeCondition(const Token &token);
    void takeOperand(Term term);

    std::span<const Token> m_tokens;
    QByteArrayView m_line;
    const Aliases &m_aliases;
    std::size_t m_at = 0;
    Part m_part;
    QByteArrayView m_tag;
    QByteArrayView m_joiner;
    bool m_isExpression = false;
};

Part PartReader::read()
{
    for (; m_at < m_tokens.size(); ++m_at)
        take(m_tokens[m_at]);
    return std::move(m_part);
}

void PartReader::take(const Token &token)
{
    const QByteArrayView text = token.in(m_line);
    switch (token.kind) {
    case TokenKind::Word:
        m_part.word = text;
        m_part.row = findInstruction(text);
        return;
    case TokenKind::Tag: m_tag = text.endsWith('=') ? text.chopped(1) : text; return;
    case TokenKind::Keyword: return takeKeyword(token);
    case TokenKind::Element: return takeElement(inner(text, '(', ')'));
    default: break;
    }
    if (m_isExpression)
        m_part.expression.push_back(termOf(token, m_line, m_aliases));
    else if (!takeCondition(token))
        takeOperand(termOf(token, m_line, m_aliases));
}

void PartReader::takeKeyword(const Token &token)
{
    const QByteArrayView text = token.in(m_line);
    if (beginsCondition(text))
        m_joiner = text;
    else if (text == "EXPRESS")
        m_isExpression = true;
    else if (text == "TO" || text == "LABEL:")
        m_tag = text.endsWith(':') ? text.chopped(1) : text;
    else
        takeOperand(termOf(token, m_line, m_aliases));
}

void PartReader::takeElement(QByteArrayView text)
{
    if (m_isExpression && !m_part.expression.empty())
        m_part.expression.back().element = text;
    else if (!m_part.operands.empty())
        m_part.operands.back().term.element = text;
}

/// "IN#(1)=ON": three tokens.
bool PartReader::takeCondition(const Token &token)
{
    if (m_at + 2 >= m_tokens.size() || !m_tag.isEmpty())
        return false;
    const auto relation = relationOf(m_tokens[m_at + 1], m_line);
    if (!relation)
        return false;
    m_part.conditions.push_back({std::exchange(m_joiner, {}), termOf(token, m_line, m_aliases), *relation,
        termOf(m_tokens[m_at + 2], m_line, m_aliases)});
    m_at += 2;
    return true;
}

void PartReader::takeOperand(Term term) { m_part.operands.push_back({std::exchange(m_tag, {}), term}); }

} // namespace

const Term *Part::positional(int index) const
{
    for (const Operand &operand : operands) {
        if (operand.tag.isEmpty() && operand.term.kind != TermKind::Keyword && index-- == 0)
            return &operand.term;
    }
    return nullptr;
}

const Term *Part::tagged(QByteArrayView tag) const
{
    const auto found = std::ranges::find(operands, tag, &Operand::tag);
    return found == operands.end() ? nullptr : &found->term;
}

bool Part::has(QByteArrayView keyword) const
{
    return std::ranges::any_of(operands, [keyword](const Operand &operand) {
        return operand.tag.isEmpty() && operand.term.kind == TermKind::Keyword && operand.term.text == keyword;
    });
}

Term termOf(QByteArrayView text, const Aliases &aliases)
{
    const QByteArray padded = "X " + text.toByteArray(); // behind the word
    const auto tokens = tokenize(padded, aliases);
    if (tokens.size() != 2)
        return {TermKind::Unknown, text, text};
    const Token token {tokens[1].kind, 0, int(text.size())};
    return termOf(token, text, aliases);
}

Statement statement(const Job &job, int number)
{
    const Line &line = job.at(number);
    Statement result {line.kind, job.isLocked(number), job.isCommentedOut(number)};
    std::span<const Token> tokens = job.tokensOf(line);
    while (!tokens.empty() && tokens.front().kind == TokenKind::Prefix)
        tokens = tokens.subspan(1);
    if (tokens.empty())
        return result;
    const Token &last = tokens.back();
    if (last.kind == TokenKind::Comment)
        result.comment = last.in(line.text).sliced(1);
    else if (line.kind == LineKind::Label)
        result.label = last.in(line.text).sliced(1);
    if (line.kind != LineKind::Instruction)
        return result;
    if (last.kind == TokenKind::TrailingComment) {
        result.comment = last.in(line.text).sliced(2);
        tokens = tokens.first(tokens.size() - 1);
    }
    while (true) {
        const auto sign = std::ranges::find(tokens, TokenKind::PartSign, &Token::kind);
        const auto size = std::size_t(sign - tokens.begin());
        result.parts.push_back(PartReader {tokens.first(size), line.text, job.aliases}.read());
        if (sign == tokens.end())
            return result;
        tokens = tokens.subspan(size + 1);
    }
}

} // namespace inform
