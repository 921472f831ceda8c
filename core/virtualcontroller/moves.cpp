// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
// Move orders: reference §6.2 and §6.3.
#include "protocol/payloads.h"
#include "virtualcontroller/handlers.h"
#include "virtualcontroller/machine.h"

using protocol::Request;
using values::CartesianMove;
using values::CartesianTarget;
using values::ControlGroup;
using values::PositionType;
using values::PulseTarget;
using values::SpeedClass;

namespace virtualcontroller {

namespace {

constexpr quint32 fullSpeed = 10000; ///< 100 % in 0.01 %.
constexpr quint32 formBits = 0xFF;

/// Exactly one group, and it is configured.
quint16 checkGroup(const auto &target, const Memory &memory)
{
    if ((target.robot == 0) == (target.station == 0))
        return GroupFault;
    const bool isRobot = target.robot != 0;
    if (isRobot ? target.robot > 8 : target.station > 24)
        return GroupFault;
    const auto group =
        isRobot ? ControlGroup::robotPulse(int(target.robot)) : ControlGroup::stationPulse(int(target.station));
    return memory.findGroup(group) ? 0 : GroupFault;
}

/// Percent goes with joint moves, the other classes with straight ones.
quint16 checkSpeed(values::Speed speed, bool isJoint)
{
    if (speed.kind > SpeedClass::Rotation || isJoint != (speed.kind == SpeedClass::Percent))
        return SpeedFault;
    if (speed.value == 0)
        return NoSpeed;
    return isJoint && speed.value > fullSpeed ? SpeedFault : 0;
}

quint16 checkFrame(const CartesianTarget &target)
{
    if (target.frame < PositionType::Base || target.frame > PositionType::Tool)
        return CoordinateFault;
    if (target.form > formBits || target.extendedForm > formBits)
        return TypeFault;
    if (target.tool > lastTool)
        return ToolFault;
    const bool needsFrame = target.frame == PositionType::User;
    return target.userFrame > lastUserFrame || (needsFrame && target.userFrame == 0) ? UserFrameFault : 0;
}

quint16 checkGroupAndSpeed(const auto &target, const Request &request, const Memory &memory)
{
    if (const quint16 fault = checkGroup(target, memory))
        return fault;
    return checkSpeed(target.speed, request.instance == quint16(CartesianMove::JointAbsolute));
}

quint16 checkCartesian(const Request &request, const Memory &memory)
{
    const auto target = *protocol::decode<CartesianTarget>(request.payload);
    if (const quint16 fault = checkGroupAndSpeed(target, request, memory))
        return fault;
    return checkFrame(target);
}

quint16 checkPulse(const Request &request, const Memory &memory)
{
    const auto target = *protocol::decode<PulseTarget>(request.payload);
    if (const quint16 fault = checkGroupAndSpeed(target, request, memory))
        return fault;
    return target.tool > lastTool ? ToolFault : 0;
}

/// The first words of several arrays, as many as `count`.
values::AxisWords joined(int count, std::initializer_list<std::span<const qint32>> parts)
{
    values::AxisWords words;
    words.resize(count);
    int axis = 0;
    for (const auto part : parts) {
        for (const qint32 word : part) {
            if (axis < count)
                words[axis++] = word;
        }
    }
    return words;
}

values::AxisWords sum(values::AxisWords words, const values::AxisWords &added)
{
    for (int axis = 0; axis < words.count(); ++axis)
        words[axis] = qint32(std::clamp<qint64>(qint64(words[axis]) + added[axis], INT32_MIN, INT32_MAX));
    return words;
}

/// Moves the robot, with its base if there is one and the values are not 0, or the station.
template <typename Target>
void move(Memory &memory, const Target &target, const values::AxisWords &robotWords, GroupWords unit)
{
    if (target.station != 0) {
        const auto station = ControlGroup::stationPulse(int(target.station));
        moveGroup(memory, station, joined(values::maxAxes, {target.stationAxes}), GroupWords::Pulses, target.speed);
        return;
    }
    moveGroup(memory, ControlGroup::robotPulse(int(target.robot)), robotWords, unit, target.speed);
    const bool hasBase = std::ranges::any_of(target.base, [](qint32 word) { return word != 0; });
    const auto base = ControlGroup::basePulse(int(target.robot));
    if (hasBase && memory.findGroup(base))
        moveGroup(memory, base, joined(values::maxAxes, {target.base}), unit, target.speed);
}

Answer moveCartesian(const Request &request, Memory &memory)
{
    const auto target = *protocol::decode<CartesianTarget>(request.payload);
    auto words = joined(values::maxAxes, {target.xyz, target.rotation});
    if (target.robot != 0 && CartesianMove(request.instance) == CartesianMove::StraightIncremental) {
        const Group *robot = memory.findGroup(ControlGroup::robotPulse(int(target.robot)));
        words = sum(robot->pose, words);
    }
    move(memory, target, words, GroupWords::Cartesian);
    return QByteArray {};
}

Answer movePulse(const Request &request, Memory &memory)
{
    const auto target = *protocol::decode<PulseTarget>(request.payload);
    move(memory, target, joined(values::maxAxes, {target.axes}), GroupWords::Pulses);
    return QByteArray {};
}

} // namespace

std::span<const Handler> moveHandlers()
{
    static constexpr std::array rows {
        Handler {0x8A, checkCartesian, moveCartesian},
        Handler {0x8B, checkPulse, movePulse},
    };
    return rows;
}

} // namespace virtualcontroller
