// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "values/error.h"
#include <QStringList>

namespace variables {

/// A line of a table; `line` counts the lines of the text from 1, which a cell with line breaks makes more of.
struct Line {
    int line = 1;
    QStringList cells;

    bool operator==(const Line &) const = default;
};

/// What a CSV file or a block of a spreadsheet holds.
struct Table {
    QList<Line> lines; ///< Without the blank ones.
    QChar separator = u',';
};

/// Text of a file: UTF-8 or, with a byte order mark, UTF-16. BadInput with a whole, translated sentence for bytes that
/// are neither.
[[nodiscard]] values::Result<QString> textOfFile(QByteArrayView bytes);

/// Reads RFC 4180, with "," ";" or a tab: whichever the first line has most of outside quotes. BadInput with a whole,
/// translated sentence that names the line if a quoted cell does not end as it must.
[[nodiscard]] values::Result<Table> readTable(QStringView text);

/// One line of RFC 4180, with CR LF; cells that need it are quoted.
[[nodiscard]] QString csvLine(const QStringList &cells, QChar separator = u',');

} // namespace variables
