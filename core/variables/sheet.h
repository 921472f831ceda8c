// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "variables/csv.h"
#include "variables/text.h"
#include <functional>

namespace variables {

/// One value that a file or a pasted block would change.
struct Difference {
    int line = 0; ///< Of the text, from 1.
    Reference variable;
    std::optional<Value> was; ///< nullopt if it was never read.
    Value value;
};

/// What is wrong with a line; line 0: with all of it.
struct Problem {
    int line = 0;
    QString reason; ///< A whole, translated sentence.

    bool operator==(const Problem &) const = default;
};

/// What a file or a pasted block would do. Nothing of it is done while anything is wrong with it.
struct Preview {
    QList<Difference> differences; ///< In the order of the lines.
    QList<Problem> problems;
    int unchanged = 0; ///< Lines that hold what is there already.
};

/// The value that a variable has now, as far as it was read.
using Lookup = std::function<std::optional<Value>(const Reference &)>;

/// Reads a table with a header. Columns are found by their names in any order: "variable" and "value", and for
/// positions "type", "tool", "frame", "form", "extended form" and "axis 1" to "axis 8", of which those that are missing
/// or empty stay as they are. Other columns are left alone.
[[nodiscard]] Preview preview(
    const Table &table, const Format &format, const protocol::Dialect &dialect, const Lookup &now);

/// The same for a pasted block. Without a header it is either variables and values, or values alone, which go to
/// `first` and the following.
[[nodiscard]] Preview previewBlock(QStringView text, const Reference &first, const Format &format,
    const protocol::Dialect &dialect, const Lookup &now);

struct ExportRow {
    Reference variable;
    QString name;
    std::optional<Value> value; ///< Without one the cells are empty.
};

/// CSV with a header that preview() reads. Position columns are there only if a position is.
[[nodiscard]] QString toCsv(const QList<ExportRow> &rows, const Format &format);

} // namespace variables
