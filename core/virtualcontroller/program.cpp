// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "virtualcontroller/program.h"

#include "inform/job.h"
#include "protocol/codes.h"
#include <algorithm>
#include <cmath>

using values::PositionType;

namespace virtualcontroller {

namespace {

// Reference §9.
constexpr quint16 illegalName = 0x4190;
constexpr quint16 instructionSyntax = 0x5110;
constexpr quint16 noNopOrEnd = 0x5130;
constexpr quint16 wrongCount = 0x5180;
constexpr quint16 otherSyntax = 0x5310;
constexpr quint16 pseudoInstruction = 0x5340;

enum class Section { None, Positions, Instructions };

/// Reads a job line by line. Stops at the first fault.
class ProgramReader
{
public:
    tl::expected<Program, quint16> read(const QByteArray &text);

private:
    quint16 takeLine(const QByteArray &line);
    quint16 takePseudo(const QByteArray &line);
    quint16 takeHeader(const QByteArray &key, const QByteArray &rest);
    quint16 takeCounts(const QByteArray &rest);
    quint16 takePosition(const QByteArray &line);
    quint16 takeInstruction(const QByteArray &line);
    [[nodiscard]] quint16 finalFault() const;

    Program m_program;
    Section m_section = Section::None;
    values::Position m_kind; ///< Type, tool and user frame of the entries that follow.
    qsizetype m_announced = 0;
    bool m_isJob = false;
};

/// A number with decimals as the wire has it: whole pulses, micrometre, 0.0001 degree.
std::optional<qint32> wireWord(const QByteArray &text, values::AxisUnit unit)
{
    bool ok = false;
    const double number = text.toDouble(&ok);
    const double factor = unit == values::AxisUnit::Pulse ? 1 : unit == values::AxisUnit::Micrometre ? 1e3 : 1e4;
    const double scaled = number * factor;
    if (!ok || !(std::abs(scaled) <= INT32_MAX)) // not a number is not within either
        return std::nullopt;
    return qint32(std::lround(scaled));
}

std::optional<PositionType> positionType(const QByteArray &name)
{
    static const std::map<QByteArray, PositionType> types {{"PULSE", PositionType::Pulse}, {"BASE", PositionType::Base},
        {"ROBOT", PositionType::Robot}, {"USER", PositionType::User}, {"TOOL", PositionType::Tool},
        {"MTOOL", PositionType::Tool}};
    const auto found = types.find(name);
    return found == types.end() ? std::nullopt : std::optional {found->second};
}

bool isWord(const QByteArray &text)
{
    return !text.isEmpty() && text[0] >= 'A' && text[0] <= 'Z'
        && std::ranges::all_of(text, [](char c) { return (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9'); });
}

quint16 ProgramReader::takeCounts(const QByteArray &rest)
{
    for (const QByteArray &count : rest.split(',')) {
        bool ok = false;
        m_announced += count.trimmed().toUInt(&ok);
        if (!ok)
            return pseudoInstruction;
    }
    return 0;
}

quint16 ProgramReader::takeHeader(const QByteArray &key, const QByteArray &rest)
{
    static const QByteArrayList ignored {"///DATE", "///COMM", "///FRAME", "///GROUP1", "///GROUP2", "///LVARS",
        "///LVARNAME", "///PULSE", "///RECTAN", "///RCONF", "///ANGLE", "///TCOMP", "///USERFRAME", "///BCONF",
        "///SHIFTON", "///SGROUP1", "///FOLDERNAME"};
    if (key == "///NPOS")
        return takeCounts(rest);
    if (key == "///TOOL")
        m_kind.tool = rest.toUInt();
    else if (key == "///USER")
        m_kind.userFrame = rest.toUInt();
    else if (key == "///ATTR")
        m_program.isReadOnly = rest.split(',').contains("RO");
    else if (key == "///POSTYPE") {
        const auto type = positionType(rest);
        if (!type)
            return pseudoInstruction;
        m_kind.type = *type;
    } else if (!ignored.contains(key))
        return pseudoInstruction;
    return 0;
}

quint16 ProgramReader::takePseudo(const QByteArray &line)
{
    const auto space = line.indexOf(' ');
    const QByteArray key = space < 0 ? line : line.first(space);
    const QByteArray rest = space < 0 ? QByteArray {} : line.sliced(space + 1).trimmed();
    if (key == "/JOB")
        m_isJob = true;
    else if (key == "//NAME")
        m_program.name = rest;
    else if (key == "//POS")
        m_section = Section::Positions;
    else if (key == "//INST")
        m_section = Section::Instructions;
    else
        return takeHeader(key, rest);
    return 0;
}

quint16 ProgramReader::takePosition(const QByteArray &line)
{
    const auto equals = line.indexOf('=');
    if (equals < 1)
        return otherSyntax;
    values::Position position = m_kind;
    const auto words = line.sliced(equals + 1).split(',');
    if (words.size() > values::maxAxes)
        return otherSyntax;
    position.axes.resize(int(words.size()));
    for (int axis = 0; axis < position.axes.count(); ++axis) {
        const auto word = wireWord(words[axis], values::axisUnit(position.type, axis));
        if (!word)
            return otherSyntax;
        position.axes[axis] = *word;
    }
    m_program.positions[line.first(equals)] = position;
    return 0;
}

quint16 ProgramReader::takeInstruction(const QByteArray &line)
{
    Instruction instruction;
    if (line.startsWith('\'') || line.startsWith('*'))
        instruction.words = {line};
    else
        instruction.words = line.simplified().split(' ');
    if (instruction.isLabel())
        m_program.labels[line.trimmed()] = int(m_program.lines.size());
    else if (!instruction.isComment() && !isWord(instruction.word()))
        return instructionSyntax;
    m_program.lines.push_back(std::move(instruction));
    return 0;
}

quint16 ProgramReader::takeLine(const QByteArray &line)
{
    if (line.startsWith('/'))
        return takePseudo(line);
    switch (m_section) {
    case Section::None: return otherSyntax;
    case Section::Positions: return takePosition(line);
    case Section::Instructions: return takeInstruction(line);
    }
    return 0;
}

quint16 ProgramReader::finalFault() const
{
    if (!m_isJob)
        return otherSyntax;
    if (!inform::isJobName(m_program.name))
        return illegalName;
    if (m_announced != qsizetype(m_program.positions.size()))
        return wrongCount;
    const auto &lines = m_program.lines;
    if (lines.size() < 2 || lines.front().word() != "NOP" || lines.back().word() != "END")
        return noNopOrEnd;
    return 0;
}

tl::expected<Program, quint16> ProgramReader::read(const QByteArray &text)
{
    for (QByteArray line : text.split('\n')) {
        if (line.endsWith('\r'))
            line.chop(1);
        if (line.trimmed().isEmpty())
            continue;
        if (const quint16 fault = takeLine(line.startsWith('\'') ? line : line.trimmed()))
            return tl::unexpected(fault);
    }
    if (const quint16 fault = finalFault())
        return tl::unexpected(fault);
    return std::move(m_program);
}

} // namespace

QByteArray Instruction::valueOf(QByteArrayView key) const
{
    const auto found = std::ranges::find_if(words, [key](const QByteArray &word) { return word.startsWith(key); });
    return found == words.end() ? QByteArray {} : found->sliced(key.size());
}

int Program::stepAt(int line) const
{
    const auto end = lines.begin() + std::clamp<qsizetype>(line + 1, 0, qsizetype(lines.size()));
    return int(std::count_if(lines.begin(), end, [](const Instruction &instruction) { return instruction.isMove(); }));
}

tl::expected<Program, quint16> parseProgram(const QByteArray &text) { return ProgramReader {}.read(text); }

} // namespace virtualcontroller
