// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "robot/orders.h"
#include <QPushButton>
#include <QTimer>

namespace ui {

/// In the strip while its controller is armed: "ARMED · 52 s". Pressed, it disarms.
class ArmBadge : public QPushButton
{
    Q_OBJECT

public:
    /// `orders` must outlive the badge.
    explicit ArmBadge(robot::Orders &orders, QWidget *parent = nullptr);

private:
    void showArming();

    robot::Orders &m_orders;
    QTimer m_clock;
};

} // namespace ui
