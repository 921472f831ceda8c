// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "protocol/text.h"
#include <QByteArrayView>
#include <QList>
#include <QString>
#include <initializer_list>
#include <optional>
#include <vector>

/// The text files of a controller, one grammar a file type (controller files reference). Bytes are split first and
/// decoded after: no separator is ever the second byte of a Shift-JIS character.
namespace cellfiles {

/// Something in a file that could not be understood. What could is kept.
struct Warning {
    int line = 0; ///< From 1; 0: the file as a whole.
    QString reason; ///< A whole, translated sentence.

    bool operator==(const Warning &) const = default;
};

/// The first `most` warnings of a file, and how many there are.
class Warnings
{
public:
    static constexpr int most = 200;

    void add(int line, const QString &reason)
    {
        if (++m_count <= most)
            m_list += Warning {line, reason};
    }
    [[nodiscard]] const QList<Warning> &list() const { return m_list; }
    [[nodiscard]] int count() const { return m_count; }
    [[nodiscard]] bool isEmpty() const { return m_count == 0; }

private:
    QList<Warning> m_list;
    int m_count = 0;
};

/// What a file holds, and what could not be understood of it.
template <typename Value> struct Parsed {
    Value value {};
    Warnings warnings {};
};

struct Line {
    QByteArrayView text; ///< Without its end.
    int number = 0; ///< From 1.
    bool isWhole = true; ///< False for a last line without an end: the file may be cut there.
};

/// A header ("//TOOL 1", "///NAME GRIPPER") and the lines below it up to the next header.
struct Block {
    int level = 0; ///< Number of slashes, 1 to 4; 0 for lines before the first header.
    QByteArrayView word; ///< "TOOL"
    QByteArrayView text; ///< "1": what stands behind the first blank.
    int line = 0;
    std::vector<Line> rows = {};
    QByteArrayView crc = {}; ///< Of a ///CRC line behind the header; it is neither a section nor a value.
};

struct Outline {
    std::vector<Block> blocks;
    int lineCount = 0;
    bool isCut = false; ///< The last line has no end.
};

/// The longest file that is taken apart; a longer one is a warning and nothing else.
constexpr qsizetype longestFile = 32 * 1024 * 1024;

/// Splits `file`, which must outlive the result. Lines end in CR LF or LF; LF alone, NUL bytes, an empty file and one
/// that is too long are warned of. If `words` are given, a line is a header only with one of them: names and texts may
/// begin with a slash.
[[nodiscard]] Outline outlineOf(
    QByteArrayView file, Warnings &warnings, std::initializer_list<QByteArrayView> words = {});

/// The values between the commas; an empty line is one empty value.
[[nodiscard]] QList<QByteArrayView> fieldsOf(QByteArrayView line);
/// Without blanks around it: digits with an optional sign, within 64 bits; nullopt for anything else.
[[nodiscard]] std::optional<qint64> integerFrom(QByteArrayView field);
/// The same within 32 bits.
[[nodiscard]] std::optional<qint32> wordFrom(QByteArrayView field);
/// A decimal number as it would be without its point: "1.5" with 3 decimals is 1500. More decimals than that, or other
/// characters, are nullopt. So a length is exact, in micrometres.
[[nodiscard]] std::optional<qint64> fixedFrom(QByteArrayView field, int decimals);
/// As many whole numbers as the line has; nullopt if one of them is none.
[[nodiscard]] std::optional<QList<qint64>> integersFrom(QByteArrayView line);
/// "1.500" from 1500 and 3.
[[nodiscard]] QString fixedText(qint64 value, int decimals);

} // namespace cellfiles
