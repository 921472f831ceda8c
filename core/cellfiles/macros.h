// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "cellfiles/outline.h"

namespace cellfiles {

/// A macro command of MACRO.DAT (controller files reference §11).
struct Macro {
    int number = 0; ///< MJ#(number)
    int line = 0;
    QByteArray job; ///< Which job it runs; empty if none is set.
    QByteArray otherJob; ///< The second one of the entry; empty if none is set.

    bool operator==(const Macro &) const = default;
};
[[nodiscard]] Parsed<QList<Macro>> macrosFrom(QByteArrayView file);

} // namespace cellfiles
