// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "inform/job.h"

#include <algorithm>

namespace inform {

namespace {

QByteArrayList listOf(QByteArrayView text)
{
    QByteArrayList result;
    for (const QByteArrayView part : splitAt(text, ','))
        result << part.toByteArray();
    return result;
}

/// Up to as many numbers as there are places; nullopt if one of them is none, or there are too many.
template <std::size_t Size> std::optional<std::array<int, Size>> numbersOf(QByteArrayView text)
{
    const auto parts = splitAt(text, ',');
    std::array<int, Size> result {};
    bool isGood = parts.size() <= Size;
    for (std::size_t index = 0; isGood && index < parts.size(); ++index)
        result[index] = parts[index].toUShort(&isGood);
    return isGood ? std::optional {result} : std::nullopt;
}

/// Goes through the lines of a job once and fills in what they say.
class Reader
{
public:
    Job read(const QByteArray &text);

private:
    LineKind take(QByteArrayView line, int index);
    void takeHeader(QByteArrayView line);
    void takeSection(QByteArrayView key, QByteArrayView rest);
    void takeField(QByteArrayView key, QByteArrayView rest);
    void takeGroup(QByteArrayView number, QByteArrayView rest);
    void takePositionHeader(QByteArrayView key, QByteArrayView rest);
    void takeArgumentHeader(QByteArrayView key, QByteArrayView rest);
    LineKind takeEntry(QByteArrayView line, int index);
    LineKind takeAlias(QByteArrayView line);
    LineKind takeArgument(QByteArrayView line);
    LineKind takeInstruction(int index);

    Job m_job;
    Section m_section = Section::None;
    Point m_point; ///< What holds for the entries that follow.
    QByteArrayView m_user;
    QByteArrayView m_form;
    int m_argument = -1; ///< The next line of ///COMMENT in //ARGINFO.
};

Job Reader::read(const QByteArray &text)
{
    m_job.text = text;
    for (const TextLine &line : splitLines(m_job.text))
        m_job.lines.push_back({LineKind::Foreign, Section::None, line.text, line.ending});
    for (int index = 0; index < int(m_job.lines.size()); ++index) {
        const LineKind kind = take(withoutBlanks(m_job.lines[std::size_t(index)].text), index);
        m_job.lines[std::size_t(index)].kind = kind;
        m_job.lines[std::size_t(index)].section = m_section;
    }
    return std::move(m_job);
}

LineKind Reader::take(QByteArrayView line, int index)
{
    if (m_argument >= 0 && m_argument < 8 && !line.startsWith('/'))
        return takeArgument(line);
    if (line.isEmpty())
        return LineKind::Blank;
    if (m_job.jobs > 1)
        return LineKind::Foreign;
    if (line.startsWith('/')) {
        takeHeader(line);
        return LineKind::Header;
    }
    switch (m_section) {
    case Section::Positions: return takeEntry(line, index);
    case Section::Names: return takeAlias(line);
    case Section::Instructions: return takeInstruction(index);
    case Section::None:
    case Section::Job:
    case Section::Arguments: break;
    }
    return line == "NOP" ? takeInstruction(index) : LineKind::Foreign;
}

void Reader::takeHeader(QByteArrayView line)
{
    const qsizetype space = line.indexOf(' ');
    const QByteArrayView key = space < 0 ? line : line.first(space);
    const QByteArrayView rest = space < 0 ? QByteArrayView {} : withoutBlanks(line.sliced(space));
    m_argument = -1;
    takeSection(key, rest);
    switch (m_section) {
    case Section::Positions: return takePositionHeader(key, rest);
    case Section::Names: return;
    case Section::Arguments: return takeArgumentHeader(key, rest);
    case Section::None:
    case Section::Job:
    case Section::Instructions: return takeField(key, rest);
    }
}

void Reader::takeSection(QByteArrayView key, QByteArrayView rest)
{
    if (key == "/JOB") {
        m_job.isJob = true;
        ++m_job.jobs;
        m_section = m_job.jobs > 1 ? Section::None : Section::Job;
    } else if (key == "//NAME" && m_job.name.isEmpty()) {
        m_job.name = rest.toByteArray();
    } else if (key == "//POS") {
        m_section = Section::Positions;
    } else if (key == "//ALIAS") {
        m_section = Section::Names;
    } else if (key == "//ARGINFO") {
        m_section = Section::Arguments;
        m_job.arguments.resize(8);
    } else if (key == "//INST") {
        m_section = Section::Instructions;
    }
}

void Reader::takeField(QByteArrayView key, QByteArrayView rest)
{
    if (key == "///FOLDERNAME")
        m_job.folder = rest.toByteArray();
    else if (key == "///DATE")
        m_job.date = rest.toByteArray();
    else if (key == "///COMM")
        m_job.comment = rest.toByteArray();
    else if (key == "///ATTR")
        m_job.attributes = listOf(rest);
    else if (key == "////FRAME" || key == "///FRAME")
        m_job.frame = rest.toByteArray().simplified();
    else if (key == "///LVARS")
        m_job.locals = numbersOf<8>(rest).value_or(LocalCounts {});
    else if (key == "///NPOS")
        m_job.announced = numbersOf<6>(rest);
    else if (key.startsWith("///GROUP"))
        takeGroup(key.sliced(8), rest);
}

void Reader::takeGroup(QByteArrayView number, QByteArrayView rest)
{
    const int group = number.size() == 1 ? number[0] - '0' : 0;
    if (group < 1 || group > 9)
        return;
    m_job.groups.resize(std::max<qsizetype>(m_job.groups.size(), group));
    m_job.groups[group - 1] = listOf(rest);
}

void Reader::takePositionHeader(QByteArrayView key, QByteArrayView rest)
{
    if (key == "///NPOS")
        m_job.announced = numbersOf<6>(rest);
    else if (key == "///TOOL")
        m_point.tool = rest;
    else if (key == "///USER")
        m_user = rest;
    else if (key == "///POSTYPE")
        m_point.type = rest;
    else if (key == "///RCONF")
        m_form = rest;
    else if (key == "///PULSE" || key == "///RECTAN" || key == "///ANGLE")
        m_point.layout = key.sliced(3);
    else if (key == "///LIMIT")
        m_point.isBeyondLimit = rest == "ON";
}

void Reader::takeArgumentHeader(QByteArrayView key, QByteArrayView rest)
{
    if (key == "///COMMENT")
        m_argument = 0;
    if (key != "///ARGTYPE")
        return;
    const QByteArrayList types = listOf(rest);
    for (int index = 0; index < types.size() && index < 8; ++index)
        m_job.arguments[index].type = types[index];
}

LineKind Reader::takeEntry(QByteArrayView line, int index)
{
    const qsizetype equals = line.indexOf('=');
    const auto name = equals < 1 ? std::nullopt : entryName(withoutBlanks(line.first(equals)));
    if (!name)
        return LineKind::Foreign;
    m_point.name = withoutBlanks(line.first(equals));
    m_point.kind = name->kind;
    m_point.number = name->number;
    m_point.values = withoutBlanks(line.sliced(equals + 1));
    m_point.user = m_point.type == "USER" ? m_user : QByteArrayView {};
    m_point.form = m_point.isCartesian() && m_point.isOfRobot() ? m_form : QByteArrayView {};
    m_point.line = index;
    m_job.pointIndexes.emplace(pointId(*name), m_job.pointIndexes.value(pointId(*name), int(m_job.points.size())));
    m_job.points.push_back(m_point);
    return LineKind::Entry;
}

LineKind Reader::takeAlias(QByteArrayView line)
{
    const qsizetype space = line.indexOf(' ');
    if (space < 1)
        return LineKind::Foreign;
    const Alias alias {line.first(space).toByteArray(), withoutBlanks(line.sliced(space)).toByteArray()};
    m_job.aliasList << alias;
    m_job.aliases.insert(alias.name, alias.variable);
    return LineKind::Declaration;
}

LineKind Reader::takeArgument(QByteArrayView line)
{
    m_job.arguments[m_argument++].comment = line.toByteArray();
    return LineKind::Declaration;
}

LineKind Reader::takeInstruction(int index)
{
    m_section = Section::Instructions;
    Line &line = m_job.lines[std::size_t(index)];
    if (line.text == "\x1a") // the end of a text file, of old
        return LineKind::Foreign;
    m_job.instructions.push_back(index);
    line.firstToken = int(m_job.tokens.size());
    tokenize(line.text, m_job.aliases, m_job.tokens);
    line.tokenCount = int(m_job.tokens.size()) - line.firstToken;
    const TokenKind kind = line.tokenCount > 0 ? m_job.tokens.back().kind : TokenKind::Unknown;
    return kind == TokenKind::Comment                                                          ? LineKind::Comment
        : kind == TokenKind::Label && m_job.word(int(m_job.instructions.size()) - 1).isEmpty() ? LineKind::Label
                                                                                               : LineKind::Instruction;
}

} // namespace

Job parse(const QByteArray &text) { return Reader {}.read(text); }

} // namespace inform
