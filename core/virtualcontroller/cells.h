// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "virtualcontroller/handlers.h"

namespace virtualcontroller {

/// What the commands of reference §4 read and write: I/O groups, registers and variables, each kind described once for
/// its single and its plural command. `number` exists, and `bytes` have the size of what is written. An `element` of 0
/// means all of them.
struct CellKind {
    quint16 single;
    quint16 plural;
    bool isVariable; ///< The instance follows RS022.
    Answer (*load)(const Memory &, int number, int element);
    void (*store)(Memory &, int number, QByteArrayView bytes, int element);
    /// An added status for values that the cell cannot take, or 0.
    quint16 (*check)(QByteArrayView bytes, int element);

    /// The number behind an instance.
    [[nodiscard]] int number(quint16 instance, const Memory &memory) const
    {
        return instance - (isVariable ? int(memory.dialect.numbering) : 0);
    }
};

[[nodiscard]] std::span<const CellKind> cellKinds();
/// The kind that a command, single or plural, is about; it is one of §4.
[[nodiscard]] const CellKind &cellKind(quint16 command);

} // namespace virtualcontroller
