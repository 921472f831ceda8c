// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "traffic/capture.h"

#include "traffic/datagram.h"
#include <algorithm>
#include <cstdio>
#include <map>
#include <memory>
#include <pcap/pcap.h>

using protocol::Division;
using values::ErrorKind;
using values::Result;

namespace traffic {

namespace {

struct CloseCapture {
    void operator()(pcap_t *capture) const { pcap_close(capture); }
};
using OpenCapture = std::unique_ptr<pcap_t, CloseCapture>;

Result<OpenCapture> open(const QByteArray &file)
{
    std::array<char, PCAP_ERRBUF_SIZE> reason {};
    FILE *stream = file.isEmpty() ? nullptr : fmemopen(const_cast<char *>(file.constData()), size_t(file.size()), "rb");
    if (!stream)
        return values::failure(ErrorKind::Malformed, QStringLiteral("the file is empty"));
    pcap_t *capture = pcap_fopen_offline_with_tstamp_precision(stream, PCAP_TSTAMP_PRECISION_MICRO, reason.data());
    if (!capture) {
        std::fclose(stream);
        return values::failure(ErrorKind::Malformed, QString::fromLocal8Bit(reason.data()));
    }
    return OpenCapture {capture};
}

/// Which port of a controller a UDP port is.
std::optional<Division> divisionOf(quint16 port, const CapturePorts &ports)
{
    if (port == ports.robot)
        return Division::Robot;
    return port == ports.file ? std::optional {Division::File} : std::nullopt;
}

/// Puts datagrams into a capture, and finds partners by id.
class Collector
{
public:
    explicit Collector(const CapturePorts &ports) : m_ports {ports} { }

    void take(WallTime at, QByteArrayView ipv4)
    {
        const auto datagram = datagramIn(ipv4);
        const auto to = datagram ? divisionOf(datagram->to.port, m_ports) : std::nullopt;
        const auto from = datagram ? divisionOf(datagram->from.port, m_ports) : std::nullopt;
        if (!to && !from) {
            ++capture.others;
            return;
        }
        if (!datagram->isWhole) {
            ++capture.fragments;
            return;
        }
        const bool isSent = to.has_value();
        const Endpoint controller = isSent ? datagram->to : datagram->from;
        if (!capture.controllers.contains(controller))
            capture.controllers << controller;
        Packet packet {quint64(capture.packets.size() + 1), at, isSent ? Passage::Sent : Passage::Received,
            isSent ? *to : *from, Fate::Used, isSent ? datagram->from : datagram->to, controller, 0,
            datagram->payload.toByteArray()};
        join(packet);
        capture.packets << packet;
    }

    Capture capture;

private:
    using Key = std::tuple<quint32, quint16, quint16, quint8>; ///< Controller, its port, ours, the id.

    void join(Packet &packet)
    {
        if (protocol::checkFrame(packet.bytes) != protocol::FrameFault::None) {
            packet.fate = Fate::Malformed;
            return;
        }
        const Key key {packet.other.address, packet.other.port, packet.own.port, quint8(packet.bytes[11])};
        quint64 &last = m_lastSent[key];
        if (packet.passage == Passage::Received) {
            packet.partner = last;
        } else if (last && capture.packets[qsizetype(last - 1)].bytes == packet.bytes) {
            packet.partner = last;
            packet.fate = Fate::Repeat;
        } else {
            last = packet.number;
        }
    }

    CapturePorts m_ports;
    std::map<Key, quint64> m_lastSent;
};

} // namespace

Result<Capture> readCapture(const QByteArray &file, const CapturePorts &ports, qsizetype mostPackets)
{
    const auto source = open(file);
    if (!source)
        return tl::unexpected(source.error());
    const int linkType = pcap_datalink(source->get());
    if (!ipv4In(linkType, {}))
        return values::failure(ErrorKind::Malformed,
            QStringLiteral("the capture is of link type %1, which is not understood").arg(linkType));
    Collector collector {ports};
    pcap_pkthdr *header = nullptr;
    const u_char *bytes = nullptr;
    int state = 0;
    while (
        collector.capture.packets.size() < mostPackets && (state = pcap_next_ex(source->get(), &header, &bytes)) == 1) {
        const WallTime at {std::chrono::seconds {header->ts.tv_sec} + std::chrono::microseconds {header->ts.tv_usec}};
        const QByteArrayView frame {reinterpret_cast<const char *>(bytes), qsizetype(header->caplen)};
        collector.take(at, *ipv4In(linkType, frame));
    }
    if (state == PCAP_ERROR)
        collector.capture.trouble = QString::fromLocal8Bit(pcap_geterr(source->get()));
    else if (state == 1)
        collector.capture.trouble = QStringLiteral("only the first %1 packets were read").arg(mostPackets);
    return std::move(collector.capture);
}

} // namespace traffic
