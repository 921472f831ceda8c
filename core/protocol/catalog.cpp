// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "protocol/catalog.h"

#include <QtEndian>
#include <algorithm>

namespace protocol {

namespace {

using enum Service;
using Ranges = QList<InstanceRange>;

InstanceRange numbered(int base, int count) { return {quint16(base + 1), quint16(base + count)}; }

Ranges onlyFirst(const Dialect &) { return {{1, 1}}; }
Ranges tasks(const Dialect &d) { return {numbered(0, d.tasks)}; }
Ranges axisNameGroups(const Dialect &d)
{
    return {numbered(0, d.robots), numbered(10, d.bases), numbered(20, d.stations), numbered(100, d.robots),
        numbered(110, d.bases)};
}
Ranges positionGroups(const Dialect &d)
{
    return {numbered(0, d.robots), numbered(10, d.bases), numbered(20, d.stations), numbered(100, d.robots)};
}
Ranges systemParts(const Dialect &d)
{
    return {numbered(10, d.robots), numbered(20, d.stations), numbered(100, d.applications)};
}
Ranges powerSwitches(const Dialect &) { return {{1, 3}}; }

Effect reads(const Request &) { return Effect::Reads; }

/// 0x83: HOLD on and servo off stop, servo on makes motion possible, the rest changes a setting (reference §6).
Effect powerSwitchEffect(const Request &request)
{
    constexpr quint16 hold = 1;
    constexpr quint16 servo = 2;
    constexpr quint32 on = 1;
    constexpr quint32 off = 2;
    const quint32 word = request.payload.size() >= 4 ? qFromLittleEndian<quint32>(request.payload.data()) : 0;
    if (request.instance == hold)
        return word == on ? Effect::Stops : Effect::Writes;
    if (request.instance == servo && word == on)
        return Effect::Starts;
    if (request.instance == servo && word == off)
        return Effect::Stops;
    return Effect::Writes;
}

const std::vector<Command> &rows()
{
    static const QList<Service> get {GetSingle, GetAll};
    static const QList<Service> execute {SetSingle};
    static const std::vector<Command> rows {
        {0x72, "status", get, 2, onlyFirst, reads},
        {0x73, "executing job", get, 4, tasks, reads},
        {0x74, "axis names", get, 8, axisNameGroups, reads},
        {0x75, "position", get, 13, positionGroups, reads},
        {0x83, "hold, servo, hlock", execute, 1, powerSwitches, powerSwitchEffect},
        {0x89, "system information", get, 3, systemParts, reads},
    };
    return rows;
}

} // namespace

bool Command::hasInstance(quint32 instance, const Dialect &dialect) const
{
    return std::ranges::any_of(
        instances(dialect), [instance](InstanceRange range) { return range.contains(instance); });
}

std::span<const Command> commands() { return rows(); }

const Command *findCommand(quint16 number)
{
    const auto found = std::ranges::find(rows(), number, &Command::number);
    return found == rows().end() ? nullptr : &*found;
}

Effect effectOf(const Request &request)
{
    const Command *command = findCommand(request.command);
    return command ? command->effect(request) : Effect::Writes;
}

} // namespace protocol
