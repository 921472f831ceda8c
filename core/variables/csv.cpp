// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "variables/csv.h"

#include "variables/sentences.h"
#include <QStringDecoder>
#include <algorithm>

using values::ErrorKind;
using values::failure;
using values::Result;

namespace variables {

namespace {

constexpr QChar quote {u'"'};

QChar separatorOf(QStringView text)
{
    constexpr std::array candidates {u',', u';', u'\t'};
    std::array<int, candidates.size()> counts {};
    bool isQuoted = false;
    for (const QChar character : text) {
        isQuoted ^= character == quote;
        if (isQuoted)
            continue;
        if (character == u'\n' || character == u'\r')
            break;
        if (const auto found = std::ranges::find(candidates, character.unicode()); found != candidates.end())
            ++counts[std::size_t(found - candidates.begin())];
    }
    return candidates[std::size_t(std::ranges::max_element(counts) - counts.begin())];
}

/// Takes a text apart, cell by cell.
class Scanner
{
public:
    Scanner(QStringView text, QChar separator) : m_rest {text}, m_separator {separator} { }

    [[nodiscard]] bool isAtEnd() const { return m_rest.isEmpty(); }

    Result<Line> nextLine()
    {
        Line result {m_line, {}};
        for (;;) {
            auto cell = m_rest.startsWith(quote) ? quotedCell() : plainCell();
            if (!cell)
                return tl::unexpected(cell.error());
            result.cells << *cell;
            if (!m_rest.startsWith(m_separator))
                break;
            m_rest = m_rest.sliced(1);
        }
        if (m_rest.startsWith(u"\r\n"))
            m_rest = m_rest.sliced(1);
        if (!m_rest.isEmpty())
            m_rest = m_rest.sliced(1);
        ++m_line;
        return result;
    }

private:
    [[nodiscard]] bool isEndOfCell(QChar character) const
    {
        return character == m_separator || character == u'\n' || character == u'\r';
    }

    QString take(qsizetype size)
    {
        QString taken = m_rest.first(size).toString();
        m_rest = m_rest.sliced(size);
        return taken;
    }

    Result<QString> plainCell()
    {
        const auto end = std::ranges::find_if(m_rest, [this](QChar character) { return isEndOfCell(character); });
        return take(end - m_rest.begin());
    }

    Result<QString> quotedCell()
    {
        const int firstLine = m_line;
        QString cell;
        do {
            m_rest = m_rest.sliced(1);
            const qsizetype end = m_rest.indexOf(quote);
            if (end < 0)
                return values::badInput(
                    Sentences::tr("Line %1: a cell begins with a quotation mark and does not end with one.")
                        .arg(firstLine));
            const QString part = take(end);
            m_line += int(part.count(u'\n'));
            cell += part;
            m_rest = m_rest.sliced(1);
            if (m_rest.startsWith(quote))
                cell += quote;
        } while (m_rest.startsWith(quote));
        if (!m_rest.isEmpty() && !isEndOfCell(m_rest.front()))
            return values::badInput(
                Sentences::tr("Line %1: there is text behind the quotation mark that ends a cell.").arg(m_line));
        return cell;
    }

    QStringView m_rest;
    QChar m_separator;
    int m_line = 1;
};

bool isBlank(const Line &line)
{
    return std::ranges::all_of(line.cells, [](const QString &cell) { return cell.trimmed().isEmpty(); });
}

} // namespace

Result<QString> textOfFile(QByteArrayView bytes)
{
    const auto marked = QStringConverter::encodingForData(bytes);
    QStringDecoder decoder {marked.value_or(QStringConverter::Utf8)};
    QString text = decoder.decode(bytes);
    if (decoder.hasError())
        return values::badInput(Sentences::tr("The file is not UTF-8: save it as “CSV UTF-8” and try again."));
    return text;
}

Result<Table> readTable(QStringView text)
{
    Table table {{}, separatorOf(text)};
    Scanner scanner {text, table.separator};
    while (!scanner.isAtEnd()) {
        auto line = scanner.nextLine();
        if (!line)
            return tl::unexpected(line.error());
        if (!isBlank(*line))
            table.lines << std::move(*line);
    }
    return table;
}

QString csvLine(const QStringList &cells, QChar separator)
{
    QStringList written;
    for (QString cell : cells) {
        const bool needsQuotes = std::ranges::any_of(cell, [separator](QChar character) {
            return character == separator || character == quote || character == u'\n' || character == u'\r';
        });
        written << (needsQuotes ? quote + cell.replace(QStringLiteral("\""), QStringLiteral("\"\"")) + quote : cell);
    }
    return written.join(separator) + QStringLiteral("\r\n");
}

} // namespace variables
