// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "protocol/dialect.h"
#include "protocol/effect.h"
#include "protocol/packet.h"
#include <QList>
#include <span>

namespace protocol {

/// A command of the robot port, described once (reference §2 to §6). The session's policy, the virtual controller, the
/// decoder, the console and the coverage test all read these rows; a new command is one more row.
struct Command {
    quint16 number;
    const char *name; ///< Plain English, lower case, as in logs and `decode`.
    QList<Service> services; ///< The services that the command answers.
    int elements; ///< Attributes 1 to `elements`; 0 in a plural command.
    QList<InstanceRange> (*instances)(const Dialect &); ///< Empty where the model does not have the command.
    Effect (*effect)(const Request &); ///< What a request of this command does.

    [[nodiscard]] bool hasService(Service service) const { return services.contains(service); }
    [[nodiscard]] bool hasInstance(quint32 instance, const Dialect &dialect) const;
    [[nodiscard]] bool isPlural() const { return elements == 0; }
};

/// All commands, by number.
[[nodiscard]] std::span<const Command> commands();
/// The row of a command number; nullptr if there is none.
[[nodiscard]] const Command *findCommand(quint16 number);
/// What `request` does; a request that no row knows is taken for a write, so that it is never repeated.
[[nodiscard]] Effect effectOf(const Request &request);

} // namespace protocol
