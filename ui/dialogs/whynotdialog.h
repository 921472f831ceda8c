// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "robot/orders.h"
#include <QDialog>

namespace dialogs {

/// "Why not?": the conditions of one act at one controller, followed live. It closes with its controller.
class WhyNotDialog : public QDialog
{
    Q_OBJECT

public:
    WhyNotDialog(robot::Orders &orders, robot::Act act, QWidget *parent);
};

} // namespace dialogs
