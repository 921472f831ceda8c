// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "cellfiles/ladder.h"

#include "cellfiles/sentences.h"
#include "cellfiles/signalnames.h"

namespace cellfiles {

namespace {

enum class Use { None, Reads, Writes };

/// What an instruction does with its operands, in order. A size of 0 stands for the operand's own: a bit, or a word for
/// a register.
struct Mnemonic {
    QByteArrayView word;
    std::array<Use, 3> uses {Use::None, Use::None, Use::None};
    int bits = 1; ///< How many signals an operand stands for.
};
constexpr std::array mnemonics {
    Mnemonic {"STR", {Use::Reads}},
    Mnemonic {"STR-NOT", {Use::Reads}},
    Mnemonic {"AND", {Use::Reads}},
    Mnemonic {"AND-NOT", {Use::Reads}},
    Mnemonic {"OR", {Use::Reads}},
    Mnemonic {"OR-NOT", {Use::Reads}},
    Mnemonic {"OR-STR"},
    Mnemonic {"AND-STR"},
    Mnemonic {"OUT", {Use::Writes}},
    Mnemonic {"GSTR", {Use::Reads}, 8},
    Mnemonic {"GOUT", {Use::Writes}, 8},
    Mnemonic {"TMR", {Use::Writes}},
    Mnemonic {"CNT", {Use::Writes}},
    Mnemonic {"ADD", {Use::Reads, Use::Reads, Use::Writes}},
    Mnemonic {"MOV", {Use::Reads, Use::Writes}},
    Mnemonic {"BMOV", {Use::Reads, Use::None, Use::Writes}, 8},
    Mnemonic {"END"},
};

const Mnemonic *find(QByteArrayView word)
{
    const auto found = std::ranges::find(mnemonics, word, &Mnemonic::word);
    return found == mnemonics.end() ? nullptr : &*found;
}

/// `bits` signals from a logical number on, eight of a group.
void addSignals(int first, int bits, QList<LadderOperand> &list)
{
    for (int index = 0; index < bits; ++index)
        list << LadderOperand {LadderOperand::Kind::Signal, first + index / 8 * 10 + index % 8};
}

/// "#20010", "W#79780", "M150", or a constant, which is no operand. False for anything else.
bool addOperand(QByteArrayView text, int bits, QList<LadderOperand> &list)
{
    constexpr int wordBits = 16;
    constexpr qsizetype digits = 5;
    const bool isWord = text.startsWith("W#");
    if (isWord || text.startsWith('#')) {
        const QByteArrayView number = text.sliced(isWord ? 2 : 1);
        const auto first = number.size() == digits ? integerFrom(number) : std::nullopt;
        if (!first || *first % 10 > 7)
            return false;
        addSignals(int(*first), isWord ? wordBits : bits, list);
        return true;
    }
    const auto value = wordFrom(text.startsWith('M') ? text.sliced(1) : text);
    if (value && text.startsWith('M'))
        list << LadderOperand {LadderOperand::Kind::Register, *value};
    return value.has_value();
}

/// How many signals an operand stands for: BMOV says it in groups.
int bitsOf(const Mnemonic &mnemonic, const QList<QByteArrayView> &operands)
{
    constexpr int mostGroups = 1000;
    const auto groups = mnemonic.word == "BMOV" && operands.size() > 1 ? integerFrom(operands[1]) : 1;
    return mnemonic.bits * int(std::clamp<qint64>(groups.value_or(0), 0, mostGroups));
}

bool readOperands(const Mnemonic &mnemonic, LadderInstruction &instruction)
{
    const auto fields = instruction.operands.isEmpty() ? QList<QByteArrayView> {} : fieldsOf(instruction.operands);
    const int bits = bitsOf(mnemonic, fields);
    bool isGood = true;
    for (std::size_t index = 0; index < mnemonic.uses.size(); ++index) {
        if (mnemonic.uses[index] == Use::None)
            continue;
        auto &list = mnemonic.uses[index] == Use::Reads ? instruction.reads : instruction.writes;
        isGood = qsizetype(index) < fields.size() && addOperand(fields[qsizetype(index)], bits, list) && isGood;
    }
    return isGood;
}

LadderInstruction instructionFrom(const Line &row, int part)
{
    const auto blank = row.text.indexOf(' ');
    const QByteArrayView word = blank < 0 ? row.text : row.text.first(blank);
    LadderInstruction instruction {word.toByteArray(),
        blank < 0 ? QByteArray {} : row.text.sliced(blank + 1).trimmed().toByteArray(), part, row.number};
    const Mnemonic *mnemonic = find(word);
    instruction.isUnderstood = mnemonic && row.isWhole && readOperands(*mnemonic, instruction);
    return instruction;
}

class LadderReader
{
public:
    LadderReader(const protocol::TextCodec &codec, Parsed<Ladder> &result) : m_codec {codec}, m_result {result} { }

    void take(const Block &block)
    {
        Ladder &ladder = m_result.value;
        if (block.word == "CIOPRG")
            ladder.tag = block.text.toByteArray();
        else if (block.word == "NAME")
            ladder.name = m_codec.decode(block.text);
        else if (block.word == "CIOAP")
            ladder.application = block.text.toByteArray();
        else if (block.word == "$M")
            readPresets(block);
        else if (block.word == "KEY")
            readCode(block);
        else if (block.word.startsWith("ALARM") || block.word.startsWith("MESSAGE"))
            readTexts(block);
    }

private:
    void readPresets(const Block &block)
    {
        for (const Line &row : block.rows) {
            const auto values = integersFrom(row.text);
            if (!values)
                m_result.warnings.add(
                    row.number, Sentences::tr("The line does not have the numbers that belong there."));
            m_result.value.presets << values.value_or(QList<qint64> {});
        }
    }

    void readCode(const Block &block)
    {
        int part = 0;
        for (const Line &row : block.rows) {
            if (row.text.startsWith("PART "))
                part = wordFrom(row.text.sliced(5)).value_or(0);
            else if (row.text != "END" && !row.text.trimmed().isEmpty())
                add(instructionFrom(row, part));
        }
    }

    void add(const LadderInstruction &instruction)
    {
        if (!instruction.isUnderstood)
            m_result.warnings.add(
                instruction.line, Sentences::tr("“%1” is not understood.").arg(m_codec.decode(instruction.text())));
        m_result.value.instructions << instruction;
    }

    void readTexts(const Block &block)
    {
        const QByteArray table = block.word.toByteArray();
        int row = 0;
        for (const Line &line : block.rows) {
            if (!line.text.trimmed().isEmpty())
                m_result.value.texts[table][row] = m_codec.decode(line.text);
            ++row;
        }
        m_result.value.textRows[table] = row;
    }

    const protocol::TextCodec &m_codec;
    Parsed<Ladder> &m_result;
};

} // namespace

QString toString(const LadderOperand &operand)
{
    const QChar digit = QLatin1Char {'0'};
    return operand.kind == LadderOperand::Kind::Signal ? QStringLiteral("#%1").arg(operand.number, 5, 10, digit)
                                                       : QStringLiteral("M%1").arg(operand.number, 3, 10, digit);
}

Parsed<Ladder> ladderFrom(QByteArrayView file, const protocol::TextCodec &codec)
{
    Parsed<Ladder> result;
    const Outline outline = outlineOf(file, result.warnings,
        {"CIOPRG", "NAME", "ATTR", "CIOAP", "$M", "KEY", "ALARM1", "ALARM2", "MESSAGE1", "MESSAGE2"});
    LadderReader reader {codec, result};
    for (const Block &block : outline.blocks)
        reader.take(block);
    return result;
}

} // namespace cellfiles
