// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "traffic/packet.h"
#include <optional>

namespace traffic {

/// A UDP datagram inside an IPv4 packet; `payload` views the frame.
struct Datagram {
    Endpoint from;
    Endpoint to;
    QByteArrayView payload;
    bool isWhole = true; ///< Not a fragment, and all of it is there.
};

/// The IPv4 packet in a frame of this link type (the LINKTYPE numbers of pcap); empty if the frame holds none.
/// nullopt if frames of this link type are not understood.
[[nodiscard]] std::optional<QByteArrayView> ipv4In(int linkType, QByteArrayView frame);
/// nullopt if the packet is not UDP over IPv4, or its headers are cut.
[[nodiscard]] std::optional<Datagram> datagramIn(QByteArrayView ipv4);

} // namespace traffic
