// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include <QFileDialog>
#include <QWidget>
#include <functional>

namespace widgets {

/// What kind of path a person is asked for.
enum class PathKind {
    OldFile, ///< One that exists.
    NewFile, ///< One that is to be written; the person is asked before it is replaced.
    Folder, ///< One that exists.
};

struct PathQuestion {
    const char *name; ///< Object name of the QFileDialog.
    PathKind kind;
    QString title;
    QString begin {}; ///< Folder, or file with its folder, to begin with.
    QStringList filters {}; ///< "CSV files (*.csv)"; none for folders.
    QString suffix {}; ///< Added to a new name that has none: "csv".
};

/// Qt's file dialog in a sheet; `then` runs once, after the sheet is closed, with the path that was chosen. Returns the
/// dialog, which is deleted with the sheet.
QFileDialog *askForPath(
    const PathQuestion &question, QWidget *owner, const std::function<void(const QString &path)> &then);

} // namespace widgets
