// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "virtualcontroller/handlers.h"

namespace virtualcontroller {

/// What the commands of reference §4 read and write: I/O groups, registers and variables, each kind described once for
/// its single and its plural command.
struct CellKind {
    quint16 single;
    quint16 plural;
    qsizetype size; ///< Bytes of an item in a plural command.
    bool isEven; ///< A plural command takes only even counts (reference §4.5).
    bool isNumbered; ///< The instance follows RS022: Settings::numbering.
    bool (*exists)(const Memory &, int number);
    quint16 (*writeRefusal)(const Memory &, int number); ///< An added status, or 0.
    /// `attribute` is 0 for all elements.
    Answer (*load)(const Memory &, int number, int attribute);
    /// An added status, or 0; a size that does not fit is 0xB003. Nothing is changed then.
    quint16 (*store)(Memory &, int number, QByteArrayView bytes, int attribute);

    /// The number behind an instance.
    [[nodiscard]] int number(quint16 instance, const Memory &memory) const
    {
        return instance - (isNumbered ? memory.settings.numbering : 0);
    }
};

/// The kind that a command, single or plural, is about; nullptr for other commands.
[[nodiscard]] const CellKind *findCellKind(quint16 command);

} // namespace virtualcontroller
