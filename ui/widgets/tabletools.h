// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "journal/tablewriter.h"
#include <functional>

class QAbstractButton;
class QTableView;
class QWidget;

namespace widgets {

/// Makes each column as wide as its sample or its head needs; the column with an empty sample takes the rest.
void fitColumns(QTableView *table, const QStringList &samples);

/// The selected rows as text, with the heads of the columns: tabs between cells, one line a row. All rows if none is
/// selected.
[[nodiscard]] QString rowsAsText(const QTableView *table);
/// Ctrl+C in the table, and a click on the button, put that on the clipboard.
void copyFrom(QTableView *table, QAbstractButton *button);

/// Asks where to put an export and calls `then` with path and format; not at all if the person cancels.
void askForFile(QWidget *parent, const QString &title, const QString &name,
    const std::function<void(const QString &path, journal::Format format)> &then);

} // namespace widgets
