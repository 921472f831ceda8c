// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "motion/plan.h"

#include <QCoreApplication>
#include <cmath>
#include <span>

namespace motion {

namespace {

using values::PositionType;
using values::Result;

struct PlanTexts {
    Q_DECLARE_TR_FUNCTIONS(motion::Plan)
};

/// An empty error says that the speeds may be used.
Result<void> checkSpeeds(const Speeds &speeds, const Limits &limits)
{
    const auto isWithin = [](double speed, double most) { return speed > 0 && speed <= most; };
    if (!isWithin(speeds.tool, limits.toolSpeed))
        return values::badInput(PlanTexts::tr("The speed must be above 0 and at most %1 mm/s.").arg(limits.toolSpeed));
    if (!isWithin(speeds.rotation, limits.rotationSpeed))
        return values::badInput(
            PlanTexts::tr("The rotation speed must be above 0 and at most %1 °/s.").arg(limits.rotationSpeed));
    if (!isWithin(speeds.joint, limits.jointSpeed))
        return values::badInput(
            PlanTexts::tr("The joint speed must be above 0 and at most %1 %.").arg(limits.jointSpeed));
    return {};
}

/// In the units of the wire, never 0 and never above what was asked for by more than the rounding.
quint32 onWire(double speed, double unitsPerOne) { return std::max(1U, quint32(std::floor(speed * unitsPerOne))); }

values::Speed jointSpeed(const Speeds &speeds) { return {values::SpeedClass::Percent, onWire(speeds.joint, 100)}; }

/// How far a cartesian move goes.
struct Reach {
    std::optional<Vector> place; ///< Where the tool point comes to, in the base frame.
    std::optional<values::Position> target;
    double length = 0;
    double angle = 0;
};

double toolSeconds(const Reach &reach, const Speeds &speeds) { return reach.length / speeds.tool; }
double turnSeconds(const Reach &reach, const Speeds &speeds) { return reach.angle / speeds.rotation; }

/// Whichever takes longer is told the controller; then the other stays below its own.
values::Speed straightSpeed(const Reach &reach, const Speeds &speeds)
{
    if (turnSeconds(reach, speeds) > toolSeconds(reach, speeds))
        return {values::SpeedClass::Rotation, onWire(speeds.rotation, 10)};
    return {values::SpeedClass::ToolPoint, onWire(speeds.tool, 10)};
}

values::Position inBase(const Wish &wish)
{
    return {PositionType::Base, wish.form, wish.tool, 0, wish.extendedForm, wish.axes};
}

/// The seventh axis of an arm turns too.
double reTurn(const values::AxisWords &from, const values::AxisWords &to)
{
    const auto re = [](const values::AxisWords &axes) { return axes.count() > 6 ? axes[6] / 1e4 : 0.0; };
    return std::abs(re(to) - re(from));
}

Result<Reach> reachOfTarget(const Wish &wish, const Present &present)
{
    const bool isBase = wish.frame == PositionType::Base || (wish.frame == PositionType::Robot && !present.hasTrack);
    if (!isBase)
        return values::badInput(
            PlanTexts::tr("Where this frame stands cannot be read over HSES, so nobody here knows how far the move "
                          "would go: use the base frame or an increment."));
    if (present.hasTrack && !wish.track)
        return values::badInput(
            PlanTexts::tr("This robot stands on base axes, and HSES does not tell where they are in mm: enter where "
                          "they shall be."));
    const auto target = inBase(wish);
    const auto from = poseOf(*present.base);
    const auto to = poseOf(target);
    if (!from || !to)
        return values::badInput(PlanTexts::tr("The position has no six axes."));
    Reach reach {to->mm, target, distance(*from, *to), rotationDistance(*from, *to)};
    reach.angle = std::max(reach.angle, reTurn(present.base->axes, target.axes));
    return reach;
}

/// How a controller adds up angles is told nowhere; the way of the tool point is known along the base frame only.
Result<Reach> reachOfIncrement(const Wish &wish, const Present &present)
{
    const bool isBase = wish.frame == PositionType::Base || (wish.frame == PositionType::Robot && !present.hasTrack);
    const auto from = poseOf(*present.base);
    const auto way = poseOf(inBase(wish));
    if (!from || !way)
        return values::badInput(PlanTexts::tr("The position has no six axes."));
    Reach reach;
    reach.length = distance(Pose {}, *way);
    reach.angle = std::max(rotationDistance(Pose {}, *way), reTurn({}, wish.axes));
    if (isBase)
        reach.place = {from->mm[0] + way->mm[0], from->mm[1] + way->mm[1], from->mm[2] + way->mm[2]};
    if (isBase && reach.angle == 0) {
        reach.target = *present.base;
        for (int axis = 0; axis < 3; ++axis)
            reach.target->axes[axis] += wish.axes[axis];
    }
    return reach;
}

/// Every place that is so far away, along the axes.
bool holdsAround(const Box &box, const Vector &place, double distance)
{
    Vector least = place;
    Vector most = place;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        least[axis] -= distance;
        most[axis] += distance;
    }
    return box.contains(least) && box.contains(most);
}

Result<BoxCheck> checkBox(const Reach &reach, const Wish &wish, const Present &present, const Limits &limits)
{
    if (!limits.box)
        return BoxCheck::NoBox;
    const Vector from = poseOf(*present.base)->mm;
    if (!limits.box->contains(from))
        return values::badInput(PlanTexts::tr("The tool point stands outside the box of this controller."));
    if (reach.place ? !limits.box->contains(*reach.place) : !holdsAround(*limits.box, from, reach.length))
        return values::badInput(PlanTexts::tr("The move would leave the box of this controller."));
    return wish.how == Wish::How::Joint ? BoxCheck::BothEnds : BoxCheck::WholeWay;
}

Result<void> checkFrame(const Wish &wish, const Limits &limits)
{
    const bool isDoubtful = wish.frame == PositionType::User || wish.frame == PositionType::Tool;
    if (isDoubtful && !limits.areFramesChecked)
        return values::badInput(
            PlanTexts::tr("User and tool frames are off until the profile says that they were checked on the robot."));
    if (wish.frame == PositionType::User && (wish.userFrame < 1 || wish.userFrame > 63))
        return values::badInput(PlanTexts::tr("The user frame must be from 1 to 63."));
    if (wish.tool > 63)
        return values::badInput(PlanTexts::tr("The tool must be from 0 to 63."));
    return {};
}

values::CartesianMove howOnWire(Wish::How how)
{
    switch (how) {
    case Wish::How::Joint: return values::CartesianMove::JointAbsolute;
    case Wish::How::Straight: return values::CartesianMove::StraightAbsolute;
    case Wish::How::Increment: break;
    }
    return values::CartesianMove::StraightIncremental;
}

CartesianOrder cartesianOrder(const Wish &wish, const Reach &reach)
{
    CartesianOrder order;
    order.how = howOnWire(wish.how);
    values::CartesianTarget &target = order.target;
    target.robot = wish.group.instance;
    target.speed = wish.how == Wish::How::Joint ? jointSpeed(wish.speeds) : straightSpeed(reach, wish.speeds);
    target.frame = wish.frame;
    for (int axis = 0; axis < wish.axes.count() && axis < 7; ++axis)
        (axis < 3 ? target.xyz[std::size_t(axis)] : target.rotation[std::size_t(axis - 3)]) = wish.axes[axis];
    target.form = wish.form;
    target.extendedForm = wish.extendedForm;
    target.tool = wish.tool;
    target.userFrame = wish.frame == PositionType::User ? wish.userFrame : 0;
    if (wish.how != Wish::How::Increment)
        target.base = wish.track.value_or(target.base);
    return order;
}

Result<Plan> planCartesian(const Wish &wish, const Present &present, const Limits &limits)
{
    if (wish.group.instance > 8)
        return values::badInput(PlanTexts::tr("A base or a station is moved in pulses."));
    if (const auto frame = checkFrame(wish, limits); !frame)
        return tl::unexpected(frame.error());
    if (!present.base)
        return values::badInput(PlanTexts::tr("The present position was not read."));
    const auto reach =
        wish.how == Wish::How::Increment ? reachOfIncrement(wish, present) : reachOfTarget(wish, present);
    if (!reach)
        return tl::unexpected(reach.error());
    const auto box = checkBox(*reach, wish, present, limits);
    if (!box)
        return tl::unexpected(box.error());
    Plan plan {cartesianOrder(wish, *reach), values::ControlGroup::robotCartesian(wish.group.instance), reach->target,
        reach->length, reach->angle, {}, *box};
    if (wish.how != Wish::How::Joint) {
        const double seconds = std::max(toolSeconds(*reach, wish.speeds), turnSeconds(*reach, wish.speeds));
        plan.time = std::chrono::milliseconds {std::llround(seconds * 1000)};
    }
    return plan;
}

/// Who moves. A base moves with its robot, whose axes stay where they are (reference §6.3).
struct PulseGroups {
    explicit PulseGroups(values::ControlGroup group)
        : isTrack {motion::isTrack(group)},
          robot {group.instance > 20 ? 0U
                  : isTrack          ? group.instance - 10U
                                     : group.instance},
          station {group.instance > 20 ? group.instance - 20U : 0U}
    {
    }

    bool isTrack;
    quint32 robot;
    quint32 station;
};

void fill(std::span<qint32> words, const values::AxisWords &axes)
{
    for (int axis = 0; axis < std::min(axes.count(), int(words.size())); ++axis)
        words[std::size_t(axis)] = axes[axis];
}

Result<Plan> planPulses(const Wish &wish, const Present &present, const Limits &limits)
{
    if (wish.how != Wish::How::Joint)
        return values::badInput(
            PlanTexts::tr("A target in pulses can only be reached by a joint move: how far the tool point would go, "
                          "and so how fast, is not known here."));
    if (limits.box)
        return values::badInput(
            PlanTexts::tr("This controller has a box, and where pulses lead is not known here: use the base frame."));
    const PulseGroups groups {wish.group};
    if (!present.pulse || ((groups.isTrack || present.hasTrack) && !present.track))
        return values::badInput(PlanTexts::tr("The present position was not read."));
    if (wish.tool > 63)
        return values::badInput(PlanTexts::tr("The tool must be from 0 to 63."));
    PulseOrder order;
    values::PulseTarget &target = order.target;
    target.speed = jointSpeed(wish.speeds);
    target.tool = wish.tool;
    target.robot = groups.robot;
    target.station = groups.station;
    if (groups.station != 0)
        fill(target.stationAxes, wish.axes);
    else
        fill(target.axes, groups.isTrack ? present.pulse->axes : wish.axes);
    if (groups.isTrack)
        fill(target.base, wish.axes);
    else if (wish.track)
        target.base = *wish.track;
    else if (present.track)
        fill(target.base, present.track->axes);
    values::Position expected = *present.at(wish.group);
    for (int axis = 0; axis < std::min(wish.axes.count(), expected.axes.count()); ++axis)
        expected.axes[axis] = wish.axes[axis];
    return Plan {order, wish.group, expected, {}, {}, {}, BoxCheck::NoBox};
}

} // namespace

std::optional<values::Position> &Present::at(values::ControlGroup group)
{
    return group.isCartesian() ? base : isTrack(group) ? track : pulse;
}

const std::optional<values::Position> &Present::at(values::ControlGroup group) const
{
    return const_cast<Present *>(this)->at(group);
}

bool Plan::isLong() const { return !length || !angle || *length > longLength || *angle > longAngle; }

Result<Plan> plan(const Wish &wish, const Present &present, const Limits &limits)
{
    if (const auto speeds = checkSpeeds(wish.speeds, limits); !speeds)
        return tl::unexpected(speeds.error());
    return wish.frame == PositionType::Pulse ? planPulses(wish, present, limits) : planCartesian(wish, present, limits);
}

} // namespace motion
