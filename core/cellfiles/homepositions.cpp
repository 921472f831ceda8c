// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "cellfiles/homepositions.h"

#include "cellfiles/sentences.h"
#include <bit>

namespace cellfiles {

namespace {

constexpr qsizetype groupFields = 36;
constexpr qsizetype axesPerGroup = 8;
constexpr std::size_t dxRows = 64; ///< DX100 and DX200: two rows a group; the YRC1000 packs all axes together.

void notAsExpected(int line, Warnings &warnings)
{
    warnings.add(line, Sentences::tr("The line does not have the numbers that belong there."));
}

QList<qint64> numbersOf(std::span<const Line> rows, Warnings &warnings)
{
    QList<qint64> all;
    for (const Line &row : rows) {
        const auto values = row.isWhole ? integersFrom(row.text) : std::nullopt;
        if (!values)
            notAsExpected(row.number, warnings);
        all += values.value_or(QList<qint64> {});
    }
    return all;
}

/// The axes of one group among pairs of "valid, value" from `first` on.
QList<HomeAxis> axesFrom(const QList<qint64> &pairs, qsizetype first, int count)
{
    QList<HomeAxis> axes;
    for (qsizetype axis = first; axis < first + count && 2 * axis + 1 < pairs.size(); ++axis)
        axes << HomeAxis {pairs[2 * axis] != 0, pairs[2 * axis + 1]};
    return axes;
}

void takeOffsets(const Block &block, Parsed<HomePositions> &result)
{
    const auto pairs = numbersOf(block.rows, result.warnings);
    const bool isPacked = block.rows.size() < dxRows;
    qsizetype next = 0;
    for (const Group &group : groupsFrom(block.text, block.line, result.warnings)) {
        const HomeGroup home {group, axesFrom(pairs, next, group.axisCount())};
        if (home.axes.size() != group.axisCount())
            result.warnings.add(block.line, Sentences::tr("The file ends before the values of %1.").arg(group.name));
        result.value.groups << home;
        next += isPacked ? group.axisCount() : axesPerGroup;
    }
}

/// Three rows a group: two numbers, then twice four pulses.
void takePositions(const Block &block, const QList<Group> &groups, Parsed<HomePositions> &result)
{
    constexpr std::size_t rowsPerGroup = 3;
    for (std::size_t index = 0; index < std::size_t(groups.size()); ++index) {
        const Group &group = groups[qsizetype(index)];
        const std::size_t first = index * rowsPerGroup + 1;
        if (first + 2 > block.rows.size()) {
            result.warnings.add(block.line, Sentences::tr("The file ends before the values of %1.").arg(group.name));
            return;
        }
        HomeGroup home {group, {}};
        const auto pulses = numbersOf(std::span {block.rows}.subspan(first, 2), result.warnings);
        for (int axis = 0; axis < group.axisCount() && axis < pulses.size(); ++axis)
            home.axes << HomeAxis {true, pulses[axis]};
        result.value.groups << home;
    }
}

void takeSpeeds(const Block &block, Parsed<HomePositions> &result)
{
    for (const Line &row : block.rows) {
        for (const QByteArrayView field : fieldsOf(row.text))
            result.value.speeds << fixedFrom(field, 2).value_or(0);
    }
}

void takeCube(const Block &block, Parsed<HomePositions> &result)
{
    Cube cube = cubeFrom(block.rows, result.warnings);
    cube.number = wordFrom(block.word.sliced(4)).value_or(0);
    cube.line = block.line;
    result.value.cubes << cube;
}

} // namespace

QList<Group> groupsFrom(QByteArrayView text, int line, Warnings &warnings)
{
    const auto fields = integersFrom(text);
    if (!fields || fields->size() != groupFields) {
        warnings.add(line, Sentences::tr("The control groups of this line could not be read."));
        return {};
    }
    const std::array<std::pair<QChar, qint64>, 3> kinds {
        std::pair {QChar {u'R'}, fields->at(33)}, {QChar {u'B'}, fields->at(35)}, {QChar {u'S'}, fields->at(34)}};
    QList<Group> groups;
    for (const auto &[letter, count] : kinds) {
        for (int number = 1; number <= count && groups.size() < 32; ++number)
            groups << Group {letter + QString::number(number), int(fields->at(1 + groups.size()) & 0xFF)};
    }
    return groups;
}

Parsed<HomePositions> encoderOffsetsFrom(QByteArrayView file)
{
    Parsed<HomePositions> result;
    const Outline outline = outlineOf(file, result.warnings);
    for (const Block &block : outline.blocks) {
        if (block.word == "ABSO")
            result.value.crc = block.crc.toByteArray();
        else if (block.word == "RBPRM")
            takeOffsets(block, result);
        else
            result.warnings.add(block.line, Sentences::tr("This section is not understood."));
    }
    return result;
}

Parsed<HomePositions> homePositionsFrom(QByteArrayView file)
{
    Parsed<HomePositions> result;
    QList<Group> groups;
    const Outline outline = outlineOf(file, result.warnings);
    for (const Block &block : outline.blocks) {
        if (block.word == "GROUP")
            groups = groupsFrom(block.text, block.line, result.warnings);
        if ((block.word == "GROUP" && !block.rows.empty()) || block.word == "ORGPOS")
            takePositions(block, groups, result);
        else if (block.word == "ORGSPD")
            takeSpeeds(block, result);
        else if (block.word.startsWith("CUBE"))
            takeCube(block, result);
    }
    return result;
}

QList<int> PseudoInputs::on(int base) const
{
    QList<int> found;
    for (int byte = 0; byte < bytes.size(); ++byte) {
        for (int bit = 0; bit < 8; ++bit) {
            if (bytes[byte] >> bit & 1)
                found << base + (byte + 1) * 10 + bit;
        }
    }
    return found;
}

Parsed<PseudoInputs> pseudoInputsFrom(QByteArrayView file, const protocol::TextCodec &codec)
{
    Parsed<PseudoInputs> result;
    const Outline outline = outlineOf(file, result.warnings, {"PSEUDOIN", "DATA", "NAME"});
    int index = 0;
    for (const Block &block : outline.blocks) {
        if (block.word == "DATA")
            result.value.bytes = numbersOf(block.rows, result.warnings);
        for (const Line &row : block.word == "NAME" ? block.rows : std::vector<Line> {}) {
            for (const QByteArrayView name : fieldsOf(row.text)) {
                if (!name.isEmpty())
                    result.value.names[index] = codec.decode(name);
                ++index;
            }
        }
    }
    return result;
}

} // namespace cellfiles
