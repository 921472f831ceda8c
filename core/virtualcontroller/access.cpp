// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "virtualcontroller/access.h"

#include "protocol/catalog.h"
#include "protocol/payloads.h"
#include "virtualcontroller/cells.h"
#include <algorithm>

using protocol::Request;
using values::Status;

namespace virtualcontroller {

namespace {

/// The added status that a condition refuses with, 0 if it is met.
using Condition = quint16 (*)(const Memory &, const Request &);

quint16 remote(const Memory &m, const Request &) { return m.status.isRemote() ? 0 : 0x2100; }
quint16 fileRemote(const Memory &m, const Request &) { return m.status.isRemote() ? 0 : 0xE2B2; }
quint16 play(const Memory &m, const Request &) { return m.status.isPlay() ? 0 : 0x2080; }
quint16 noAlarm(const Memory &m, const Request &) { return m.status.hasAlarm() || m.status.hasError() ? 0x2060 : 0; }
quint16 safe(const Memory &m, const Request &) { return m.interlocks.isSafetyChainClosed ? 0 : 0x3450; }
quint16 dataFree(const Memory &m, const Request &) { return m.interlocks.isDataLocked ? 0x2110 : 0; }
quint16 notEdited(const Memory &m, const Request &) { return m.interlocks.isEditing ? 0x2130 : 0; }
quint16 filesFree(const Memory &m, const Request &) { return m.interlocks.areFilesInUse ? 0x2090 : 0; }
quint16 panelFree(const Memory &m, const Request &) { return m.interlocks.isPanelLocked ? 0x3220 : 0; }
quint16 servoOn(const Memory &m, const Request &) { return m.status.isServoOn() ? 0 : 0x2070; }
quint16 notRunning(const Memory &m, const Request &) { return m.status.isRunning() ? 0x2010 : 0; }
quint16 homeConfirmed(const Memory &m, const Request &) { return m.interlocks.isHomeConfirmed ? 0 : 0x3040; }
quint16 startFree(const Memory &m, const Request &) { return m.interlocks.isStartLocked ? 0x3230 : 0; }
quint16 selectPermitted(const Memory &m, const Request &) { return m.interlocks.isJobSelectPermitted ? 0 : 0x2080; }
quint16 masterPermitted(const Memory &m, const Request &) { return m.interlocks.isMasterCallPermitted ? 0 : 0x3400; }
quint16 masterIdle(const Memory &m, const Request &) { return m.interlocks.isMasterCalled ? 0x3410 : 0; }
quint16 notTeachLocked(const Memory &m, const Request &) { return m.interlocks.isTeachLocked ? 0x3420 : 0; }

quint16 notHeld(const Memory &m, const Request &)
{
    if (m.status.data2 & Status::HeldByPendant)
        return 0x2020;
    if (m.status.data2 & Status::HeldExternally)
        return 0x2040;
    return m.status.data2 & Status::HeldByCommand ? 0x2050 : 0;
}

quint16 jobSet(const Memory &m, const Request &) { return m.tasks.front().stack.empty() ? 0x4060 : 0; }

quint16 jobExists(const Memory &m, const Request &request)
{
    const auto selection = protocol::decode<values::JobSelection>(request.payload);
    return selection && m.program(selection->job.bytes().toByteArray()) ? 0 : 0x4040;
}

constexpr quint32 any = 0xFFFF'FFFF;
constexpr quint16 lastInstance = 0xFFFF;
constexpr protocol::InstanceRange all {0, lastInstance};

/// One row of reference §10.2: what must be the case for the requests it names. Rows are looked up from the top, and a
/// request without a row is always allowed; reads have none.
struct Access {
    quint16 command;
    protocol::InstanceRange instances;
    quint32 word; ///< The word the payload begins with; `any`: all of them.
    QList<Condition> conditions; ///< In the order in which they refuse.
};

std::vector<Access> matrixRows()
{
    const QList<Condition> toMove {remote, play, noAlarm, notHeld, servoOn, notRunning, homeConfirmed, startFree};
    std::vector<Access> rows {
        {0x82, all, any, {remote}},
        {0x83, {1, 1}, 1, {}}, // HOLD on must always work
        {0x83, {1, 1}, any, {remote}},
        {0x83, {2, 2}, 1, {remote, play, noAlarm, safe}},
        {0x83, {2, 2}, any, {remote}},
        {0x83, {3, 3}, any, {remote, notEdited, filesFree}},
        {0x84, all, any, {remote, panelFree}},
        {0x85, all, any, {remote}},
        {0x86, all, any, {remote, play, noAlarm, notHeld, servoOn, notRunning, jobSet, homeConfirmed, startFree}},
        {0x87, {1, 1}, any, {remote, selectPermitted, notRunning, notEdited, jobExists}},
        {0x87, {10, lastInstance}, any,
            {remote, notRunning, notEdited, jobExists, masterPermitted, masterIdle, notTeachLocked}},
        {0x8A, all, any, toMove},
        {0x8B, all, any, toMove},
    };
    for (const CellKind &kind : cellKinds()) {
        for (const quint16 command : {kind.single, kind.plural})
            rows.push_back({command, all, any, {dataFree, notEdited}});
    }
    return rows;
}

const std::vector<Access> &matrix()
{
    static const std::vector<Access> rows = matrixRows();
    return rows;
}

bool concerns(const Access &row, const Request &request)
{
    const quint32 word = request.payload.size() >= 4 ? qFromLittleEndian<quint32>(request.payload.data()) : 0;
    return row.command == request.command && row.instances.contains(request.instance)
        && (row.word == any || row.word == word);
}

quint16 firstRefusal(const QList<Condition> &conditions, const Memory &memory, const Request &request)
{
    for (const Condition condition : conditions) {
        if (const quint16 code = condition(memory, request))
            return code;
    }
    return 0;
}

} // namespace

quint16 accessRefusal(const Request &request, const Memory &memory)
{
    if (protocol::effectOf(request) == protocol::Effect::Reads)
        return 0;
    const auto row = std::ranges::find_if(matrix(), [&](const Access &access) { return concerns(access, request); });
    return row == matrix().end() ? 0 : firstRefusal(row->conditions, memory, request);
}

quint16 fileAccessRefusal(protocol::Service service, const Memory &memory)
{
    static const QList<Condition> always;
    static const QList<Condition> remotely {fileRemote, notEdited, filesFree};
    return firstRefusal(service == protocol::Service::ListFiles ? always : remotely, memory, {});
}

} // namespace virtualcontroller
