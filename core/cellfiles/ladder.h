// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "cellfiles/outline.h"
#include <QMap>

namespace cellfiles {

/// What one instruction of the ladder reads or writes: signals by logical number, "M100" for a register.
struct LadderOperand {
    enum class Kind { Signal, Register } kind = Kind::Signal;
    int number = 0;

    auto operator<=>(const LadderOperand &) const = default;
};
[[nodiscard]] QString toString(const LadderOperand &operand);

struct LadderInstruction {
    QByteArray mnemonic; ///< "AND-NOT"
    QByteArray operands; ///< "#20017", "M100,25"; as they are written.
    int part = 0; ///< 1 the system's, 2 the user's; 0 before any.
    int line = 0;
    bool isUnderstood = true;
    QList<LadderOperand> reads {};
    QList<LadderOperand> writes {};

    [[nodiscard]] QByteArray text() const { return operands.isEmpty() ? mnemonic : mnemonic + ' ' + operands; }
};

/// CIOPRG.LST: the ladder, and the texts of user alarms and messages (controller files reference §8).
struct Ladder {
    QString name;
    QByteArray tag;
    QByteArray application;
    QList<QList<qint64>> presets; ///< Of timers and counters, eight rows of ten.
    QList<LadderInstruction> instructions;
    QMap<QByteArray, QMap<int, QString>> texts; ///< "ALARM1": row from 0; those that are not empty.
    QMap<QByteArray, int> textRows; ///< How many rows each table has.

    static constexpr int firstAlarm = 9000; ///< Row 0 of ALARM1 and ALARM2.
};
[[nodiscard]] Parsed<Ladder> ladderFrom(QByteArrayView file, const protocol::TextCodec &codec);

} // namespace cellfiles
