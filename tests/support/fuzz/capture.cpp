// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "support/fuzz/target.h"

#include "traffic/capture.h"

namespace fuzz {

namespace {

/// A capture of packets: any file is read as far as it goes, within its bound; what was read is written so that it
/// reads as many.
void take(QByteArrayView data)
{
    constexpr qsizetype most = 50;
    const auto read = traffic::readCapture(data.toByteArray(), {}, most);
    if (!read) {
        require(!read.error().detail.isEmpty(), "a refusal without a sentence");
        return;
    }
    require(read->packets.size() <= most, "more packets than asked for");
    const auto again = traffic::readCapture(traffic::toPcapng(read->packets), {}, most);
    require(again && again->packets.size() <= read->packets.size(), "packets were made up");
}

Seeds seeds()
{
    QList<traffic::Packet> packets;
    for (const QByteArray &bytes : goldenPackets().mid(1, 4)) {
        traffic::Packet sent;
        sent.number = quint64(packets.size() + 1);
        sent.own = {0x7F000001, 50000};
        sent.other = {0x7F000001, protocol::robotPort};
        sent.bytes = bytes;
        packets << sent;
    }
    return {traffic::toPcapng(packets), traffic::toPcapng({}),
        QByteArray::fromHex("d4c3b2a1020004000000000000000000ffff000001000000")};
}

} // namespace

extern const Target capture;
const Target capture {"capture", take, seeds, 600, 2000};

} // namespace fuzz
