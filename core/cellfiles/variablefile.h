// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "cellfiles/outline.h"
#include "variables/reference.h"
#include <QHash>
#include <array>

namespace cellfiles {

/// What a position of a file is relative to (controller files reference §6). Here 18 is tool and 19 user.
enum class PositionFrame { Pulse = 0, Base = 16, Robot = 17, Tool = 18, User = 19, MasterTool = 20 };

/// One line of P, BP or EX.
struct FilePosition {
    PositionFrame frame = PositionFrame::Pulse;
    int userFrame = 0;
    int tool = 0;
    quint32 form = 0; ///< Bit 0 rear, 1 lower arm, 2 no-flip, 3 R ≥ 180, 4 T ≥ 180, 5 S ≥ 180, then reserve.
    std::array<qint64, 8> axes {}; ///< Pulses, or X Y Z in micrometres and angles in 0.0001 degrees.

    [[nodiscard]] bool isPulse() const { return frame == PositionFrame::Pulse; }
    bool operator==(const FilePosition &) const = default;
};
/// "robot coordinates"
[[nodiscard]] QString toString(PositionFrame frame);

enum class Slot {
    Unread, ///< It could not be read, or the file ends before it: nothing is known.
    Unused,
    Used,
};
struct PositionSlot {
    Slot slot = Slot::Unread;
    FilePosition position {};

    bool operator==(const PositionSlot &) const = default;
};

/// VAR.DAT: all variables by kind and number.
struct VariableFile {
    QList<qint64> axisCounts; ///< Of robot, base and station, and one more.
    QHash<variables::Kind, int> shares; ///< How many there are of each kind.
    QHash<variables::Kind, QList<std::optional<qint64>>> integers; ///< B I D.
    QList<QByteArray> reals; ///< R as it is written; empty if it is no number.
    QList<QByteArray> strings; ///< S as they are, blanks and quotes too.
    QHash<variables::Kind, QList<PositionSlot>> positions; ///< P BP EX.
};
[[nodiscard]] Parsed<VariableFile> variablesFrom(QByteArrayView file);

} // namespace cellfiles
