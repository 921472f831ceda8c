// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "motion/plan.h"
#include "motion/stepengine.h"
#include "robot/orders.h"

namespace robot {

/// Sends a planned move once, as `act`, which is Move or Jog; the journal keeps where it began and what was ordered.
void send(Orders &orders, Act act, const motion::Plan &plan, const motion::Present &present, QObject *context,
    OrderHandler handler);

/// What the end of an order means to those who watch motion: only a refusal says that nothing moves.
[[nodiscard]] motion::StepEngine::Reply replyOf(const values::Result<void> &result);

/// What is known now of where a robot or a station stands: live readings only.
[[nodiscard]] motion::Present presentOf(const RobotState &state, values::ControlGroup group);

/// In the words of the journal, numbers as in files: "base frame X 812.500 Y … , 10.0 mm/s".
[[nodiscard]] QString toText(const values::Position &position);
[[nodiscard]] QString toText(const motion::MoveOrder &order);

} // namespace robot
