// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "support/fuzz/target.h"

#include "protocol/decoder.h"

using namespace protocol;

namespace fuzz {

namespace {

void take(QByteArrayView data)
{
    const auto client = parseClientPacket(data);
    const auto reply = parseReply(data);
    require(client.has_value() == (checkFrame(data) == FrameFault::None), "a faulty frame was parsed");
    if (client) {
        const QByteArray encoded = encode(client->request(), client->framing);
        const auto again = parseClientPacket(encoded);
        require(again && again->request() == client->request() && again->framing == client->framing,
            "a request changed on the way");
    }
    if (reply) {
        const QByteArray encoded = encode(*reply);
        const auto again = parseReply(encoded);
        require(again && again->framing == reply->framing && again->addedStatus == reply->addedStatus
                && again->payload == reply->payload,
            "a reply changed on the way");
    }
    Decoder decoder;
    const DecodedPacket decoded = decoder.decode(data);
    require(client.has_value() || decoded.isMalformed(), "a faulty frame was decoded");
}

Seeds seeds() { return goldenPackets(); }

} // namespace

extern const Target packet;
const Target packet {"packet", take, seeds, 520};

} // namespace fuzz
