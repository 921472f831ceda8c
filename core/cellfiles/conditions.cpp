// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "cellfiles/conditions.h"

#include "cellfiles/sentences.h"

namespace cellfiles {

namespace {

void notAsExpected(int line, Warnings &warnings)
{
    warnings.add(line, Sentences::tr("The line does not have the numbers that belong there."));
}

/// Reads `Count` numbers; `decimals` of the first three, and of the rest.
template <std::size_t Count>
bool readFixed(const Line &row, std::array<qint64, Count> &target, int decimals, int laterDecimals, Warnings &warnings)
{
    const auto fields = fieldsOf(row.text);
    bool isGood = fields.size() >= qsizetype(Count) && row.isWhole;
    for (std::size_t index = 0; index < Count && qsizetype(index) < fields.size(); ++index) {
        const auto value = fixedFrom(fields[qsizetype(index)], index < 3 ? decimals : laterDecimals);
        target[index] = value.value_or(0);
        isGood = isGood && value;
    }
    if (!isGood)
        notAsExpected(row.number, warnings);
    return isGood;
}

int numberOf(const Block &block, Warnings &warnings)
{
    const auto number = wordFrom(block.text);
    if (!number)
        warnings.add(block.line, Sentences::tr("The block has no number."));
    return number.value_or(-1);
}

/// The blocks below a header, up to the next of that word.
class Parts
{
public:
    Parts(const Outline &outline, QByteArrayView word) : m_blocks {outline.blocks}, m_word {word} { skip(); }

    [[nodiscard]] bool isAtEnd() const { return m_at == m_blocks.size(); }
    [[nodiscard]] std::span<const Block> next()
    {
        const std::size_t start = m_at++;
        skip();
        return std::span {m_blocks}.subspan(start, m_at - start);
    }

private:
    void skip()
    {
        while (m_at < m_blocks.size() && !(m_blocks[m_at].level == 2 && m_blocks[m_at].word == m_word))
            ++m_at;
    }

    const std::vector<Block> &m_blocks;
    QByteArrayView m_word;
    std::size_t m_at = 0;
};

const Block *find(std::span<const Block> blocks, QByteArrayView word)
{
    const auto found = std::ranges::find(blocks, word, &Block::word);
    return found == blocks.end() ? nullptr : &*found;
}

QString nameIn(std::span<const Block> blocks, const protocol::TextCodec &codec)
{
    const Block *name = find(blocks, "NAME");
    return name ? codec.decode(name->text) : QString {};
}

/// All rows of a block and of what is below it.
std::vector<Line> rowsOf(std::span<const Block> blocks)
{
    std::vector<Line> rows;
    for (const Block &block : blocks)
        rows.insert(rows.end(), block.rows.begin(), block.rows.end());
    return rows;
}

bool readEntryKind(const Line &row, Tool &tool, Warnings &warnings)
{
    const auto fields = fieldsOf(row.text);
    const auto kind = fields.size() >= 3 ? wordFrom(fields[2]) : std::nullopt;
    tool.entryKind = kind.value_or(0);
    if (!kind)
        notAsExpected(row.number, warnings);
    return kind.has_value();
}

Tool toolFrom(std::span<const Block> blocks, const protocol::TextCodec &codec, Warnings &warnings)
{
    Tool tool;
    tool.number = numberOf(blocks.front(), warnings);
    tool.line = blocks.front().line;
    tool.name = nameIn(blocks, codec);
    tool.crc = blocks.front().crc.toByteArray();
    const auto rows = rowsOf(blocks);
    tool.isWhole = rows.size() >= 5;
    if (!tool.isWhole) {
        warnings.add(tool.line, Sentences::tr("Tool %1 is not complete.").arg(tool.number));
        return tool;
    }
    std::array<qint64, 1> weight {};
    tool.isWhole = readFixed(rows[0], tool.point, 3, 4, warnings);
    tool.isWhole &= readFixed(rows[1], tool.centreOfGravity, 3, 3, warnings);
    tool.isWhole &= readFixed(rows[2], weight, 3, 3, warnings);
    tool.isWhole &= readFixed(rows[3], tool.inertia, 3, 3, warnings);
    tool.isWhole &= readEntryKind(rows[4], tool, warnings);
    tool.weight = weight[0];
    return tool;
}

/// "C000=1,2,3": the pulses behind the equals sign.
QList<qint64> taughtPulses(std::span<const Block> blocks, QByteArrayView word, Warnings &warnings)
{
    const Block *block = find(blocks, word);
    if (!block)
        return {};
    const auto equals = block->text.indexOf('=');
    const auto pulses = integersFrom(block->text.sliced(equals + 1));
    if (!pulses)
        notAsExpected(block->line, warnings);
    return pulses.value_or(QList<qint64> {});
}

UserFrame userFrameFrom(std::span<const Block> blocks, const protocol::TextCodec &codec, Warnings &warnings)
{
    UserFrame frame;
    frame.number = numberOf(blocks.front(), warnings);
    frame.line = blocks.front().line;
    frame.name = nameIn(blocks, codec);
    if (const Block *tool = find(blocks, "TOOL"))
        frame.tool = wordFrom(tool->text).value_or(-1);
    frame.taught = {taughtPulses(blocks, "RORG", warnings), taughtPulses(blocks, "RXX", warnings),
        taughtPulses(blocks, "RXY", warnings)};
    const Block *user = find(blocks, "BUSER");
    Frame values {};
    if (user && readFixed({user->text, user->line}, values, 3, 4, warnings))
        frame.frame = values;
    else
        warnings.add(
            frame.line, Sentences::tr("User frame %1 is not complete: where it lies is unknown.").arg(frame.number));
    return frame;
}

template <std::size_t Count> void readIntegers(const Line &row, std::array<qint64, Count> &target, Warnings &warnings)
{
    readFixed(row, target, 0, 0, warnings);
}

} // namespace

Parsed<QList<Tool>> toolsFrom(QByteArrayView file, const protocol::TextCodec &codec)
{
    Parsed<QList<Tool>> result;
    const Outline outline = outlineOf(file, result.warnings, {"TOOL", "NAME"});
    for (Parts parts {outline, "TOOL"}; !parts.isAtEnd();)
        result.value << toolFrom(parts.next(), codec, result.warnings);
    return result;
}

Parsed<QList<UserFrame>> userFramesFrom(QByteArrayView file, const protocol::TextCodec &codec)
{
    Parsed<QList<UserFrame>> result;
    const Outline outline = outlineOf(file, result.warnings);
    for (Parts parts {outline, "UFRAME"}; !parts.isAtEnd();)
        result.value << userFrameFrom(parts.next(), codec, result.warnings);
    return result;
}

CubeCoordinates Cube::coordinates() const
{
    return coordinatesField >= 0 && coordinatesField <= 2 ? CubeCoordinates(coordinatesField) : CubeCoordinates::Other;
}

Cube cubeFrom(std::span<const Line> rows, Warnings &warnings)
{
    Cube cube;
    if (rows.size() < 3) {
        if (!rows.empty())
            notAsExpected(rows.front().number, warnings);
        return cube;
    }
    std::array<qint64, 3> head {};
    readIntegers(rows[0], head, warnings);
    cube.method = int(head[0]);
    cube.group = int(head[1]);
    cube.coordinatesField = int(head[2]);
    readIntegers(rows[1], cube.upper, warnings);
    readIntegers(rows[2], cube.lower, warnings);
    if (rows.size() > 3)
        cube.userFrame = wordFrom(rows[3].text).value_or(0);
    return cube;
}

Parsed<QList<Cube>> cubesFrom(QByteArrayView file, const protocol::TextCodec &codec)
{
    Parsed<QList<Cube>> result;
    const Outline outline = outlineOf(file, result.warnings, {"CUBEINTF", "NAME"});
    for (Parts parts {outline, "CUBEINTF"}; !parts.isAtEnd();) {
        const auto blocks = parts.next();
        Cube cube = cubeFrom(rowsOf(blocks), result.warnings);
        cube.number = numberOf(blocks.front(), result.warnings);
        cube.line = blocks.front().line;
        cube.name = nameIn(blocks, codec);
        result.value << cube;
    }
    return result;
}

} // namespace cellfiles
