// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include <QByteArray>
#include <QHash>
#include <optional>
#include <vector>

/// INFORM, line by line: bytes are cut into tokens first and decoded afterwards (reference §1, §5). The second byte of
/// a double-byte character is never syntax.
namespace inform {

/// Reference §5.5.
enum class TokenKind : quint8 {
    Header, ///< A whole pseudo instruction, "///TOOL 0".
    Comment, ///< A whole line, "'TEXT".
    Label, ///< "*NEXT", where it stands and where it is named. It may hold blanks.
    Prefix, ///< "EDTLCK" or "COMM".
    PartSign, ///< The + before the instruction of a further group.
    Word, ///< The instruction, known or not.
    Tag, ///< "VJ=", "ARGF": the value is the next token.
    Keyword, ///< "ON", "IF", "NWAIT", "EXPRESS", "LABEL:", "SUB1".
    Job, ///< "JOB:NAME"
    Alias, ///< A name of //ALIAS.
    Variable, ///< "B012", "LD[LI000]", "$PX001", "$RV"
    Point, ///< "C00012", "BC00012", "EC00012"
    Signal, ///< "IN#(12)", "OG#(B001)"
    Numbered, ///< Other things with a number: "UF#(1)", "MJ#(2)", "CV#(1)".
    Element, ///< "(3)" behind a position variable or a file.
    Number,
    Operator, ///< "=", "<=", "+", "("
    String, ///< With its quotation marks.
    TrailingComment, ///< "//TEXT" to the end of the line.
    Unknown, ///< Bytes that mean nothing here.
};

/// Where a token stands in its line, in bytes.
struct Token {
    TokenKind kind;
    int at;
    int size;

    [[nodiscard]] QByteArrayView in(QByteArrayView line) const { return line.sliced(at, size); }
    bool operator==(const Token &) const = default;
};

/// The variable behind each name of //ALIAS (reference §2.3), such as "D012" of "TOTAL".
using Aliases = QHash<QByteArray, QByteArray>;

/// Appends the tokens of one line, without line ending; what lies between them is blank. Any bytes will do. For text
/// that is decoded already, QString::toLatin1() gives bytes whose offsets are those of the text.
void tokenize(QByteArrayView line, const Aliases &aliases, std::vector<Token> &tokens);
[[nodiscard]] std::vector<Token> tokenize(QByteArrayView line, const Aliases &aliases = {});

/// "B012", "LPX005", "$PX001", "$RV".
struct VariableName {
    QByteArrayView type; ///< "B", "PX": without L and $. "RV" and "ERRNO" of "$RV" and "$ERRNO".
    int number = -1; ///< -1 for $RV and $ERRNO.
    bool isLocal = false;
    bool isSystem = false;
};
/// nullopt unless it is all of a variable's name, without brackets.
[[nodiscard]] std::optional<VariableName> variableName(QByteArrayView text);

/// "C00012" → C and 12.
struct PointName {
    QByteArrayView kind; ///< "C", "BC", "EC"; "P", "BP", "EX" among the entries of //POS.
    int number = 0;
};
[[nodiscard]] std::optional<PointName> pointName(QByteArrayView text);
/// An entry of //POS, "P00012" as well.
[[nodiscard]] std::optional<PointName> entryName(QByteArrayView text);

/// Whether "IN" of "IN#(1)" is a signal rather than a file (reference §5.2).
[[nodiscard]] bool isSignalType(QByteArrayView type);

} // namespace inform
