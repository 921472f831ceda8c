// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "robot/robotstate.h"
#include "trend/toolpath.h"
#include "ui/widgets/card.h"
#include <map>

namespace widgets {
class ToolPathView;
}

namespace pages {

/// The way of a robot's tool point from three sides, from positions in the base frame, since the last clearing.
class ToolPathCard : public widgets::Card
{
    Q_OBJECT

public:
    explicit ToolPathCard(const robot::RobotState &state, QWidget *parent = nullptr);

    /// By its pulse instance; a base or a station has no tool point.
    void setGroup(values::ControlGroup group);
    void clear();

private:
    void onChanged(const robot::TopicRange &range);
    void showPath();

    const robot::RobotState &m_state;
    values::ControlGroup m_group;
    std::map<quint16, trend::ToolPath> m_paths; ///< By cartesian instance: whichever is shown, all are kept.
    QList<widgets::ToolPathView *> m_views;
};

} // namespace pages
