// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "cellfiles/outline.h"
#include <QJsonArray>
#include <QStringList>

namespace cellfiles {

/// What a file says, as rows and columns: for people, for scripts, and to be compared.
struct Column {
    const char *title; ///< For title(); as it stands it is the key in JSON.
    bool isNumber = false;
    bool isPublic = false; ///< Shown of a secret row too.
};
struct Row {
    QStringList cells;
    int line = 0; ///< Where it stands in the file, from 1; 0 if nowhere in particular.
    bool isSecret = false; ///< All but the key and public columns is masked wherever it is shown (reference §15).
};
struct Table {
    const char *title; ///< For title(); as it stands it is the key in JSON.
    QList<Column> columns;
    QList<Row> rows = {};
    int keys = 1; ///< So many columns say which row it is.

    void add(int line, const QStringList &cells, bool isSecret = false) { rows.append({cells, line, isSecret}); }
};
struct View {
    QList<Table> tables;
    Warnings warnings;
};

/// A title or a column in the language of the program.
[[nodiscard]] QString title(const char *source);
/// The cells of a row as they may be shown.
[[nodiscard]] QStringList shownCells(const Table &table, const Row &row);
/// {"tables": {title: [{column: cell}]}, "warnings": [{"line": 1, "reason": "…"}]}; secrets are masked.
[[nodiscard]] QJsonObject toJson(const View &view);
/// "•••"
[[nodiscard]] QString mask();

} // namespace cellfiles
