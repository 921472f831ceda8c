// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "traffic/packet.h"
#include <functional>

namespace traffic {

/// Packets as a capture file in the format pcapng (draft-ietf-opsawg-pcapng): one section, one interface of link type
/// IPV4, one enhanced packet block a packet with its UTC time in microseconds. Programs that read it see the addresses
/// and ports of the real datagrams; where this computer's own address is not known, it is 0.0.0.0.
/// `commentOf` gives the comment that is kept with a packet; empty for none.
[[nodiscard]] QByteArray toPcapng(
    const QList<Packet> &packets, const std::function<QString(const Packet &)> &commentOf = {});

/// The HSES packets of a capture file, pcapng or the older pcap. What is left out is counted, never guessed.
struct Capture {
    QList<Packet> packets; ///< In the order of the file, numbered from 1; a partner is found by id, as in PacketLog.
    qsizetype others = 0; ///< Frames that are no UDP datagram to or from a port of a controller.
    qsizetype fragments = 0; ///< IP fragments, and datagrams of which the capture kept a part.
    QList<Endpoint> controllers; ///< Each robot or file port that was seen, in the order of appearance.
    QString trouble; ///< Why reading ended before the end of the file, untranslated; empty if it did not.
};

struct CapturePorts {
    quint16 robot = protocol::robotPort;
    quint16 file = protocol::filePort;
};

/// Reads at most `mostPackets`; Malformed if `file` is no capture, or none of a link that carries IPv4.
[[nodiscard]] values::Result<Capture> readCapture(
    const QByteArray &file, const CapturePorts &ports = {}, qsizetype mostPackets = 1'000'000);

} // namespace traffic
