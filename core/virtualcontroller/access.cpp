// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "virtualcontroller/access.h"

#include <QtEndian>

using protocol::Request;
using values::Status;

namespace virtualcontroller
{

namespace
{

/// The added status that a condition refuses with, 0 if it is met.
using Condition = quint16 (*)(const Memory &);

quint16 remote(const Memory &m) { return m.status.isRemote() ? 0 : 0x2100; }
quint16 play(const Memory &m) { return m.status.isPlay() ? 0 : 0x2080; }
quint16 noAlarm(const Memory &m) { return m.status.hasAlarm() || m.status.hasError() ? 0x2060 : 0; }
quint16 safe(const Memory &m) { return m.interlocks.isSafetyChainClosed ? 0 : 0x3450; }
quint16 notEdited(const Memory &m) { return m.interlocks.isEditing ? 0x2130 : 0; }
quint16 filesFree(const Memory &m) { return m.interlocks.areFilesInUse ? 0x2090 : 0; }

constexpr quint16 any = 0xFFFF;

/// One row of reference §10.2. Rows are looked up from the top; a request without a row is always allowed.
struct Access {
    quint16 command;
    quint16 instance; ///< `any`: all of them.
    quint32 word; ///< The payload's word; `any`: all of them.
    QList<Condition> conditions; ///< In the order in which they refuse.
};

const std::vector<Access> &matrix()
{
    static const std::vector<Access> rows {
        {0x83, 1, 1, {}}, // HOLD on must always work
        {0x83, 1, any, {remote}},
        {0x83, 2, 1, {remote, play, noAlarm, safe}},
        {0x83, 2, any, {remote}},
        {0x83, 3, any, {remote, notEdited, filesFree}},
    };
    return rows;
}

bool concerns(const Access &row, const Request &request)
{
    const quint32 word = request.payload.size() >= 4 ? qFromLittleEndian<quint32>(request.payload.data()) : 0;
    return row.command == request.command && (row.instance == any || row.instance == request.instance)
        && (row.word == any || row.word == word);
}

} // namespace

quint16 accessRefusal(const Request &request, const Memory &memory)
{
    for (const Access &row : matrix()) {
        if (!concerns(row, request))
            continue;
        for (const Condition condition : row.conditions) {
            if (const quint16 code = condition(memory))
                return code;
        }
        return 0;
    }
    return 0;
}

} // namespace virtualcontroller
