// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "virtualcontroller/motion.h"

#include "virtualcontroller/kinematics.h"
#include <cmath>

using values::AxisNames;
using values::AxisWords;

namespace virtualcontroller {

namespace {

/// How much of the time has passed, 0 to 1.
double progress(const Motion &motion, Time now)
{
    if (now >= motion.end)
        return 1;
    return std::max(0.0, double((now - motion.begin).count()) / double((motion.end - motion.begin).count()));
}

double seconds(const Motion &motion) { return double((motion.end - motion.begin).count()) / 1000; }
bool isUnderway(const Motion &motion, Time now) { return now > motion.begin && now < motion.end; }

AxisNames named(std::initializer_list<const char *> names, int count)
{
    AxisNames result;
    std::transform(names.begin(), names.begin() + std::min<qsizetype>(count, qsizetype(names.size())),
        result.names.begin(), [](const char *name) { return values::FixedText<4> {name}; });
    return result;
}

std::array<double, values::maxAxes> scaled(const Motion &motion, double factor)
{
    std::array<double, values::maxAxes> result {};
    for (int axis = 0; axis < motion.to.count(); ++axis)
        result[std::size_t(axis)] = factor * (double(motion.to[axis]) - motion.from[axis]);
    return result;
}

/// A motion as its axes do it: in pulses.
Motion inPulses(const Group &group)
{
    Motion motion = *group.motion;
    if (group.isRobot()) {
        motion.from = kinematics::toPulses(motion.from);
        motion.to = kinematics::toPulses(motion.to);
    }
    return motion;
}

} // namespace

AxisWords Motion::poseAt(Time now) const
{
    const double u = progress(*this, now);
    const double way = u * u * (3 - 2 * u);
    AxisWords pose = from;
    for (int axis = 0; axis < to.count(); ++axis)
        pose[axis] = qint32(std::lround(from[axis] + way * (double(to[axis]) - from[axis])));
    return pose;
}

std::array<double, values::maxAxes> Motion::velocityAt(Time now) const
{
    const double u = progress(*this, now);
    return scaled(*this, isUnderway(*this, now) ? 6 * u * (1 - u) / seconds(*this) : 0);
}

std::array<double, values::maxAxes> Motion::accelerationAt(Time now) const
{
    const double u = progress(*this, now);
    const double time = seconds(*this);
    return scaled(*this, isUnderway(*this, now) ? (6 - 12 * u) / (time * time) : 0);
}

AxisWords Group::pulsesAt(Time now) const { return isRobot() ? kinematics::toPulses(poseAt(now)) : poseAt(now); }

AxisWords Group::cartesianAt(Time now) const { return isRobot() ? poseAt(now) : kinematics::toCartesian(poseAt(now)); }

AxisNames Group::pulseNames() const
{
    return isRobot() ? named({"S", "L", "U", "R", "B", "T", "E"}, pose.count())
                     : named({"1", "2", "3", "4", "5", "6"}, pose.count());
}

AxisNames Group::cartesianNames() const
{
    return isRobot() ? named({"X", "Y", "Z", "Rx", "Ry", "Rz", "Re"}, pose.count())
                     : named({"X", "Y", "Z"}, pose.count());
}

AxisWords Group::followingErrorAt(Time now) const
{
    AxisWords error = pose;
    const auto velocity = motion ? inPulses(*this).velocityAt(now) : std::array<double, values::maxAxes> {};
    for (int axis = 0; axis < error.count(); ++axis)
        error[axis] = qint32(std::lround(velocity[std::size_t(axis)] * 0.025));
    return error;
}

AxisWords Group::torqueAt(Time now, bool servoOn) const
{
    static constexpr std::array<qint32, values::maxAxes> standing {0, 240, 180, 0, 35, 0, 0, 0};
    AxisWords torque = pose;
    const auto acceleration = motion ? inPulses(*this).accelerationAt(now) : std::array<double, values::maxAxes> {};
    for (int axis = 0; axis < torque.count(); ++axis)
        torque[axis] =
            servoOn ? standing[std::size_t(axis)] + qint32(std::lround(acceleration[std::size_t(axis)] * 0.002)) : 0;
    return torque;
}

void Group::stop(Time now)
{
    pose = poseAt(now);
    motion.reset();
}

bool Group::settle(Time now)
{
    if (!motion || now < motion->end)
        return false;
    stop(now);
    return true;
}

} // namespace virtualcontroller
