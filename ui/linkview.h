// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "robot/controller.h"

namespace ui {

/// A controller's link as values: what strip, rail, pages and message bar need to know to show it.
struct LinkView {
    robot::LinkState state = robot::LinkState::Disconnected;
    QDateTime since; ///< When the state began, by this computer's clock.
    std::optional<values::Error> trouble; ///< Why checking does not get on.
    int timesLost = 0;
    robot::HoldState hold;
};

[[nodiscard]] LinkView linkView(const robot::Controller &controller);

/// "live", "communication lost", in small words.
[[nodiscard]] QString linkWord(robot::LinkState state);
/// "192.168.1.31", with the port where it is not the usual one.
[[nodiscard]] QString addressText(const settings::Profile &profile);

} // namespace ui
