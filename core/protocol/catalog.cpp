// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "protocol/catalog.h"

#include "protocol/plural.h"
#include <QtEndian>
#include <algorithm>

using values::Result;

namespace protocol {

namespace {

constexpr quint16 unknownCommand = 0xA000;
constexpr quint16 instanceError = 0xA001;
constexpr quint16 attributeError = 0xA002;
constexpr quint16 sizeError = 0xB003;

bool isIn(const QList<InstanceRange> &ranges, quint32 instance)
{
    return std::ranges::any_of(ranges, [instance](InstanceRange range) { return range.contains(instance); });
}

tl::unexpected<values::Error> misfit(QByteArrayView payload, const char *what)
{
    return values::failure(values::ErrorKind::Malformed,
        QStringLiteral("%1 bytes of payload: %2").arg(payload.size()).arg(QLatin1StringView(what)));
}

/// The number of items in a plural payload; Malformed if the rule does not allow it.
Result<Fields> countField(const Command &command, QByteArrayView payload)
{
    if (payload.size() < PluralRule::countSize)
        return misfit(payload, "the count is missing");
    const auto count = qFromLittleEndian<quint32>(payload.data());
    if (!PluralRule {command.size}.allows(count))
        return misfit(payload, "the count is 0, odd or too large for this command");
    return Fields {showNumber("count", count)};
}

Result<Fields> fieldsOf(
    const Command &command, PayloadKind kind, QByteArrayView payload, const Request &request, const TextCodec &codec)
{
    switch (kind) {
    case PayloadKind::Empty: return payload.isEmpty() ? Result<Fields> {} : misfit(payload, "none belong here");
    case PayloadKind::Value: return command.fields(payload, request, codec);
    case PayloadKind::Count:
        return payload.size() == PluralRule::countSize ? countField(command, payload)
                                                       : misfit(payload, "only a count belongs here");
    case PayloadKind::CountAndValues: break;
    }
    auto fields = countField(command, payload);
    if (!fields)
        return fields;
    auto items = command.fields(payload.sliced(PluralRule::countSize), request, codec);
    if (!items)
        return items;
    if (qint64(PluralRule::countSize) + fields->first().value.toInteger() * command.size != payload.size())
        return misfit(payload, "the count and the items differ");
    return *fields + *items;
}

} // namespace

PayloadKind requestPayload(Service service)
{
    switch (service) {
    case Service::SetSingle:
    case Service::SetAll: return PayloadKind::Value;
    case Service::ReadPlural: return PayloadKind::Count;
    case Service::WritePlural: return PayloadKind::CountAndValues;
    default: return PayloadKind::Empty;
    }
}

PayloadKind replyPayload(Service service)
{
    switch (service) {
    case Service::GetSingle:
    case Service::GetAll: return PayloadKind::Value;
    case Service::ReadPlural: return PayloadKind::CountAndValues;
    case Service::WritePlural: return PayloadKind::Count;
    default: return PayloadKind::Empty;
    }
}

bool Command::hasInstance(quint32 instance, const Dialect &dialect) const { return isIn(instances(dialect), instance); }

bool Command::isWritable(quint32 instance, const Dialect &dialect) const
{
    return isIn(writable ? writable(dialect) : instances(dialect), instance);
}

bool Command::hasAttribute(Service service, quint8 attribute) const
{
    // I/O groups, registers and variables of one element: attribute 0 means it as well (reference §0.1 b).
    const bool isCell = elements == 1 && hasService(Service::GetSingle);
    switch (service) {
    case Service::GetSingle:
    case Service::SetSingle: return attribute <= elements && (attribute > 0 || isCell);
    case Service::GetAll:
    case Service::SetAll:
        return (attribute == 0 && allAttribute != AllAttribute::One)
            || (attribute == 1 && allAttribute != AllAttribute::Zero);
    default: return attribute == 0;
    }
}

const Command *findCommand(quint16 number)
{
    const auto rows = commands();
    const auto found = std::ranges::lower_bound(rows, number, {}, &Command::number);
    return found != rows.end() && found->number == number ? &*found : nullptr;
}

Effect effectOf(const Request &request)
{
    const Command *command = findCommand(request.command);
    return command ? command->effect(request) : Effect::Writes;
}

quint16 addressFault(const Request &request, const Dialect &dialect)
{
    const Command *command = findCommand(request.command);
    if (!command || command->instances(dialect).isEmpty())
        return unknownCommand;
    if (!command->hasInstance(request.instance, dialect))
        return instanceError;
    if (!command->hasService(request.service) || !command->hasAttribute(request.service, request.attribute))
        return attributeError;
    return requestFields(request, TextCodec {}) ? 0 : sizeError;
}

Result<Fields> requestFields(const Request &request, const TextCodec &codec)
{
    const Command *command = findCommand(request.command);
    return command ? fieldsOf(*command, requestPayload(request.service), request.payload, request, codec)
                   : Result<Fields> {};
}

Result<Fields> replyFields(const Request &request, QByteArrayView payload, const TextCodec &codec)
{
    const Command *command = findCommand(request.command);
    if (!command)
        return Fields {};
    if (request.service == Service::WritePlural && payload.isEmpty())
        return Fields {}; // reference §12, conflict 46
    return fieldsOf(*command, replyPayload(request.service), payload, request, codec);
}

} // namespace protocol
