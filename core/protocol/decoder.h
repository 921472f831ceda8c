// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "protocol/dialect.h"
#include "protocol/fields.h"
#include "protocol/packet.h"
#include <QHash>
#include <optional>

namespace protocol {

enum class Direction { ToController, ToClient };
/// "client->controller", "controller->client".
[[nodiscard]] QString toString(Direction direction);

/// A datagram in names and words.
struct DecodedPacket {
    std::optional<Direction> direction; ///< Empty if the datagram is no packet.
    Fields header; ///< As on the wire, in the order of the reference.
    Fields payload; ///< By the layout of the command; empty for a reply whose request is not known.
    QString name; ///< What the packet is about: "status"; empty where nobody can know.
    QString error; ///< Why the datagram is no packet, or its payload not one of its command; empty if it is fine.
    QString problem; ///< What a controller would object to in this request; empty if nothing.
    QString meaning; ///< A refusal in words, with its remedy.

    [[nodiscard]] bool isMalformed() const { return !error.isEmpty(); }
};

/// Takes datagrams of both directions apart. It remembers the requests it saw, by their id, to know what a reply holds.
class Decoder
{
public:
    explicit Decoder(TextCodec codec = TextCodec {}, Model model = Model::YRC1000)
        : m_codec {codec}, m_dialect {&dialect(model)}
    {
    }

    /// Packets come from this port: a packet of the other division is malformed. Any division without it.
    void setDivision(Division division) { m_division = division; }
    /// Packets that follow may answer the request in `datagram`; false if it holds none.
    bool setRequest(QByteArrayView datagram);

    [[nodiscard]] DecodedPacket decode(QByteArrayView datagram);

private:
    [[nodiscard]] DecodedPacket decodeClientPacket(QByteArrayView datagram);
    [[nodiscard]] DecodedPacket decodeReply(QByteArrayView datagram) const;
    [[nodiscard]] values::Result<Fields> clientPayload(const ClientPacket &packet) const;
    [[nodiscard]] values::Result<Fields> replyPayload(const Reply &reply, const Request *request) const;
    [[nodiscard]] QString problemOf(const ClientPacket &packet) const;

    TextCodec m_codec;
    const Dialect *m_dialect;
    std::optional<Division> m_division;
    QHash<quint16, Request> m_requests; ///< By division and id.
};

} // namespace protocol
