// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "protocol/dialect.h"
#include "protocol/layout.h"
#include "protocol/packet.h"
#include <QList>

namespace protocol {

/// How many items one plural packet may carry (reference §4.5): all that fit behind the count, and an even number of
/// them if an item is a single byte.
struct PluralRule {
    static constexpr qsizetype countSize = 4;
    qsizetype itemSize;

    [[nodiscard]] constexpr bool isEven() const { return itemSize == 1; }
    [[nodiscard]] constexpr int maxCount() const
    {
        const int fitting = int((maxPayloadSize - countSize) / itemSize);
        return isEven() ? fitting - fitting % 2 : fitting;
    }
    [[nodiscard]] constexpr bool allows(quint32 count) const
    {
        return count > 0 && count <= quint32(maxCount()) && !(isEven() && count % 2);
    }
};

template <typename Item> [[nodiscard]] PluralRule pluralRule() { return {measure<Item>().bytes}; }

/// One packet of a range that is read or written in several.
struct Chunk {
    quint16 first;
    quint16 count; ///< What the packet asks for; 1 means that it is read or written singly.
    quint16 wanted; ///< How many of them belong to the range; the rest is dropped.

    [[nodiscard]] constexpr bool isSingle() const { return count == 1; }
    bool operator==(const Chunk &) const = default;
};

/// The fewest packets that read `range`. Where the count must be even, one more is asked for; if that would pass
/// `lastOfArea`, the last one is read singly.
[[nodiscard]] QList<Chunk> chunksToRead(PluralRule rule, InstanceRange range, quint16 lastOfArea);
/// The fewest packets that write `range` and nothing beside it.
[[nodiscard]] QList<Chunk> chunksToWrite(PluralRule rule, InstanceRange range);

/// The items behind the count. Malformed if the count is not `expected` or the bytes do not fit it.
template <typename Item>
[[nodiscard]] values::Result<QList<Item>> decodePlural(QByteArrayView payload, quint32 expected)
{
    const qsizetype itemSize = pluralRule<Item>().itemSize;
    if (payload.size() != PluralRule::countSize + qsizetype(expected) * itemSize
        || qFromLittleEndian<quint32>(payload.data()) != expected)
        return values::failure(values::ErrorKind::Malformed,
            QStringLiteral("a payload of %1 bytes does not hold %2 items").arg(payload.size()).arg(expected));
    QList<Item> items(qsizetype(expected), Item {});
    Reader reader {payload.sliced(PluralRule::countSize)};
    for (Item &item : items)
        Layout<Item>::describe(reader, item);
    if (!reader.isComplete())
        return values::failure(values::ErrorKind::Malformed, QStringLiteral("an item does not fit"));
    return items;
}

/// The count and the items; without items, what a read request carries.
template <typename Item> [[nodiscard]] QByteArray encodePlural(quint32 count, const QList<Item> &items = {})
{
    QByteArray payload(PluralRule::countSize, '\0');
    qToLittleEndian(count, payload.data());
    for (const Item &item : items)
        payload += encode(item);
    return payload;
}

} // namespace protocol
