// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "support/fuzz/target.h"

#include "protocol/catalog.h"
#include "protocol/decoder.h"
#include "protocol/requests.h"

using namespace protocol;
using namespace values;

namespace fuzz {

namespace {

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

template <typename Item> void survivesPluralRoundTrip(QByteArrayView payload, int count)
{
    if (const auto items = decodePlural<Item>(payload, quint32(count)))
        require(encodePlural(quint32(count), *items) == payload, "items encode to other bytes");
}

/// The second parameter is the element of a single-element service, or the count of a plural one.
using RoundTrip = void (*)(QByteArrayView payload, int);

template <typename... Values>
constexpr std::array<RoundTrip, sizeof...(Values)> roundTrips {survivesRoundTrip<Values>...};
template <typename... Items>
constexpr std::array<RoundTrip, sizeof...(Items)> pluralRoundTrips {survivesPluralRoundTrip<Items>...};

constexpr auto valueRoundTrips =
    roundTrips<Alarm, AlarmWithTexts, Status, ExecutingJob, AxisNames, Position, FollowingError, Torque, ManagementTime,
        SystemInformation, EncoderTemperatures, ConverterTemperature, IoGroup, Register, ByteVariable, IntegerVariable,
        DoubleVariable, RealVariable, StringVariable16, StringVariable32, PositionVariable, BasePosition,
        ExternalPosition, ControlWord, CycleSelection, PendantText, JobSelection, CartesianTarget, PulseTarget>;
constexpr auto itemRoundTrips = pluralRoundTrips<IoGroup, Register, ByteVariable, IntegerVariable, DoubleVariable,
    RealVariable, StringVariable16, StringVariable32, PositionVariable, BasePosition, ExternalPosition>;

/// What can be said of a request by its address and its size.
void judges(const Request &request, const Dialect &dialect)
{
    const Command *command = findCommand(request.command);
    const quint16 fault = addressFault(request, dialect);
    require(fault || command->hasInstance(request.instance, dialect), "an instance that is not there was let through");
    require(requestPayload(request.service) != PayloadKind::Empty || effectOf(request) == Effect::Reads,
        "a request without a payload does not just read");
}

void take(QByteArrayView data)
{
    static const TextCodec codec {Encoding::ShiftJis};
    Source source {data};
    const quint8 chosen = source.byte();
    const quint8 service = source.byte();
    const quint8 attribute = source.byte();
    const auto instance = quint16(source.byte() | source.byte() << 8);
    const quint8 trial = source.byte();
    const auto bytes = source.rest();
    const Command &command = commands()[chosen % commands().size()];
    const Request request {
        command.number, instance, attribute, command.services[service % command.services.size()], bytes.toByteArray()};
    switch (trial % 5) {
    case 0: (void)requestFields(request, codec); break;
    case 1: (void)replyFields(request, bytes, codec); break;
    case 2: judges(request, dialect(allModels[service % allModels.size()])); break;
    case 3: valueRoundTrips[chosen % valueRoundTrips.size()](bytes, attribute % 16); break;
    default: itemRoundTrips[chosen % itemRoundTrips.size()](bytes, attribute);
    }
}

/// Payloads and what is left of their headers, to choose with.
Seeds seeds()
{
    Seeds payloads = goldenPackets();
    for (QByteArray &packet : payloads)
        packet.remove(0, headerSize - 6);
    return payloads;
}

} // namespace

extern const Target payload;
const Target payload {"payload", take, seeds, 520};

} // namespace fuzz
