// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "traffic/capture.h"

#include <QtEndian>

namespace traffic {

namespace {

// Numbers of the pcapng draft; those of IP and UDP are in network order, those of pcapng in the order of the section.
constexpr quint32 sectionHeader = 0x0A0D0D0A;
constexpr quint32 interfaceDescription = 1;
constexpr quint32 enhancedPacket = 6;
constexpr quint32 byteOrderMagic = 0x1A2B3C4D;
constexpr quint16 linkTypeIpv4 = 228;
constexpr quint16 commentOption = 1;
constexpr qsizetype longestComment = 8192;
constexpr int ipHeaderSize = 20;
constexpr int udpHeaderSize = 8;

class Bytes
{
public:
    template <typename Number> Bytes &little(Number value) { return append(qToLittleEndian(value)); }
    template <typename Number> Bytes &big(Number value) { return append(qToBigEndian(value)); }
    Bytes &raw(QByteArrayView bytes)
    {
        m_bytes.append(bytes);
        return *this;
    }
    /// Up to a border of 32 bits.
    Bytes &pad()
    {
        m_bytes.append((4 - m_bytes.size() % 4) % 4, '\0');
        return *this;
    }
    [[nodiscard]] const QByteArray &bytes() const { return m_bytes; }
    [[nodiscard]] qsizetype size() const { return m_bytes.size(); }

private:
    template <typename Number> Bytes &append(Number value)
    {
        m_bytes.append(reinterpret_cast<const char *>(&value), sizeof value);
        return *this;
    }

    QByteArray m_bytes;
};

QByteArray block(quint32 type, const QByteArray &body)
{
    const auto total = quint32(body.size() + 12);
    return Bytes {}.little(type).little(total).raw(body).little(total).bytes();
}

QByteArray head()
{
    const QByteArray section =
        Bytes {}.little(byteOrderMagic).little(quint16(1)).little(quint16(0)).little(qint64(-1)).bytes();
    const QByteArray interface = Bytes {}.little(linkTypeIpv4).little(quint16(0)).little(quint32(0)).bytes();
    return block(sectionHeader, section) + block(interfaceDescription, interface);
}

/// The ones' complement sum of RFC 1071.
quint16 checksum(QByteArrayView bytes)
{
    quint32 sum = 0;
    for (qsizetype i = 0; i + 1 < bytes.size(); i += 2)
        sum += qFromBigEndian<quint16>(bytes.data() + i);
    while (sum >> 16)
        sum = (sum & 0xFFFF) + (sum >> 16);
    return quint16(~sum);
}

QByteArray ipHeader(const Endpoint &from, const Endpoint &to, qsizetype udpSize, quint16 sum)
{
    constexpr quint16 dontFragment = 0x4000;
    constexpr quint8 timeToLive = 64;
    constexpr quint8 udpProtocol = 17;
    return Bytes {}
        .big(quint8(0x45))
        .big(quint8(0))
        .big(quint16(ipHeaderSize + udpSize))
        .big(quint16(0))
        .big(dontFragment)
        .big(timeToLive)
        .big(udpProtocol)
        .big(sum)
        .big(from.address)
        .big(to.address)
        .bytes();
}

/// The datagram with its headers. A UDP checksum of 0 says that none was made (RFC 768).
QByteArray datagram(const Packet &packet)
{
    const bool isSent = packet.passage == Passage::Sent;
    const Endpoint &from = isSent ? packet.own : packet.other;
    const Endpoint &to = isSent ? packet.other : packet.own;
    const qsizetype size = udpHeaderSize + packet.bytes.size();
    const quint16 sum = checksum(ipHeader(from, to, size, 0));
    return Bytes {}
        .raw(ipHeader(from, to, size, sum))
        .big(from.port)
        .big(to.port)
        .big(quint16(size))
        .big(quint16(0))
        .raw(packet.bytes)
        .bytes();
}

QByteArray options(const QString &comment)
{
    if (comment.isEmpty())
        return {};
    const QByteArray text = comment.toUtf8().left(longestComment);
    return Bytes {}.little(commentOption).little(quint16(text.size())).raw(text).pad().little(quint32(0)).bytes();
}

QByteArray packetBlock(const Packet &packet, const QString &comment)
{
    const QByteArray data = datagram(packet);
    const auto time = quint64(packet.at.time_since_epoch().count());
    Bytes body;
    body.little(quint32(0)).little(quint32(time >> 32)).little(quint32(time));
    body.little(quint32(data.size())).little(quint32(data.size())).raw(data).pad().raw(options(comment));
    return block(enhancedPacket, body.bytes());
}

} // namespace

QByteArray toPcapng(const QList<Packet> &packets, const std::function<QString(const Packet &)> &commentOf)
{
    QByteArray file = head();
    for (const Packet &packet : packets)
        file += packetBlock(packet, commentOf ? commentOf(packet) : QString {});
    return file;
}

} // namespace traffic
