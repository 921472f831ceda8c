// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "protocol/dialect.h"
#include "protocol/effect.h"
#include "protocol/fields.h"
#include "protocol/packet.h"
#include <QList>
#include <span>

namespace protocol {

/// Which attribute goes with the services that take all elements (reference §1.3, §4.3, §6).
enum class AllAttribute { Zero, One, ZeroOrOne };

/// What stands in a payload.
enum class PayloadKind { Empty, Value, Count, CountAndValues };

/// What stands in a request with this service, and in a good reply to it.
[[nodiscard]] PayloadKind requestPayload(Service service);
[[nodiscard]] PayloadKind replyPayload(Service service);

/// A command of the robot port, described once (reference §2 to §6). The session's policy, the virtual controller, the
/// decoder, the console and the coverage test all read these rows; a new command is one more row.
struct Command {
    quint16 number;
    const char *name; ///< Plain English, lower case, as in logs and `decode`.
    QList<Service> services; ///< The services that the command answers.
    int elements; ///< Attributes 1 to `elements`; 0 in a plural command.
    qsizetype size; ///< Bytes of all elements with every axis; in a plural command, of one item.
    QList<InstanceRange> (*instances)(const Dialect &); ///< Empty where the model does not have the command.
    Effect (*effect)(const Request &); ///< What a request of this command does.
    /// The named fields of a payload that holds a value, of `request` or of its reply; Malformed if it does not fit.
    values::Result<Fields> (*fields)(QByteArrayView payload, const Request &request, const TextCodec &codec);
    AllAttribute allAttribute = AllAttribute::Zero;
    /// Where writing is possible; nullptr means everywhere.
    QList<InstanceRange> (*writable)(const Dialect &) = nullptr;

    [[nodiscard]] bool hasService(Service service) const { return services.contains(service); }
    [[nodiscard]] bool hasInstance(quint32 instance, const Dialect &dialect) const;
    [[nodiscard]] bool hasAttribute(Service service, quint8 attribute) const;
    [[nodiscard]] bool isPlural() const { return elements == 0; }
    [[nodiscard]] bool isWritable(quint32 instance, const Dialect &dialect) const;
};

/// All commands, by number.
[[nodiscard]] std::span<const Command> commands();
/// The row of a command number; nullptr if there is none.
[[nodiscard]] const Command *findCommand(quint16 number);
/// What `request` does; a request that no row knows is taken for a write, so that it is never repeated.
[[nodiscard]] Effect effectOf(const Request &request);

/// The added status that a controller of this kind refuses `request` with for its address or its size: 0xA000, 0xA001,
/// 0xA002, 0xB003, in the order of reference §1.7; 0 if nothing is wrong with them.
[[nodiscard]] quint16 addressFault(const Request &request, const Dialect &dialect);

/// The named fields of a request's payload, and of a good reply's. Malformed if the payload does not fit the request.
[[nodiscard]] values::Result<Fields> requestFields(const Request &request, const TextCodec &codec);
[[nodiscard]] values::Result<Fields> replyFields(
    const Request &request, QByteArrayView payload, const TextCodec &codec);

} // namespace protocol
