// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "motion/jogstep.h"

#include <QCoreApplication>
#include <cmath>

namespace motion {

namespace {

using values::PositionType;
using values::Result;

struct JogStepTexts {
    Q_DECLARE_TR_FUNCTIONS(motion::JogStep)
};

bool isWithin(double step, double most) { return step > 0 && step <= most; }

Result<void> checkStep(const JogChoice &choice, int axis, const Limits &limits)
{
    if (choice.frame == JogFrame::Axes && !isWithin(choice.pulses, limits.stepPulses))
        return values::badInput(
            JogStepTexts::tr("A step must be above 0 and at most %1 pulses.").arg(limits.stepPulses));
    if (choice.frame != JogFrame::Axes && axis < 3 && !isWithin(choice.length, limits.stepLength))
        return values::badInput(JogStepTexts::tr("A step must be above 0 and at most %1 mm.").arg(limits.stepLength));
    if (choice.frame != JogFrame::Axes && axis >= 3 && !isWithin(choice.angle, limits.stepAngle))
        return values::badInput(JogStepTexts::tr("A step must be above 0 and at most %1°.").arg(limits.stepAngle));
    return {};
}

/// In the words of the wire: 0.001 mm or 0.0001 degree.
qint32 wordOf(const JogChoice &choice, JogDirection direction)
{
    const double step = direction.axis < 3 ? choice.length * 1e3 : choice.angle * 1e4;
    return qint32(std::lround(direction.isForward ? step : -step));
}

Result<Wish> cartesianStep(const JogChoice &choice, JogDirection direction, const Present &present)
{
    if (!present.base)
        return values::badInput(JogStepTexts::tr("The present position was not read."));
    if (direction.axis < 0 || direction.axis >= std::min(present.base->axes.count(), 7))
        return values::badInput(JogStepTexts::tr("The group has no such axis."));
    Wish wish {choice.group, Wish::How::Increment,
        choice.frame == JogFrame::Robot ? PositionType::Robot : PositionType::Base, {}, present.base->form,
        present.base->extendedForm, present.base->tool, 0, {}, choice.speeds};
    wish.axes.resize(present.base->axes.count());
    wish.axes[direction.axis] = wordOf(choice, direction);
    return wish;
}

Result<Wish> axisStep(const JogChoice &choice, JogDirection direction, const Present &present)
{
    const auto &here = present.at(choice.group);
    if (!here)
        return values::badInput(JogStepTexts::tr("The present position was not read."));
    if (direction.axis < 0 || direction.axis >= here->axes.count())
        return values::badInput(JogStepTexts::tr("The group has no such axis."));
    Wish wish {choice.group, Wish::How::Joint, PositionType::Pulse, here->axes, 0, 0, here->tool, 0, {}, choice.speeds};
    const qint64 target = qint64(here->axes[direction.axis]) + (direction.isForward ? choice.pulses : -choice.pulses);
    wish.axes[direction.axis] = qint32(std::clamp<qint64>(target, INT32_MIN, INT32_MAX));
    return wish;
}

} // namespace

Result<Plan> planStep(const JogChoice &choice, JogDirection direction, const Present &present, const Limits &limits)
{
    if (const auto step = checkStep(choice, direction.axis, limits); !step)
        return tl::unexpected(step.error());
    const auto wish = choice.frame == JogFrame::Axes ? axisStep(choice, direction, present)
                                                     : cartesianStep(choice, direction, present);
    return wish ? plan(*wish, present, limits) : tl::unexpected(wish.error());
}

} // namespace motion
