// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include <QByteArray>
#include <QByteArrayView>
#include <vector>

namespace inform {

/// One line of any text, as a place in it.
struct TextLine {
    QByteArrayView text; ///< Without its ending.
    QByteArrayView ending; ///< "\r\n" or "\n"; empty for the last line of a text that does not end in one.

    [[nodiscard]] QByteArray whole() const { return text.toByteArray() + ending.toByteArray(); }
};

/// The lines of `content`, which must outlive them. Joined again they are the same bytes, whatever those are.
[[nodiscard]] std::vector<TextLine> splitLines(QByteArrayView content);

/// Without the blanks and tabs at both ends.
[[nodiscard]] QByteArrayView withoutBlanks(QByteArrayView text);
/// Cut at every `separator`, blanks around the parts removed. One part for an empty text.
[[nodiscard]] std::vector<QByteArrayView> splitAt(QByteArrayView text, char separator);

} // namespace inform
