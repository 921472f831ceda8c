// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "traffic/packet.h"
#include <map>
#include <optional>
#include <vector>

namespace traffic {

/// Answers as a controller did while it was recorded: the same request gets the recorded replies, one after the other,
/// the last one again and again. A request that was never answered in the recording is not answered; one that was never
/// asked is refused as data that may not be accessed (0x2110, reference §9).
class Replay
{
public:
    struct Answer {
        QByteArray packet;
        std::chrono::microseconds delay; ///< Between request and reply, as recorded.
    };

    /// `packets` as in PacketLog or Capture; what was dropped is left out.
    explicit Replay(const QList<Packet> &packets);

    /// The answer to a datagram that came to the port of this division; nullopt if there is none.
    [[nodiscard]] std::optional<Answer> answer(protocol::Division division, QByteArrayView datagram);
    /// How many different requests of either port were recorded with an answer.
    [[nodiscard]] std::size_t size() const { return m_exchanges.size(); }

private:
    /// One recorded conversation: a single reply, or the blocks of a transfer in their order.
    struct Recorded {
        std::vector<Answer> answers;
    };
    struct Exchanges {
        std::vector<Recorded> recorded;
        std::size_t next = 0;
    };
    /// A transfer under way: which recorded one, and how far.
    struct Transfer {
        Recorded recorded;
        std::size_t next = 0;
        QByteArray lastAsked {}; ///< Of the client, to answer a repeat with the same block.
    };

    void learn(const Packet &packet, std::map<quint16, QByteArray> &open);
    [[nodiscard]] std::optional<Answer> begin(protocol::Division division, QByteArrayView datagram);
    [[nodiscard]] std::optional<Answer> goOn(QByteArrayView datagram);

    std::map<QByteArray, Exchanges> m_exchanges; ///< By division and request, without the id.
    std::map<quint8, Transfer> m_transfers; ///< By id.
    std::map<quint64, WallTime> m_times; ///< Of packets sent, while learning.
};

} // namespace traffic
