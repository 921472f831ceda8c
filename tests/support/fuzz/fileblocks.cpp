// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "support/fuzz/target.h"

#include "protocol/fileblocks.h"
#include "protocol/packet.h"

using namespace protocol;

namespace fuzz {

namespace {

/// Blocks as a controller might send them: two bytes choose the number and the mark, one the size.
void collectsBlocks(Source &source)
{
    BlockCollector collector;
    QByteArray taken;
    while (!source.rest().isEmpty()) {
        const quint32 last = source.byte() & 1 ? lastBlock : 0;
        const quint32 number = source.byte() % 8;
        const auto content = source.take(source.byte());
        const auto step = collector.take(
            {{Division::File, true, 1, number | last}, replyService(Service::ListFiles), 0, 0, 0, content});
        if (step && *step != BlockCollector::Step::Repeated)
            taken += content;
        require(!step || *step == BlockCollector::Step::Repeated || collector.isComplete() == (last != 0),
            "the last block is not the last one");
    }
    require(collector.content() == taken, "blocks were lost");
}

/// A file cut into blocks of a size that one byte chooses.
void loadsBlocks(Source &source)
{
    const qsizetype size = 16 + source.byte();
    const auto content = source.rest();
    const quint32 count = blockCount(content, size);
    QByteArray joined;
    for (quint32 index = 1; index <= count; ++index) {
        const QByteArray datagram = encodeLoadBlock(content, index, 1, size);
        const auto block = parseClientPacket(datagram);
        require(block && block->framing.block == blockNumber(index, count), "a block is no packet");
        joined += block->payload;
    }
    require(joined == content, "a load changed its content");
}

void take(QByteArrayView data)
{
    Source source {data};
    if (source.byte() % 2)
        collectsBlocks(source);
    else
        loadsBlocks(source);
}

Seeds seeds()
{
    return {QByteArrayLiteral("\0\0") + QByteArray(100, 'A'), QByteArrayLiteral("\1\0\1\2AB\1\2\1C"),
        QByteArrayLiteral("\1\0\1\1A\0\1\1A\1\2\1B")};
}

} // namespace

extern const Target fileBlocks;
const Target fileBlocks {"fileBlocks", take, seeds, 520};

} // namespace fuzz
