// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "robot/robotstate.h"
#include "ui/widgets/card.h"

namespace widgets {
class StateField;
}

namespace pages {

/// The job that the master task executes, and how far it is.
class JobCard : public widgets::Card
{
    Q_OBJECT

public:
    explicit JobCard(const robot::RobotState &state, QWidget *parent = nullptr);

private:
    void onChanged(robot::Topic topic);

    const robot::RobotState &m_state;
    QList<widgets::StateField *> m_fields;
};

} // namespace pages
