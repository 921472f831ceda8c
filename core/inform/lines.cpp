// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "inform/lines.h"

#include <cstring>

namespace inform {

std::vector<TextLine> splitLines(QByteArrayView content)
{
    std::vector<TextLine> lines;
    lines.reserve(std::size_t(content.size() / 24));
    while (!content.isEmpty()) {
        const void *found = std::memchr(content.data(), '\n', std::size_t(content.size()));
        const qsizetype at = found ? static_cast<const char *>(found) - content.data() : -1;
        const qsizetype end = found ? at + 1 : content.size();
        const bool hasReturn = at > 0 && content[at - 1] == '\r';
        const qsizetype size = found ? at - (hasReturn ? 1 : 0) : end;
        lines.push_back({content.first(size), content.sliced(size, end - size)});
        content = content.sliced(end);
    }
    return lines;
}

QByteArrayView withoutBlanks(QByteArrayView text)
{
    const auto isBlank = [](char byte) { return byte == ' ' || byte == '\t' || byte == '\r'; };
    while (!text.isEmpty() && isBlank(text.front()))
        text = text.sliced(1);
    while (!text.isEmpty() && isBlank(text.back()))
        text.chop(1);
    return text;
}

std::vector<QByteArrayView> splitAt(QByteArrayView text, char separator)
{
    std::vector<QByteArrayView> parts;
    while (true) {
        const qsizetype found = text.indexOf(separator);
        parts.push_back(withoutBlanks(found < 0 ? text : text.first(found)));
        if (found < 0)
            return parts;
        text = text.sliced(found + 1);
    }
}

} // namespace inform
