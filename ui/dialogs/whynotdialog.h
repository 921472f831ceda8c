// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "robot/orders.h"
#include "ui/widgets/dialogsheet.h"

namespace dialogs {

/// "Why not?": the conditions of one act at one controller, followed live. It closes with its controller.
class WhyNotDialog : public widgets::DialogSheet
{
    Q_OBJECT

public:
    WhyNotDialog(robot::Orders &orders, robot::Act act, QWidget *parent);
};

} // namespace dialogs
