// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "files/inform.h"

#include <algorithm>

namespace files {

namespace {

QByteArrayList commaSeparated(const QByteArray &text)
{
    QByteArrayList parts = text.split(',');
    for (QByteArray &part : parts)
        part = part.trimmed();
    return parts;
}

std::optional<int> sum(const QByteArray &numbers)
{
    int result = 0;
    for (const QByteArray &part : commaSeparated(numbers)) {
        bool isNumber = false;
        result += part.toUShort(&isNumber);
        if (!isNumber)
            return std::nullopt;
    }
    return result;
}

/// Goes through the lines of a job once and fills in what they say.
class Reader
{
public:
    Job read(QByteArrayView content);

private:
    enum class Section { None, Positions, Instructions };

    LineKind take(const QByteArray &line, int index);
    void takeHeader(const QByteArray &key, const QByteArray &rest);
    LineKind takePosition(const QByteArray &line, int index);
    LineKind takeInstruction(const QByteArray &line, int index);

    Job m_job;
    Section m_section = Section::None;
    TaughtPosition m_position; ///< What holds for the entries that follow.
};

Job Reader::read(QByteArrayView content)
{
    m_job.lines = splitLines(content);
    for (int index = 0; index < m_job.lines.size(); ++index)
        m_job.lines[index].kind = take(m_job.lines.at(index).text.trimmed(), index);
    return std::move(m_job);
}

LineKind Reader::take(const QByteArray &line, int index)
{
    if (line.isEmpty())
        return LineKind::Blank;
    if (line.startsWith('/')) {
        const qsizetype space = line.indexOf(' ');
        takeHeader(space < 0 ? line : line.first(space), space < 0 ? QByteArray {} : line.sliced(space).trimmed());
        return LineKind::Header;
    }
    switch (m_section) {
    case Section::None: break;
    case Section::Positions: return takePosition(line, index);
    case Section::Instructions: return takeInstruction(line, index);
    }
    return LineKind::Foreign;
}

void Reader::takeHeader(const QByteArray &key, const QByteArray &rest)
{
    if (key == "/JOB")
        m_job.isJob = true;
    else if (key == "//NAME")
        m_job.name = rest;
    else if (key == "//POS")
        m_section = Section::Positions;
    else if (key == "//INST")
        m_section = Section::Instructions;
    else if (key == "///NPOS")
        m_job.announcedPositions = sum(rest);
    else if (key == "///TOOL")
        m_position.tool = rest;
    else if (key == "///USER")
        m_position.userFrame = rest;
    else if (key == "///POSTYPE")
        m_position.type = rest;
    else if (key == "///COMM")
        m_job.comment = rest;
    else if (key == "///DATE")
        m_job.date = rest;
    else if (key == "///ATTR")
        m_job.attributes = commaSeparated(rest);
    else if (key == "///GROUP1")
        m_job.groups = commaSeparated(rest);
}

LineKind Reader::takePosition(const QByteArray &line, int index)
{
    const qsizetype equals = line.indexOf('=');
    if (equals < 1)
        return LineKind::Foreign;
    m_position.name = line.first(equals).trimmed();
    m_position.values = commaSeparated(line.sliced(equals + 1));
    m_position.line = index;
    m_job.positions << m_position;
    return LineKind::Position;
}

LineKind Reader::takeInstruction(const QByteArray &line, int index)
{
    m_job.instructions << index;
    return line.startsWith('*') ? LineKind::Label : line.startsWith('\'') ? LineKind::Comment : LineKind::Instruction;
}

} // namespace

QList<Line> splitLines(QByteArrayView content)
{
    QList<Line> lines;
    while (!content.isEmpty()) {
        const qsizetype found = content.indexOf('\n');
        const qsizetype end = found < 0 ? content.size() : found + 1;
        const bool hasReturn = found > 0 && content[found - 1] == '\r';
        const qsizetype size = found < 0 ? end : found - (hasReturn ? 1 : 0);
        lines << Line {
            LineKind::Foreign, content.first(size).toByteArray(), content.sliced(size, end - size).toByteArray()};
        content = content.sliced(end);
    }
    return lines;
}

QByteArray joinLines(const QList<Line> &lines)
{
    QByteArray content;
    for (const Line &line : lines)
        content += line.text + line.ending;
    return content;
}

QByteArray Job::instruction(int number) const { return lines.at(instructions.at(number)).text.trimmed(); }

QList<Mark> Job::labels() const
{
    QList<Mark> result;
    for (int number = 0; number < instructions.size(); ++number) {
        if (lines.at(instructions.at(number)).kind == LineKind::Label)
            result << Mark {instruction(number).sliced(1), number};
    }
    return result;
}

QList<Mark> Job::calls() const
{
    static const QByteArrayList callers {"CALL", "JUMP", "PSTART"};
    QList<Mark> result;
    for (int number = 0; number < instructions.size(); ++number) {
        const QByteArrayList words = instruction(number).simplified().split(' ');
        if (words.size() < 2 || !callers.contains(words[0]))
            continue;
        for (const QByteArray &word : words) {
            if (word.startsWith("JOB:"))
                result << Mark {word.sliced(4), number};
        }
    }
    return result;
}

Job parseJob(QByteArrayView content) { return Reader {}.read(content); }

QByteArray print(const Job &job) { return joinLines(job.lines); }

bool isJobName(QByteArrayView name)
{
    constexpr QByteArrayView forbidden = "\"'*,./:;<>?[\\]|=";
    return !name.isEmpty() && name.size() <= 32
        && std::ranges::none_of(name, [&](char c) { return quint8(c) <= ' ' || forbidden.contains(c); });
}

} // namespace files
