// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "inform/token.h"

#include "inform/instructions.h"
#include <algorithm>

namespace inform {

namespace {

constexpr bool isBlank(char c) { return c == ' ' || c == '\t' || c == '\r'; }
constexpr bool isDigit(char c) { return c >= '0' && c <= '9'; }
constexpr bool isUpper(char c) { return c >= 'A' && c <= 'Z'; }
constexpr bool isLetter(char c) { return isUpper(c) || (c >= 'a' && c <= 'z'); }
constexpr bool isNameByte(char c) { return isLetter(c) || isDigit(c) || c == '_'; }
/// The first byte of a double-byte character, whatever the encoding.
constexpr bool isLead(char c) { return quint8(c) >= 0x81; }

bool isOneOf(QByteArrayView text, std::initializer_list<QByteArrayView> texts)
{
    return std::ranges::find(texts, text) != texts.end();
}

/// The number in `digits`, which must be `least` to 5 digits and nothing else; -1 otherwise.
int digitsOf(QByteArrayView digits, qsizetype least)
{
    if (digits.size() < least || digits.size() > 5 || !std::ranges::all_of(digits, isDigit))
        return -1;
    int number = 0;
    for (const char digit : digits)
        number = number * 10 + (digit - '0');
    return number;
}

/// "PX", "BP", "EX" or one of BIDRSP at the beginning.
qsizetype typeSize(QByteArrayView text)
{
    if (text.size() >= 2 && isOneOf(text.first(2), {"PX", "BP", "EX"}))
        return 2;
    return !text.isEmpty() && QByteArrayView("BIDRSP").contains(text.front()) ? 1 : 0;
}

bool isVariableType(QByteArrayView text)
{
    if (text.startsWith('L'))
        text = text.sliced(1);
    const qsizetype size = typeSize(text);
    return size > 0 && size == text.size();
}

/// Cuts one line into tokens.
class Lexer
{
public:
    Lexer(QByteArrayView line, const Aliases &aliases, std::vector<Token> &tokens)
        : m_line {line}, m_aliases {aliases}, m_tokens {tokens}, m_end {int(line.size())}
    {
        while (m_end > 0 && isBlank(line[m_end - 1]))
            --m_end;
    }
    void run();

private:
    [[nodiscard]] char peek(int ahead = 0) const { return m_at + ahead < m_end ? m_line[m_at + ahead] : '\0'; }
    [[nodiscard]] bool follows(QByteArrayView text) const { return m_line.sliced(m_at, m_end - m_at).startsWith(text); }
    [[nodiscard]] bool isAfterBlank() const { return m_at == 0 || isBlank(m_line[m_at - 1]); }
    [[nodiscard]] QByteArrayView from(int start) const { return m_line.sliced(start, m_at - start); }
    void skipBlanks();
    void add(TokenKind kind, int start);
    void rest(TokenKind kind);
    void until(TokenKind kind, char last);

    bool takePrefix(QByteArrayView prefix);
    bool takeEntry();
    void takePart();
    void takeOne();
    void takeIdentifier();
    void takeName(int start);
    void takeWord(int start);
    void takeSystemVariable();
    void takeNumber();
    void takeString();
    void takeLabel();
    void takeSign();
    void takeBracket();
    void takeComparison();
    void takeUnknown();
    [[nodiscard]] bool isNumberHere() const;
    [[nodiscard]] bool isFurtherPart() const;
    [[nodiscard]] TokenKind kindOf(QByteArrayView name) const;

    QByteArrayView m_line;
    const Aliases &m_aliases;
    std::vector<Token> &m_tokens;
    int m_at = 0;
    int m_end;
    TokenKind m_last = TokenKind::Unknown; ///< Of the token before.
    bool m_isJump = false; ///< In JUMP, whose label may hold blanks.
    bool m_isWordNext = true;
};

void Lexer::skipBlanks()
{
    while (m_at < m_end && isBlank(m_line[m_at]))
        ++m_at;
}

void Lexer::add(TokenKind kind, int start)
{
    m_tokens.push_back({kind, start, m_at - start});
    m_last = kind;
}

void Lexer::rest(TokenKind kind)
{
    const int start = std::exchange(m_at, m_end);
    add(kind, start);
}

/// To and with the next `last`, or to the end.
void Lexer::until(TokenKind kind, char last)
{
    const int start = m_at;
    const auto found = m_line.first(m_end).indexOf(last, m_at + 1);
    m_at = found < 0 ? m_end : int(found) + 1;
    add(kind, start);
}

bool Lexer::takePrefix(QByteArrayView prefix)
{
    if (!follows(prefix) || !(m_at + prefix.size() == m_end || isBlank(peek(int(prefix.size())))))
        return false;
    const int start = m_at;
    m_at += int(prefix.size());
    add(TokenKind::Prefix, start);
    skipBlanks();
    return true;
}

/// "C00000=1,2,3" of //POS.
bool Lexer::takeEntry()
{
    const auto equals = m_line.first(m_end).indexOf('=', m_at);
    if (equals < 0 || equals - m_at > 8 || !entryName(m_line.sliced(m_at, equals - m_at)))
        return false;
    const int start = std::exchange(m_at, int(equals));
    add(TokenKind::Point, start);
    ++m_at;
    add(TokenKind::Operator, m_at - 1);
    if (m_at < m_end)
        rest(TokenKind::Number);
    return true;
}

void Lexer::run()
{
    skipBlanks();
    if (m_at == m_end)
        return;
    if (peek() == '/')
        return rest(TokenKind::Header);
    if (takeEntry())
        return;
    takePrefix("EDTLCK");
    takePrefix("COMM");
    if (peek() == '\'')
        return rest(TokenKind::Comment);
    if (peek() == '*')
        return rest(TokenKind::Label);
    takePart();
}

void Lexer::takePart()
{
    for (skipBlanks(); m_at < m_end; skipBlanks())
        takeOne();
}

bool Lexer::isNumberHere() const
{
    const char c = peek();
    if (isDigit(c))
        return true;
    if (c == '.')
        return isDigit(peek(1));
    return (c == '-' || c == '+') && (isDigit(peek(1)) || (peek(1) == '.' && isDigit(peek(2))));
}

void Lexer::takeOne()
{
    const char c = peek();
    if (c == '/' && peek(1) == '/' && isAfterBlank())
        return rest(TokenKind::TrailingComment);
    if (isLetter(c) || c == '_')
        return takeIdentifier();
    if (m_isWordNext && isDigit(c)) // no instruction begins so
        return takeUnknown();
    if (isNumberHere())
        return takeNumber();
    switch (c) {
    case '"': return takeString();
    case '$': return takeSystemVariable();
    case '*': return takeLabel();
    case '+':
    case '-': return takeSign();
    case '(':
    case ')': return takeBracket();
    case '=':
    case '<':
    case '>':
    case '/': return takeComparison();
    default: return takeUnknown();
    }
}

void Lexer::takeIdentifier()
{
    const int start = m_at;
    while (m_at < m_end && isNameByte(m_line[m_at]))
        ++m_at;
    if (std::exchange(m_isWordNext, false))
        return takeWord(start);
    takeName(start);
}

/// The instruction; the $ of CHR$ belongs to it.
void Lexer::takeWord(int start)
{
    if (peek() == '$')
        ++m_at;
    add(TokenKind::Word, start);
    m_isJump = from(start) == "JUMP";
}

TokenKind Lexer::kindOf(QByteArrayView name) const
{
    if (variableName(name))
        return TokenKind::Variable;
    if (pointName(name))
        return TokenKind::Point;
    if (!m_aliases.isEmpty() && m_aliases.contains(QByteArray::fromRawData(name.data(), name.size())))
        return TokenKind::Alias;
    const bool isKeyword = std::ranges::all_of(name, [](char c) { return isUpper(c) || isDigit(c); });
    return isKeyword ? TokenKind::Keyword : TokenKind::Unknown;
}

void Lexer::takeName(int start)
{
    const QByteArrayView name = from(start);
    if (peek() == '#' && peek(1) == '(') {
        until(TokenKind::Numbered, ')');
        m_tokens.pop_back();
        return add(isSignalType(name) ? TokenKind::Signal : TokenKind::Numbered, start);
    }
    if (peek() == '[' && isVariableType(name)) {
        until(TokenKind::Variable, ']');
        m_tokens.pop_back();
        return add(TokenKind::Variable, start);
    }
    if (peek() == ':' && name == "LABEL") {
        ++m_at;
        return add(TokenKind::Keyword, start);
    }
    if (peek() == ':' && name == "JOB") {
        while (m_at < m_end && !isBlank(m_line[m_at]))
            ++m_at;
        return add(TokenKind::Job, start);
    }
    if (name.startsWith("ARGF")) {
        m_at = start + 4;
        return add(TokenKind::Tag, start);
    }
    if (isOneOf(name, {"U", "L"}) && (follows("/D=") || follows("/R="))) // of COMARCON
        m_at += 2;
    const TokenKind kind = kindOf(name);
    const bool isTag = peek() == '=' && (kind == TokenKind::Keyword || kind == TokenKind::Unknown);
    m_at += isTag ? 1 : 0;
    add(isTag ? TokenKind::Tag : kind, start);
}

void Lexer::takeSystemVariable()
{
    const int start = m_at++;
    while (m_at < m_end && isNameByte(m_line[m_at]))
        ++m_at;
    if (peek() == '[' && isVariableType(from(start + 1))) {
        until(TokenKind::Variable, ']');
        m_tokens.pop_back();
    }
    add(m_at > start + 1 ? TokenKind::Variable : TokenKind::Unknown, start);
}

void Lexer::takeNumber()
{
    const int start = m_at++;
    while (m_at < m_end && (isDigit(m_line[m_at]) || m_line[m_at] == '.'))
        ++m_at;
    add(TokenKind::Number, start);
}

void Lexer::takeString() { until(TokenKind::String, '"'); }

/// A label that is named; between blanks it is a multiplication.
void Lexer::takeLabel()
{
    const int start = m_at++;
    if (m_at == m_end || isBlank(peek()))
        return add(TokenKind::Operator, start);
    const auto isOver = [this] {
        return m_isJump ? follows(" IF ") || follows(" IFEXPRESS ") || follows("  ") : isBlank(peek());
    };
    while (m_at < m_end && !isOver())
        ++m_at;
    add(TokenKind::Label, start);
}

/// "+MOVJ": a blank before it, the word at once behind it.
bool Lexer::isFurtherPart() const
{
    if (peek() != '+' || !isUpper(peek(1)) || !isAfterBlank())
        return false;
    int end = m_at + 1;
    while (end < m_end && isNameByte(m_line[end]))
        ++end;
    const Instruction *row = findInstruction(m_line.sliced(m_at + 1, end - m_at - 1));
    return row && row->ownsPoints;
}

void Lexer::takeSign()
{
    const bool isPart = isFurtherPart();
    const int start = m_at++;
    add(isPart ? TokenKind::PartSign : TokenKind::Operator, start);
    m_isWordNext = m_isWordNext || isPart;
}

/// The element of a position or file, or a bracket of an expression, which stands between blanks.
void Lexer::takeBracket()
{
    const bool isElement = peek() == '(' && !isBlank(peek(1))
        && (m_last == TokenKind::Variable || m_last == TokenKind::Alias || m_last == TokenKind::Numbered);
    if (isElement)
        return until(TokenKind::Element, ')');
    const int start = m_at++;
    add(TokenKind::Operator, start);
}

void Lexer::takeComparison()
{
    const int start = m_at++;
    if (isOneOf(from(start), {"<", ">"}) && (peek() == '=' || (m_line[start] == '<' && peek() == '>')))
        ++m_at;
    add(TokenKind::Operator, start);
}

/// To the next blank, so that bytes of a double-byte character are not taken for more.
void Lexer::takeUnknown()
{
    const int start = m_at;
    while (m_at < m_end && !isBlank(m_line[m_at]))
        m_at += isLead(m_line[m_at]) && m_at + 1 < m_end ? 2 : 1;
    m_isWordNext = false;
    add(TokenKind::Unknown, start);
}

} // namespace

void tokenize(QByteArrayView line, const Aliases &aliases, std::vector<Token> &tokens)
{
    Lexer {line, aliases, tokens}.run();
}

std::vector<Token> tokenize(QByteArrayView line, const Aliases &aliases)
{
    std::vector<Token> tokens;
    tokenize(line, aliases, tokens);
    return tokens;
}

std::optional<VariableName> variableName(QByteArrayView text)
{
    VariableName name;
    name.isSystem = text.startsWith('$');
    if (name.isSystem)
        text = text.sliced(1);
    else if (text.startsWith('L'))
        name.isLocal = true;
    if (name.isLocal)
        text = text.sliced(1);
    const qsizetype size = typeSize(text);
    name.type = text.first(size);
    name.number = digitsOf(text.sliced(size), 3);
    if (size > 0 && name.number >= 0)
        return name;
    if (!name.isSystem || !isOneOf(text, {"RV", "ERRNO"}))
        return std::nullopt;
    name.type = text;
    return name;
}

std::optional<PointName> pointName(QByteArrayView text)
{
    const bool isOther = text.size() > 1 && (text[0] == 'B' || text[0] == 'E') && text[1] == 'C';
    const qsizetype size = isOther ? 2 : text.startsWith('C') ? 1 : 0;
    const int number = size > 0 ? digitsOf(text.sliced(size), 3) : -1;
    return number >= 0 ? std::optional {PointName {text.first(size), number}} : std::nullopt;
}

std::optional<PointName> entryName(QByteArrayView text)
{
    if (const auto point = pointName(text))
        return point;
    const auto variable = variableName(text);
    const bool isEntry =
        variable && !variable->isLocal && !variable->isSystem && isOneOf(variable->type, {"P", "BP", "EX"});
    return isEntry ? std::optional {PointName {variable->type, variable->number}} : std::nullopt;
}

bool isSignalType(QByteArrayView type)
{
    return isOneOf(type, {"IN", "OT", "IG", "OG", "IGH", "OGH", "IGU", "OGU", "SIN", "SOUT", "RIN", "AO", "AT"});
}

} // namespace inform
