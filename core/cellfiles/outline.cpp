// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "cellfiles/outline.h"

#include "cellfiles/sentences.h"
#include <algorithm>
#include <limits>

namespace cellfiles {

namespace {

constexpr int deepestLevel = 4;

int levelOf(QByteArrayView line)
{
    const auto end = std::ranges::find_if(line, [](char byte) { return byte != '/'; });
    const auto level = int(end - line.begin());
    return level <= deepestLevel ? level : 0;
}

Block headerOf(const Line &line, int level)
{
    const QByteArrayView rest = line.text.sliced(level);
    const auto blank = std::ranges::find(rest, ' ') - rest.begin();
    return {level, rest.first(blank), rest.sliced(std::min<qsizetype>(blank + 1, rest.size())).trimmed(), line.number};
}

class Splitter
{
public:
    Splitter(Warnings &warnings, std::initializer_list<QByteArrayView> words) : m_words {words}, m_warnings {warnings}
    {
    }

    void take(QByteArrayView file)
    {
        while (!file.isEmpty()) {
            const auto end = file.indexOf('\n');
            const bool isWhole = end >= 0;
            QByteArrayView text = isWhole ? file.first(end) : file;
            file = file.sliced(isWhole ? end + 1 : file.size());
            if (text.endsWith('\r'))
                text.chop(1);
            else if (isWhole)
                ++m_bareEnds;
            add({text, ++m_outline.lineCount, isWhole});
        }
        finish();
    }
    [[nodiscard]] Outline result() && { return std::move(m_outline); }

private:
    [[nodiscard]] bool isHeader(const Block &header) const
    {
        return header.level > 0 && (m_words.empty() || std::ranges::find(m_words, header.word) != m_words.end());
    }

    void add(const Line &line)
    {
        m_outline.isCut = !line.isWhole;
        if (line.text.contains('\0') && !std::exchange(m_hasNul, true))
            m_warnings.add(line.number, Sentences::tr("The line holds NUL bytes."));
        const Block header = headerOf(line, levelOf(line.text));
        if (header.level == 3 && header.word == "CRC" && !m_outline.blocks.empty())
            m_outline.blocks.back().crc = header.text;
        else if (isHeader(header))
            m_outline.blocks.push_back(header);
        else
            rows().push_back(line);
    }

    std::vector<Line> &rows()
    {
        if (m_outline.blocks.empty())
            m_outline.blocks.emplace_back();
        return m_outline.blocks.back().rows;
    }

    void finish()
    {
        if (m_bareEnds > 0)
            m_warnings.add(0,
                Sentences::tr("Lines end in LF alone. A pendant may take such a file for empty: convert it to CR LF "
                              "before it is loaded."));
        if (m_outline.isCut)
            m_warnings.add(m_outline.lineCount, Sentences::tr("The file ends within a line: it may be cut."));
    }

    std::vector<QByteArrayView> m_words;
    Warnings &m_warnings;
    Outline m_outline;
    int m_bareEnds = 0;
    bool m_hasNul = false;
};

} // namespace

Outline outlineOf(QByteArrayView file, Warnings &warnings, std::initializer_list<QByteArrayView> words)
{
    if (file.isEmpty())
        warnings.add(0, Sentences::tr("The file is empty."));
    if (file.size() > longestFile) {
        warnings.add(0, Sentences::tr("The file is too long to be read."));
        return {};
    }
    Splitter splitter {warnings, words};
    splitter.take(file);
    return std::move(splitter).result();
}

QList<QByteArrayView> fieldsOf(QByteArrayView line)
{
    QList<QByteArrayView> fields;
    for (qsizetype comma = line.indexOf(','); comma >= 0; comma = line.indexOf(',')) {
        fields << line.first(comma);
        line = line.sliced(comma + 1);
    }
    return fields << line;
}

std::optional<qint64> integerFrom(QByteArrayView field)
{
    const QByteArrayView plain = field.trimmed();
    const bool hasSign = plain.startsWith('-') || plain.startsWith('+');
    const QByteArrayView digits = plain.sliced(hasSign ? 1 : 0);
    if (digits.isEmpty() || digits.size() > 18
        || !std::ranges::all_of(digits, [](char c) { return c >= '0' && c <= '9'; }))
        return std::nullopt;
    qint64 value = 0;
    for (const char digit : digits)
        value = value * 10 + (digit - '0');
    return plain.startsWith('-') ? -value : value;
}

std::optional<qint32> wordFrom(QByteArrayView field)
{
    const auto value = integerFrom(field);
    using Word = std::numeric_limits<qint32>;
    return value && *value >= Word::min() && *value <= Word::max() ? std::optional {qint32(*value)} : std::nullopt;
}

std::optional<qint64> fixedFrom(QByteArrayView field, int decimals)
{
    const QByteArrayView plain = field.trimmed();
    const auto point = plain.indexOf('.');
    const QByteArrayView fraction = point < 0 ? QByteArrayView {} : plain.sliced(point + 1);
    QByteArray digits = (point < 0 ? plain : plain.first(point)).toByteArray() + fraction.toByteArray();
    if (fraction.size() > decimals || plain.size() > 18 || !integerFrom(digits) || fraction.startsWith('-'))
        return std::nullopt;
    digits.append(decimals - fraction.size(), '0');
    return integerFrom(digits);
}

std::optional<QList<qint64>> integersFrom(QByteArrayView line)
{
    QList<qint64> values;
    for (const QByteArrayView field : fieldsOf(line)) {
        const auto value = integerFrom(field);
        if (!value)
            return std::nullopt;
        values << *value;
    }
    return values;
}

QString fixedText(qint64 value, int decimals)
{
    const QString digits = QString::number(std::abs(value)).rightJustified(decimals + 1, u'0');
    QString text = value < 0 ? QStringLiteral("-") : QString {};
    text += QStringView {digits}.chopped(decimals);
    if (decimals > 0)
        text += u'.' + digits.right(decimals);
    return text;
}

} // namespace cellfiles
