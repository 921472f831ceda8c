// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "protocol/effect.h"
#include "protocol/packet.h"
#include "protocol/payloads.h"

namespace protocol {

/// A typed order to the robot port: it knows its bytes, its effect and the value that answers it.
template <typename R>
concept TypedRequest = requires(const R &request, QByteArrayView payload)
{
    typename R::Reply;
    {
        R::effect
        } -> std::convertible_to<Effect>;
    {
        request.request()
        } -> std::same_as<Request>;
    {
        request.decode(payload)
        } -> std::same_as<values::Result<typename R::Reply>>;
};

/// Reads every element of a payload.
template <quint16 command, typename Value> struct ReadAll {
    using Reply = Value;
    static constexpr auto effect = Effect::Reads;
    quint16 instance = 1;

    [[nodiscard]] Request request() const { return {command, instance, 0, Service::GetAll}; }
    [[nodiscard]] values::Result<Value> decode(QByteArrayView payload) const
    {
        return protocol::decode<Value>(payload);
    }
};

/// Executes a single-word control command (reference §6).
template <quint16 command, quint16 instance, quint32 word, Effect kind> struct Control {
    using Reply = void;
    static constexpr auto effect = kind;

    [[nodiscard]] Request request() const
    {
        QByteArray payload(4, '\0');
        qToLittleEndian(word, payload.data());
        return {command, instance, 1, Service::SetSingle, payload};
    }
    [[nodiscard]] values::Result<void> decode(QByteArrayView) const { return {}; }
};

struct ReadStatus : ReadAll<0x72, values::Status> {
};

struct ReadExecutingJob : ReadAll<0x73, values::ExecutingJob> {
    /// `task` 0 is the master task, 1.. the sub tasks.
    explicit ReadExecutingJob(int task = 0) { instance = quint16(1 + task); }
};

struct ReadAxisNames : ReadAll<0x74, values::AxisNames> {
    explicit ReadAxisNames(values::ControlGroup group) { instance = group.instance; }
};

struct ReadPosition : ReadAll<0x75, values::Position> {
    explicit ReadPosition(values::ControlGroup group) { instance = group.instance; }
};

struct ReadSystemInformation : ReadAll<0x89, values::SystemInformation> {
    static ReadSystemInformation robot(int robot) { return {{quint16(10 + robot)}}; }
    static ReadSystemInformation station(int station) { return {{quint16(20 + station)}}; }
    static ReadSystemInformation application(int application) { return {{quint16(100 + application)}}; }
};

struct HoldOn : Control<0x83, 1, 1, Effect::Stops> {
};
struct HoldOff : Control<0x83, 1, 2, Effect::Writes> {
};
struct ServoOn : Control<0x83, 2, 1, Effect::Starts> {
};
struct ServoOff : Control<0x83, 2, 2, Effect::Stops> {
};
struct HlockOn : Control<0x83, 3, 1, Effect::Writes> {
};
struct HlockOff : Control<0x83, 3, 2, Effect::Writes> {
};

} // namespace protocol
