// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "protocol/decoder.h"

#include "protocol/catalog.h"
#include "protocol/codes.h"
#include "protocol/fileblocks.h"
#include <algorithm>

using values::ErrorKind;
using values::Result;

namespace protocol {

namespace {

constexpr quint16 blockNumberFault = 0xE4A1;

quint16 keyOf(const Framing &framing) { return quint16(quint16(framing.division) << 8 | framing.id); }

bool isFile(const Framing &framing) { return framing.division == Division::File; }

QString explainCode(quint16 code) { return explain(values::Error {ErrorKind::Refused, 0x1F, code, {}}); }

Field hexField(const char *name, quint64 value, int digits)
{
    return {QString::fromLatin1(name), qint64(value), hexWord(value, digits)};
}

Fields framingFields(const Framing &framing)
{
    return {showNumber("division", int(framing.division)), showNumber("ack", framing.ack),
        showNumber("request_id", framing.id), hexField("block", framing.block, 8)};
}

Fields headerOf(const ClientPacket &packet)
{
    return framingFields(packet.framing)
        + Fields {hexField("command", packet.command, 3), showNumber("instance", packet.instance),
            showNumber("attribute", packet.attribute), hexField("service", quint8(packet.service), 2),
            showNumber("payload_size", packet.payload.size())};
}

Fields headerOf(const Reply &reply)
{
    return framingFields(reply.framing)
        + Fields {hexField("service", reply.service, 2), hexField("status", reply.status, 2),
            showNumber("added_status_size", reply.addedStatusSize), hexField("added_status", reply.addedStatus, 4),
            showNumber("payload_size", reply.payload.size())};
}

QString nameOf(const Request &request, Division division)
{
    if (division == Division::File) {
        const FileService *service = findFileService(request.service);
        return service ? QString::fromLatin1(service->name) : QString {};
    }
    const Command *command = findCommand(request.command);
    return command ? QString::fromLatin1(command->name) : QString {};
}

bool isPrintable(QByteArrayView bytes)
{
    return std::ranges::all_of(
        bytes, [](char byte) { return quint8(byte) >= 0x20 || byte == '\r' || byte == '\n' || byte == '\t'; });
}

/// A file's data: as text if it is one.
Fields dataFields(QByteArrayView payload, const TextCodec &codec)
{
    if (payload.isEmpty() || !isPrintable(payload))
        return {};
    return {{QStringLiteral("text"), codec.decode(payload), {}}};
}

/// The names in one block of a list; a name may be cut at either end.
Fields listFields(QByteArrayView payload, const TextCodec &codec)
{
    QStringList names;
    for (const QByteArray &line : payload.toByteArray().split('\n')) {
        const QByteArray name = line.endsWith('\r') ? line.chopped(1) : line;
        if (!name.isEmpty())
            names += codec.decode(name);
    }
    return {showWords("names", names)};
}

tl::unexpected<values::Error> unexpectedPayload(QByteArrayView payload)
{
    return values::failure(
        ErrorKind::Malformed, QStringLiteral("%1 bytes of payload where none belong").arg(payload.size()));
}

/// What a client sends to the file port: a name or a pattern, a data block, or an acknowledgement.
Result<Fields> fileClientFields(const ClientPacket &packet, const TextCodec &codec)
{
    if (packet.framing.ack && packet.service == Service::LoadFile)
        return dataFields(packet.payload, codec);
    if (packet.framing.ack)
        return packet.payload.isEmpty() ? Result<Fields> {} : unexpectedPayload(packet.payload);
    const auto name = packet.service == Service::ListFiles ? QStringLiteral("pattern") : QStringLiteral("file");
    return Fields {{name, codec.decode(packet.payload), {}}};
}

Result<Fields> fileReplyFields(const Reply &reply, const TextCodec &codec)
{
    if (reply.service == replyService(Service::ListFiles))
        return listFields(reply.payload, codec);
    if (reply.service == replyService(Service::SaveFile))
        return dataFields(reply.payload, codec);
    return reply.payload.isEmpty() ? Result<Fields> {} : unexpectedPayload(reply.payload);
}

DecodedPacket malformed(const QString &error)
{
    DecodedPacket decoded;
    decoded.error = error;
    return decoded;
}

/// Bytes that nobody can name are shown as they are.
void take(DecodedPacket &decoded, const Result<Fields> &fields, QByteArrayView payload)
{
    if (!fields)
        decoded.error = fields.error().detail;
    else if (fields->isEmpty() && !payload.isEmpty())
        decoded.payload = {{QStringLiteral("payload"), QString::fromLatin1(payload.toByteArray().toHex()), {}}};
    else
        decoded.payload = *fields;
}

} // namespace

QString toString(Direction direction)
{
    return direction == Direction::ToController ? QStringLiteral("client->controller")
                                                : QStringLiteral("controller->client");
}

bool Decoder::setRequest(QByteArrayView datagram)
{
    const auto packet = parseClientPacket(datagram);
    if (!packet || packet->framing.ack)
        return false;
    m_requests.insert(keyOf(packet->framing), packet->request());
    return true;
}

DecodedPacket Decoder::decode(QByteArrayView datagram)
{
    if (const auto fault = checkFrame(datagram); fault != FrameFault::None)
        return malformed(toString(fault));
    const ClientPacket packet = peekClientPacket(datagram);
    if (m_division && packet.framing.division != *m_division)
        return malformed(QStringLiteral("the division is not that of the port"));
    // A reply has its service where a client packet has the low byte of a command, which is 0 for files.
    const bool isReply = packet.framing.ack && (packet.command & 0x80);
    if (!isReply && packet.framing.ack && !isFile(packet.framing))
        return malformed(toString(FrameFault::Ack));
    return isReply ? decodeReply(datagram) : decodeClientPacket(datagram);
}

DecodedPacket Decoder::decodeClientPacket(QByteArrayView datagram)
{
    setRequest(datagram);
    const ClientPacket packet = peekClientPacket(datagram);
    DecodedPacket decoded;
    decoded.direction = Direction::ToController;
    decoded.header = headerOf(packet);
    decoded.name = nameOf(packet.request(), packet.framing.division);
    decoded.problem = problemOf(packet);
    take(decoded, clientPayload(packet), packet.payload);
    return decoded;
}

DecodedPacket Decoder::decodeReply(QByteArrayView datagram) const
{
    const Reply reply = *parseReply(datagram);
    const auto request = m_requests.constFind(keyOf(reply.framing));
    const bool isKnown = request != m_requests.constEnd();
    DecodedPacket decoded;
    decoded.direction = Direction::ToClient;
    decoded.header = headerOf(reply);
    if (isKnown && replyService(request->service) != reply.service) {
        decoded.error = QStringLiteral("the service is not that of the request");
        return decoded;
    }
    if (isKnown)
        decoded.name = nameOf(*request, reply.framing.division);
    if (reply.isRefusal())
        decoded.meaning = explain(reply.refusal());
    else
        take(decoded, replyPayload(reply, isKnown ? &*request : nullptr), reply.payload);
    return decoded;
}

Result<Fields> Decoder::clientPayload(const ClientPacket &packet) const
{
    return isFile(packet.framing) ? fileClientFields(packet, m_codec) : requestFields(packet.request(), m_codec);
}

Result<Fields> Decoder::replyPayload(const Reply &reply, const Request *request) const
{
    if (isFile(reply.framing))
        return fileReplyFields(reply, m_codec);
    return request ? replyFields(*request, reply.payload, m_codec) : Result<Fields> {};
}

QString Decoder::problemOf(const ClientPacket &packet) const
{
    if (isFile(packet.framing))
        return {};
    const quint16 code = packet.framing.block ? blockNumberFault : addressFault(packet.request(), *m_dialect);
    return code ? explainCode(code) : QString {};
}

} // namespace protocol
