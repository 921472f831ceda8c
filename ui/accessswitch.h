// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "robot/access.h"
#include <QPushButton>

namespace ui {

/// The access level in the strip; pressed, it offers the others.
class AccessSwitch : public QPushButton
{
    Q_OBJECT

public:
    /// `access` must outlive the switch.
    explicit AccessSwitch(robot::Access &access, QWidget *parent = nullptr);

private:
    void showLevel();
    void enter(robot::Level level);

    robot::Access &m_access;
    QList<QAction *> m_levels; ///< In the order of Level.
    QAction *m_passcode;
};

} // namespace ui
