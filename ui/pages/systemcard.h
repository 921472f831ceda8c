// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "robot/robotstate.h"
#include "ui/widgets/card.h"

namespace widgets {
class Rows;
}

namespace pages {

/// What the controller says of itself, to be read and copied.
class SystemCard : public widgets::Card
{
    Q_OBJECT

public:
    explicit SystemCard(const robot::RobotState &state, QWidget *parent = nullptr);

private:
    void onChanged(robot::Topic topic);
    void copy() const;

    const robot::RobotState &m_state;
    widgets::Rows *m_rows;
};

} // namespace pages
