// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "values/position.h"
#include <QByteArrayList>
#include <map>
#include <tl/expected.hpp>
#include <vector>

namespace virtualcontroller {

/// One line of a job, cut at its spaces: "MOVJ", "C00000", "VJ=5.00". A comment is one word.
struct Instruction {
    QByteArrayList words;

    [[nodiscard]] QByteArray word() const { return words.value(0); }
    [[nodiscard]] QByteArray operand(int index) const { return words.value(index); }
    /// What follows `key`, as "5.00" for "VJ=" in "VJ=5.00"; empty without such an operand.
    [[nodiscard]] QByteArray valueOf(QByteArrayView key) const;
    [[nodiscard]] bool isMove() const { return word().startsWith("MOV"); }
    [[nodiscard]] bool isComment() const { return word().startsWith('\''); }
    [[nodiscard]] bool isLabel() const { return word().startsWith('*'); }
};

/// An INFORM job as the controller holds it, read from the text of a JBI file (reference §7.8).
struct Program {
    QByteArray name;
    std::vector<Instruction> lines; ///< Line 0 is NOP, the last one END.
    std::map<QByteArray, values::Position> positions; ///< By name, such as C00000.
    std::map<QByteArray, int> labels; ///< Line of a label, with its star.
    bool isReadOnly = false; ///< ///ATTR names RO.

    /// Number of move instructions up to and with `line`.
    [[nodiscard]] int stepAt(int line) const;
};

/// The job in `text`, or the added status (reference §9) with which a controller refuses it: 0x5130 without NOP or END,
/// 0x5340 for a pseudo instruction, 0x5180 if ///NPOS counts wrong, 0x5110 for an instruction, 0x5310 for anything
/// else, 0x4190 for the name.
[[nodiscard]] tl::expected<Program, quint16> parseProgram(const QByteArray &text);

} // namespace virtualcontroller
