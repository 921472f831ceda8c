// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "robot/motionorders.h"

#include "variables/text.h"

namespace robot {

namespace {

using values::AxisWords;
using values::ControlGroup;
using values::PositionType;

QString axesText(PositionType type, const AxisWords &axes)
{
    QStringList words;
    for (int axis = 0; axis < axes.count(); ++axis)
        words << QStringLiteral("%1 %2").arg(variables::axisName(variables::Kind::P, type, axis),
            variables::axisText(axes[axis], values::axisUnit(type, axis), QLocale::c()));
    return words.join(u' ');
}

QString orderText(const motion::CartesianOrder &order)
{
    const auto &target = order.target;
    const AxisWords axes {target.xyz[0], target.xyz[1], target.xyz[2], target.rotation[0], target.rotation[1],
        target.rotation[2], target.rotation[3]};
    const bool isIncrement = order.how == values::CartesianMove::StraightIncremental;
    return QStringLiteral("%1 %2 %3, tool %4, %5")
        .arg(values::toString(target.frame), isIncrement ? QStringLiteral("by") : QStringLiteral("to"),
            axesText(target.frame, axes))
        .arg(target.tool)
        .arg(target.speed.toString());
}

QString orderText(const motion::PulseOrder &order)
{
    const auto &target = order.target;
    AxisWords axes;
    axes.resize(target.station != 0 ? int(target.stationAxes.size()) : int(target.axes.size()));
    for (int axis = 0; axis < axes.count(); ++axis)
        axes[axis] = target.station != 0 ? target.stationAxes[std::size_t(axis)] : target.axes[std::size_t(axis)];
    return QStringLiteral("%1 to %2, tool %3, %4")
        .arg(values::toString(PositionType::Pulse), axesText(PositionType::Pulse, axes))
        .arg(target.tool)
        .arg(target.speed.toString());
}

std::optional<values::Position> liveAt(const RobotState &state, ControlGroup group)
{
    if (state.freshness({Kind::Position, group.instance}) != Freshness::Live)
        return std::nullopt;
    return state.reading<Kind::Position>(group.instance).value;
}

} // namespace

QString toText(const values::Position &position)
{
    return QStringLiteral("%1 %2").arg(values::toString(position.type), axesText(position.type, position.axes));
}

QString toText(const motion::MoveOrder &order)
{
    return std::visit([](const auto &one) { return orderText(one); }, order);
}

motion::StepEngine::Reply replyOf(const values::Result<void> &result)
{
    using Reply = motion::StepEngine::Reply;
    if (result)
        return Reply::Accepted;
    const auto kind = result.error().kind;
    const bool isWithheld = kind == values::ErrorKind::Refused || kind == values::ErrorKind::NotSent;
    return isWithheld ? Reply::Refused : Reply::Unknown;
}

motion::Present presentOf(const RobotState &state, ControlGroup group)
{
    motion::Present present;
    if (group.instance > 20) {
        present.pulse = liveAt(state, group);
        return present;
    }
    const int robot = group.instance > 10 ? group.instance - 10 : group.instance;
    const ControlGroup track = ControlGroup::basePulse(robot);
    const auto known = state.freshness({Kind::AxisNames, track.instance});
    present.base = liveAt(state, ControlGroup::robotCartesian(robot));
    present.pulse = liveAt(state, ControlGroup::robotPulse(robot));
    present.hasTrack = known == Freshness::Live || known == Freshness::Stale;
    present.track = liveAt(state, track);
    return present;
}

void send(Orders &orders, Act act, const motion::Plan &plan, const motion::Present &present, QObject *context,
    OrderHandler handler)
{
    const auto &from = present.at(plan.watched);
    const Order order {act, values::toString(plan.watched), from ? toText(*from) : QString(), toText(plan.order)};
    if (const auto *cartesian = std::get_if<motion::CartesianOrder>(&plan.order))
        orders.send(protocol::MoveCartesian {cartesian->how, cartesian->target}, order, context, std::move(handler));
    else if (const auto *pulse = std::get_if<motion::PulseOrder>(&plan.order))
        orders.send(protocol::MovePulse {pulse->how, pulse->target}, order, context, std::move(handler));
}

} // namespace robot
