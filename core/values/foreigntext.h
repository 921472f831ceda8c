// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include <QString>

/// Text from outside (a controller, a file name, a stored name), made harmless for the place where it is put: one
/// function a place. What cannot be shown is shown as its code, ⟨1B⟩ or ⟨U+202E⟩; nothing is dropped.
namespace values {

/// Longer lines are cut where they are shown; the data itself never is.
inline constexpr qsizetype longestShownLine = 2000;

/// One line for a terminal or a text file: no line break, no escape sequence or other control character, no mark that
/// turns the direction of writing or cannot be seen. Longer than `most` characters it is cut and says by how much.
[[nodiscard]] QString oneLine(QStringView text, qsizetype most = longestShownLine);

/// The same for HTML, and so for what is printed from it: markup is text.
[[nodiscard]] QString htmlLine(QStringView text, qsizetype most = longestShownLine);

/// JSON whose strings hold such marks as \u escapes, so that it means the same and does nothing to a terminal.
[[nodiscard]] QByteArray plainJson(const QByteArray &json);

/// A text for a cell of a table that a spreadsheet opens: one that would begin a formula there (= + - @ or a tab) gets
/// an apostrophe in front. Not for numbers.
[[nodiscard]] QString csvText(const QString &text);
/// The text that csvText() made `cell` of; other cells stay.
[[nodiscard]] QString fromCsvText(const QString &cell);

} // namespace values
