// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "protocol/plural.h"

namespace protocol {

namespace {

/// Full packets, and an odd item left over as a chunk of its own.
QList<Chunk> chunks(PluralRule rule, InstanceRange range)
{
    QList<Chunk> result;
    for (int first = range.first; first <= range.last;) {
        int count = std::min(rule.maxCount(), range.last - first + 1);
        if (rule.isEven() && count > 1)
            count -= count % 2;
        result += {quint16(first), quint16(count), quint16(count)};
        first += count;
    }
    return result;
}

} // namespace

QList<Chunk> chunksToRead(PluralRule rule, InstanceRange range, quint16 lastOfArea)
{
    QList<Chunk> result = chunks(rule, range);
    if (result.size() < 2 || result.last().count != 1 || !rule.isEven())
        return result;
    Chunk &previous = result[result.size() - 2];
    if (range.last == lastOfArea || previous.count == rule.maxCount())
        return result;
    previous = {previous.first, quint16(previous.count + 2), quint16(previous.wanted + 1)};
    result.removeLast();
    return result;
}

QList<Chunk> chunksToWrite(PluralRule rule, InstanceRange range) { return chunks(rule, range); }

} // namespace protocol
