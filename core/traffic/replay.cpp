// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "traffic/replay.h"

#include <algorithm>

using protocol::Division;

namespace traffic {

namespace {

constexpr quint8 refused = 0x1F; // reference §1.6
constexpr quint16 notAccessible = 0x2110; // reference §9
constexpr qsizetype ackOffset = 10;
constexpr qsizetype recordedIdOffset = 11;

bool isFrame(QByteArrayView datagram) { return protocol::checkFrame(datagram) == protocol::FrameFault::None; }

/// A request and nothing that differs from one time to the next: its id.
QByteArray keyOf(Division division, QByteArrayView request)
{
    QByteArray key = request.toByteArray();
    key[recordedIdOffset] = char(division);
    return key;
}

quint16 recordedSlot(Division division, QByteArrayView packet)
{
    return quint16(quint16(division) << 8 | quint8(packet[recordedIdOffset]));
}

bool beginsTransfer(QByteArrayView datagram) { return datagram[ackOffset] == 0; }

QByteArray withId(QByteArray packet, char id)
{
    packet[recordedIdOffset] = id;
    return packet;
}

QByteArray refusal(QByteArrayView datagram)
{
    const auto request = protocol::peekClientPacket(datagram);
    return protocol::encode(protocol::Reply {{request.framing.division, true, request.framing.id, protocol::lastBlock},
        protocol::replyService(request.service), refused, 1, notAccessible, {}});
}

} // namespace

Replay::Replay(const QList<Packet> &packets)
{
    std::map<quint16, QByteArray> open;
    for (const Packet &packet : packets) {
        if (!isDropped(packet.fate) && isFrame(packet.bytes))
            learn(packet, open);
    }
    m_times.clear();
}

/// Replies belong to the request that left with their id last; on the file port the blocks that follow belong to it
/// too.
void Replay::learn(const Packet &packet, std::map<quint16, QByteArray> &open)
{
    const quint16 id = recordedSlot(packet.division, packet.bytes);
    if (packet.passage == Passage::Sent) {
        m_times[id] = packet.at;
        if (packet.fate == Fate::Repeat || !beginsTransfer(packet.bytes))
            return;
        open[id] = keyOf(packet.division, packet.bytes);
        m_exchanges[open[id]].recorded.emplace_back();
        return;
    }
    const auto request = open.find(id);
    if (request == open.end())
        return;
    auto &answers = m_exchanges[request->second].recorded.back().answers;
    const bool isSecond = packet.division == Division::Robot && !answers.empty();
    const bool isAgain = !answers.empty() && answers.back().packet == packet.bytes;
    if (!isSecond && !isAgain)
        answers.push_back({packet.bytes, std::max(packet.at - m_times[id], WallTime::duration::zero())});
}

std::optional<Replay::Answer> Replay::answer(Division division, QByteArrayView datagram)
{
    if (!isFrame(datagram))
        return std::nullopt;
    if (division == Division::File && !beginsTransfer(datagram))
        return goOn(datagram);
    return begin(division, datagram);
}

std::optional<Replay::Answer> Replay::begin(Division division, QByteArrayView datagram)
{
    const auto found = m_exchanges.find(keyOf(division, datagram));
    if (found == m_exchanges.end())
        return Answer {refusal(datagram), {}};
    Exchanges &exchanges = found->second;
    const Recorded &recorded = exchanges.recorded[exchanges.next];
    exchanges.next = std::min(exchanges.next + 1, exchanges.recorded.size() - 1);
    if (recorded.answers.empty())
        return std::nullopt;
    if (division == Division::File)
        m_transfers[quint8(datagram[recordedIdOffset])] = {recorded, 1, datagram.toByteArray()};
    return Answer {withId(recorded.answers.front().packet, datagram[recordedIdOffset]), recorded.answers.front().delay};
}

/// A block of an upload, or the acknowledgement of one of a download: the next recorded block follows. A repeat of the
/// client's last packet gets the same block again.
std::optional<Replay::Answer> Replay::goOn(QByteArrayView datagram)
{
    const auto found = m_transfers.find(quint8(datagram[recordedIdOffset]));
    if (found == m_transfers.end())
        return std::nullopt;
    Transfer &transfer = found->second;
    const bool isAgain = transfer.lastAsked == datagram;
    const std::size_t index = isAgain ? transfer.next - 1 : transfer.next;
    if (index >= transfer.recorded.answers.size())
        return std::nullopt;
    transfer.next = index + 1;
    transfer.lastAsked = datagram.toByteArray();
    const Answer &answer = transfer.recorded.answers[index];
    return Answer {withId(answer.packet, datagram[recordedIdOffset]), answer.delay};
}

} // namespace traffic
