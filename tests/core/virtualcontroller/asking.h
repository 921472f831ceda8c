// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "protocol/payloads.h"
#include "protocol/requests.h"
#include "virtualcontroller/machine.h"
#include "virtualcontroller/responder.h"

/// What a virtual controller answered to one request, without any socket.
struct Answered {
    QByteArray bytes; ///< Empty: nothing.
    quint8 status = 0xFF;
    quint16 code = 0;
    QByteArray payload;
};

inline Answered answered(const std::optional<QByteArray> &bytes)
{
    if (!bytes)
        return {};
    const auto reply = protocol::parseReply(*bytes);
    Q_ASSERT(reply);
    return {*bytes, reply->status, reply->addedStatus, reply->payload.toByteArray()};
}

inline Answered ask(virtualcontroller::Memory &memory, const protocol::Request &request,
    virtualcontroller::Time now = virtualcontroller::Time {})
{
    const auto datagram = protocol::encode(request, {protocol::Division::Robot, false, 1, 0});
    return answered(virtualcontroller::respond(datagram, memory, std::max(now, memory.now)));
}

inline QByteArray word(quint32 value)
{
    QByteArray payload(4, '\0');
    qToLittleEndian(value, payload.data());
    return payload;
}

inline protocol::Request order(quint16 command, quint16 instance, quint32 value)
{
    return {command, instance, 1, protocol::Service::SetSingle, word(value)};
}

inline protocol::Request selectJob(const char *name, quint32 line = 0, quint16 instance = 1)
{
    const values::JobSelection selection {values::JobName {name}, line};
    return {0x87, instance, 0, protocol::Service::SetAll, protocol::encode(selection)};
}

inline values::CartesianTarget cartesian(qint32 x, qint32 y, qint32 z, quint32 speed = 1000)
{
    values::CartesianTarget target;
    target.speed = {values::SpeedClass::ToolPoint, speed};
    target.xyz = {x, y, z};
    target.rotation = {1'800'000, 0, 0, 0};
    return target;
}

inline protocol::Request moveTo(const values::CartesianTarget &target, quint16 instance = 2)
{
    return {0x8A, instance, 1, protocol::Service::SetAll, protocol::encode(target)};
}

inline protocol::Request moveTo(const values::PulseTarget &target, quint16 instance = 1)
{
    return {0x8B, instance, 1, protocol::Service::SetAll, protocol::encode(target)};
}

/// A controller that would start and move: remote, play, servo power on.
inline virtualcontroller::Memory ready()
{
    virtualcontroller::Memory memory;
    memory.status.data2.setFlag(values::Status::ServoOn);
    return memory;
}
