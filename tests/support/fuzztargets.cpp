// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "support/fuzztargets.h"

#include "protocol/catalog.h"
#include "protocol/decoder.h"
#include "protocol/fileblocks.h"
#include "protocol/requests.h"

using namespace protocol;

namespace fuzz {

namespace {

void require(bool holds, const char *what)
{
    if (!holds)
        qFatal("%s", what);
}

/// Takes bytes off the front; 0 when there are none left.
class Source
{
public:
    explicit Source(QByteArrayView data) : m_rest {data} { }

    quint8 byte()
    {
        const auto taken = take(1);
        return taken.isEmpty() ? quint8(0) : quint8(taken.front());
    }
    QByteArrayView take(qsizetype size)
    {
        const auto taken = m_rest.first(std::min(size, m_rest.size()));
        m_rest = m_rest.sliced(taken.size());
        return taken;
    }
    [[nodiscard]] QByteArrayView rest() const { return m_rest; }

private:
    QByteArrayView m_rest;
};

/// What was read encodes to the bytes that it was read from, as far as both go: some payloads may be short or long.
template <typename Value> void survivesRoundTrip(QByteArrayView payload, int element)
{
    const auto value = decode<Value>(payload, element);
    if (!value)
        return;
    const QByteArray encoded = encode(*value, element);
    const qsizetype common = std::min(encoded.size(), payload.size());
    require(payload.first(common) == QByteArrayView {encoded}.first(common), "a value encodes to other bytes");
}

template <typename... Values> void surviveRoundTrips(QByteArrayView payload, int element)
{
    (survivesRoundTrip<Values>(payload, element), ...);
}

template <typename Item> void survivesPluralRoundTrip(QByteArrayView payload, quint32 count)
{
    if (const auto items = decodePlural<Item>(payload, count))
        require(encodePlural(count, *items) == payload, "items encode to other bytes");
}

} // namespace

void packet(QByteArrayView data)
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

void payload(QByteArrayView data)
{
    Source source {data};
    const auto rows = commands();
    const Command &command = rows[source.byte() % rows.size()];
    const Service service = command.services[source.byte() % command.services.size()];
    const quint8 attribute = source.byte();
    const auto bytes = source.rest();
    const Request request {command.number, 1, attribute, service, bytes.toByteArray()};
    const TextCodec codec {Encoding::ShiftJis};
    (void)requestFields(request, codec);
    (void)replyFields(request, bytes, codec);
    (void)effectOf(request);
    for (const Model model : allModels)
        (void)addressFault(request, dialect(model));
    using namespace values;
    const int element = attribute % 16;
    surviveRoundTrips<Alarm, AlarmWithTexts, Status, ExecutingJob, AxisNames, Position, FollowingError, Torque,
        ManagementTime, SystemInformation, EncoderTemperatures, ConverterTemperature>(bytes, element);
    surviveRoundTrips<IoGroup, Register, ByteVariable, IntegerVariable, DoubleVariable, RealVariable, StringVariable16,
        StringVariable32, PositionVariable, BasePosition, ExternalPosition>(bytes, element);
    surviveRoundTrips<ControlWord, CycleSelection, PendantText, JobSelection, CartesianTarget, PulseTarget>(
        bytes, element);
    survivesPluralRoundTrip<Register>(bytes, attribute);
    survivesPluralRoundTrip<StringVariable16>(bytes, attribute);
    survivesPluralRoundTrip<PositionVariable>(bytes, attribute);
}

void fileBlocks(QByteArrayView data)
{
    Source source {data};
    BlockCollector collector;
    QByteArray taken;
    while (!source.rest().isEmpty()) {
        const quint32 last = source.byte() & 1 ? lastBlock : 0;
        const quint32 number = source.byte() % 8;
        const auto content = source.take(source.byte());
        const auto step = collector.take(
            {{Division::File, true, 1, number | last}, replyService(Service::ListFiles), 0, 0, 0, content});
        if (step && *step != BlockCollector::Step::Repeated)
            taken += content;
    }
    require(collector.content() == taken, "blocks were lost");
    const FileList list = parseFileList(data.toByteArray());
    for (const auto &name : list.names) {
        const auto again = values::FileName::create(name.bytes());
        require(again && *again == name && !name.bytes().contains('/'), "a listed name is none");
        require(!encodeFileRequest(saveFile(name), 1).isEmpty(), "a name cannot be asked for");
    }
    QByteArray joined;
    for (quint32 index = 1; index <= blockCount(data); ++index)
        joined += encodeLoadBlock(data, index, 1).sliced(headerSize);
    require(joined == data, "a load changed its content");
}

void text(QByteArrayView data)
{
    Source source {data};
    const auto all = encodings();
    const TextCodec codec {all[source.byte() % all.size()].encoding};
    const qsizetype size = source.byte();
    const auto bytes = source.rest();
    const QString decoded = codec.decode(bytes);
    require(decoded.isEmpty() == bytes.isEmpty(), "a text was dropped");
    const auto fitted = codec.fit(bytes, size);
    require(fitted.size() <= size && bytes.startsWith(fitted), "fit() is no start of the text");
    require(decoded.startsWith(codec.decode(fitted)), "fit() cut a character");
    if (const auto encoded = codec.encode(decoded))
        require(*codec.byteCount(decoded) == encoded->size(), "the byte counter is wrong");
    (void)codec.encode(QString::fromUtf8(bytes));
}

} // namespace fuzz
