// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "inform/instructions.h"

#include <QHash>
#include <algorithm>
#include <array>

namespace inform {

namespace {

using enum Wait;
constexpr auto InOut = Group::InputOutput;

constexpr Instruction move(const char *word) { return {word, Group::Move, "r*", Motion, {}, {}, true, true}; }
constexpr Instruction reference(const char *word, const char *writes)
{
    return {word, Group::Move, "-r*", No, {}, {}, false, true, "", writes};
}
constexpr Instruction mode(const char *word) { return {word, Group::Move, "r*"}; }
constexpr Instruction control(const char *word, const char *operands = "r*", Wait wait = No)
{
    return {word, Group::Control, operands, wait};
}
constexpr Instruction structure(const char *word, Structure structure, Block block, const char *operands = "r*")
{
    return {word, Group::Control, operands, No, block, structure, false, false, "", "", Generation::Dx100};
}
constexpr Instruction operating(const char *word, const char *operands) { return {word, Group::Operating, operands}; }
constexpr Instruction shift(const char *word) { return {word, Group::Shift, "r*"}; }
constexpr Instruction process(const char *word, Wait wait = No) { return {word, Group::Process, "r*", wait}; }

constexpr std::array rows {
    // reference §6.1
    move("MOVJ"),
    move("MOVL"),
    move("MOVC"),
    move("MOVS"),
    move("IMOV"),
    move("SMOVL"),
    move("SMOVC"),
    move("SMOVS"),
    move("SIMOV"),
    move("SYMOVJ"),
    move("SYMOVL"),
    move("SYMOVC"),
    mode("SPEED"),
    reference("REFP", "$PX01#"),
    reference("SREFP", "$PX02#"),
    Instruction {"TSYNC", Group::Move, "-", Tasks},
    mode("HTRAJON"),
    mode("HTRAJOF"),
    mode("HPVELON"),
    mode("HPVELOF"),
    mode("HPMMVON"),
    mode("HPMMVOF"),
    mode("SMOOTH"),
    mode("AOVRON"),
    mode("AOVROF"),
    mode("ACORON"),
    mode("ACOROF"),
    mode("SACORON"),
    mode("SACOROF"),
    Instruction {"FORMCUT", Group::Move, "r*", Motion},
    Instruction {"FORMAPR", Group::Move, "r*", Motion},
    // reference §6.2
    Instruction {"DOUT", InOut, "wr"},
    Instruction {"DIN", InOut, "wr"},
    Instruction {"WAIT", InOut, "r*", Condition},
    Instruction {"PULSE", InOut, "wr"},
    Instruction {"AOUT", InOut, "wr"},
    Instruction {"ARATION", InOut, "w"},
    Instruction {"ARATIOF", InOut, "w"},
    Instruction {"ANTOUT", InOut, "w"},
    Instruction {"SETREG", InOut, "wr"},
    Instruction {"GETREG", InOut, "wr"},
    Instruction {"SKILLSND", InOut, "r*"},
    // reference §6.3
    control("NOP"),
    control("END"),
    control("JUMP"),
    control("CALL", "r*", Callee),
    Instruction {"RET", Group::Control, "r", No, {}, {}, false, false, "", "$RV"},
    Instruction {"GETARG", Group::Control, "wr", No, {}, {}, false, false, "", "", Generation::Dx100},
    control("MACRO1", "r*", Callee),
    control("MACRO2", "r*", Callee),
    control("PSTART"),
    control("PWAIT", "r*", Task),
    control("TIMER", "r*", Time),
    structure("IFTHEN", Structure::If, Block::Opens),
    structure("IFTHENEXP", Structure::If, Block::Opens),
    structure("ELSEIF", Structure::If, Block::Divides),
    structure("ELSEIFEXP", Structure::If, Block::Divides),
    structure("ELSE", Structure::If, Block::Divides),
    structure("ENDIF", Structure::If, Block::Closes),
    structure("WHILE", Structure::While, Block::Opens),
    structure("WHILEEXP", Structure::While, Block::Opens),
    structure("ENDWHILE", Structure::While, Block::Closes),
    structure("FOR", Structure::For, Block::Opens, "w"),
    structure("NEXT", Structure::For, Block::Closes, "m"),
    structure("SWITCH", Structure::Switch, Block::Opens),
    structure("CASE", Structure::Switch, Block::Divides),
    structure("DEFAULT", Structure::Switch, Block::Divides),
    structure("ENDSWITCH", Structure::Switch, Block::Closes),
    control("PAUSE", "r*", Person),
    control("ABORT"),
    control("MSG"),
    Instruction {"SETUALM", Group::Control, "-r*", No, {}, {}, false, false, "", "alarm_#"},
    control("INPUT", "w", Person),
    control("DIALOG", "wr*", Person),
    control("PRINT"),
    control("CLS"),
    control("CWAIT", "", MotionEnd),
    control("ADVINIT"),
    control("ADVSTOP"),
    control("SETTM"),
    control("LATESTJOB"),
    control("EI"),
    control("DI"),
    control("DELAY", "r*", Time),
    control("LOADJ", "r*", Process),
    control("SAVEJ", "r*", Process),
    control("DELETEJ", "r*", Process),
    control("LOADV", "r*", Process),
    control("SAVEV", "r*", Process),
    control("SWAIT", "r*", Process),
    // reference §6.4
    operating("SET", "wr"),
    operating("ADD", "mr"),
    operating("SUB", "mr"),
    operating("MUL", "mr"),
    operating("DIV", "mr"),
    operating("INC", "m"),
    operating("DEC", "m"),
    operating("CLEAR", "w-"),
    operating("AND", "mr"),
    operating("OR", "mr"),
    operating("XOR", "mr"),
    operating("NOT", "wr"),
    operating("SETE", "wr"),
    operating("GETE", "wr"),
    operating("GETS", "wr"),
    operating("GETPOS", "wr"),
    operating("CNVRT", "wr*"),
    operating("SQRT", "wr"),
    operating("SIN", "wr"),
    operating("COS", "wr"),
    operating("ATAN", "wr"),
    operating("MFRAME", "wr*"),
    operating("MULMAT", "wr*"),
    operating("INVMAT", "wr"),
    operating("MSHIFT", "wr*"),
    operating("CONVSFT", "wr*"),
    operating("SETFILE", "wr"),
    operating("GETFILE", "wr"),
    operating("GETTOOL", "wr"),
    operating("SETTOOL", "wr"),
    Instruction {"GETPRM", Group::Operating, "w", No, {}, {}, false, false, "parameter", ""},
    Instruction {"SETPRM", Group::Operating, "r", No, {}, {}, false, false, "", "parameter"},
    operating("VAL", "wr*"),
    operating("VAL2STR", "wr*"),
    operating("ASC", "wr*"),
    operating("CHR$", "wr*"),
    operating("MID$", "wr*"),
    operating("LEN", "wr*"),
    operating("CAT$", "wr*"),
    operating("STRSTR", "wr*"),
    operating("GETNAME", "wr*"),
    // reference §6.5
    shift("SFTON"),
    shift("SFTOF"),
    shift("SSFTOF"),
    shift("SFTON3D"),
    shift("SFTOF3D"),
    // reference §6.6
    process("ARCON", Process),
    process("ARCOF", Process),
    process("ARCSET"),
    process("ARCCTS"),
    process("ARCCTE"),
    process("VWELD"),
    process("AWELD"),
    process("WVON"),
    process("WVOF"),
    process("SWVON"),
    process("SWVOF"),
    process("WVADJ"),
    process("COMARCON"),
    process("COMARCOF"),
    process("TCPON"),
    process("TCPOF"),
    process("MEMON"),
    process("MEMOF"),
    process("SPOT", Process),
    process("GUNCL", Process),
    process("STROKE"),
    process("STRWAIT", Process),
    process("SVSPOT", Process),
    process("SVGUNCL", Process),
    process("GUNCHG", Process),
    Instruction {"HAND", Group::Process, "-", No, {}, {}, false, false, "", "tool_valve_#"},
    Instruction {"HSEN", Group::Process, "-", Process, {}, {}, false, false, "sensor_#", "$B006"},
    process("TOOLON", Process),
    process("TOOLOF", Process),
    process("SYSTART", Process),
    process("SYEND"),
    process("SHCKSET"),
    process("SHCKRST"),
    process("CLRSENS"),
    process("MRESET"),
};

constexpr std::array tags {
    Tag {"VJ", "%", 0.01, 100},
    Tag {"V", "mm/s"},
    Tag {"VR", "°/s"},
    Tag {"VE", "%"},
    Tag {"VMAX", "%", 50, 100},
    Tag {"PL", "", 0, 8},
    Tag {"CR", "mm", 0.1, 6553.5},
    Tag {"PD", "mm"},
    Tag {"ACC", "%", 20, 100},
    Tag {"DEC", "%", 20, 100},
    Tag {"DIS", "mm"},
    Tag {"T", "s", 0.001, 655.35},
    Tag {"BV", "V"},
    Tag {"OFV", "V"},
    Tag {"AC", "A"},
    Tag {"AV", "V"},
    Tag {"AVP", "%"},
    Tag {"SMODE", "", 0, 2},
};

constexpr const char *conditionWords[] {
    "IF", "IFEXPRESS", "ANDIF", "ORIF", "ANDEXP", "OREXP", "FOREXPRESS", "UNTIL", "SRCH", "ASRCH", "HPSRCH", "NSRCH"};

using Rows = QHash<QByteArrayView, const Instruction *>;

Rows byWord()
{
    Rows result;
    for (const Instruction &row : rows)
        result.insert(row.word, &row);
    return result;
}

} // namespace

std::span<const Instruction> instructions() { return rows; }

const Instruction *findInstruction(QByteArrayView word)
{
    static const Rows table = byWord();
    return table.value(word);
}

const Tag *findTag(QByteArrayView name)
{
    const auto found = std::ranges::find_if(tags, [name](const Tag &tag) { return name == tag.name; });
    return found == std::end(tags) ? nullptr : &*found;
}

bool beginsCondition(QByteArrayView keyword)
{
    return std::ranges::any_of(conditionWords, [keyword](const char *word) { return keyword == word; });
}

} // namespace inform
