// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "robot/orders.h"
#include <QTimer>
#include <QWidget>

class QCheckBox;
class QPushButton;

namespace widgets {

class Line;

/// Arms a controller: three boxes to tick, and a button to be held for one second. While it is armed, a button to
/// disarm; afterwards the reason why it dropped.
class ArmControl : public QWidget
{
    Q_OBJECT

public:
    /// `orders` must outlive the control.
    explicit ArmControl(robot::Orders &orders, QWidget *parent = nullptr);

private:
    void addBox(const char *name, const QString &text);
    [[nodiscard]] bool isTicked() const;
    void onHeld();
    void showState();
    [[nodiscard]] QString reason() const;

    robot::Orders &m_orders;
    QList<QCheckBox *> m_boxes;
    QPushButton *m_arm;
    QPushButton *m_why;
    QPushButton *m_disarm;
    Line *m_reason;
    QTimer m_hold;
    bool m_wasArmed = false;
};

} // namespace widgets
