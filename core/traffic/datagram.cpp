// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "traffic/datagram.h"

#include <QtEndian>

namespace traffic {

namespace {

constexpr quint16 etherIpv4 = 0x0800;
constexpr quint16 etherVlan = 0x8100;
constexpr quint16 etherServiceVlan = 0x88A8;
constexpr quint8 udp = 17;

template <typename Number> Number big(QByteArrayView bytes, qsizetype at)
{
    return qFromBigEndian<Number>(bytes.data() + at);
}

QByteArrayView from(QByteArrayView bytes, qsizetype at)
{
    return at < bytes.size() ? bytes.sliced(at) : QByteArrayView {};
}

/// What stands behind an EtherType at `at`, past any VLAN tags.
QByteArrayView afterEtherType(QByteArrayView frame, qsizetype at)
{
    while (at + 2 <= frame.size()) {
        const auto type = big<quint16>(frame, at);
        if (type == etherIpv4)
            return from(frame, at + 2);
        if (type != etherVlan && type != etherServiceVlan)
            break;
        at += 4;
    }
    return {};
}

bool isIpv4(QByteArrayView bytes) { return !bytes.isEmpty() && quint8(bytes[0]) >> 4 == 4; }

QByteArrayView ifIpv4(QByteArrayView bytes) { return isIpv4(bytes) ? bytes : QByteArrayView {}; }

} // namespace

std::optional<QByteArrayView> ipv4In(int linkType, QByteArrayView frame)
{
    switch (linkType) {
    case 1: return afterEtherType(frame, 12); // Ethernet
    case 0: // BSD loopback: four bytes of address family
    case 108: return ifIpv4(from(frame, 4));
    case 12: // raw IP, by several numbers
    case 14:
    case 101:
    case 228: return ifIpv4(frame);
    case 113: return afterEtherType(frame, 14); // Linux "any"
    case 276: return frame.size() >= 20 && big<quint16>(frame, 0) == etherIpv4 ? frame.sliced(20) : QByteArrayView {};
    default: return std::nullopt;
    }
}

std::optional<Datagram> datagramIn(QByteArrayView ipv4)
{
    if (ipv4.size() < 20 || !isIpv4(ipv4) || quint8(ipv4[9]) != udp)
        return std::nullopt;
    const qsizetype headerSize = (quint8(ipv4[0]) & 0x0F) * 4;
    const bool isFragment = (big<quint16>(ipv4, 6) & 0x3FFF) != 0; // an offset, or more to come
    if (headerSize < 20 || ipv4.size() < headerSize + 8)
        return std::nullopt;
    const QByteArrayView segment = ipv4.sliced(headerSize);
    const qsizetype announced = big<quint16>(segment, 4) - 8;
    Datagram datagram;
    datagram.from = {big<quint32>(ipv4, 12), big<quint16>(segment, 0)};
    datagram.to = {big<quint32>(ipv4, 16), big<quint16>(segment, 2)};
    datagram.isWhole = !isFragment && announced >= 0 && segment.size() - 8 >= announced;
    if (datagram.isWhole)
        datagram.payload = segment.sliced(8, announced);
    return datagram;
}

} // namespace traffic
