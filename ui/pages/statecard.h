// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "robot/robotstate.h"
#include "ui/widgets/card.h"

namespace widgets {
class StateField;
}

namespace pages {

/// The status word in large fields, as received.
class StateCard : public widgets::Card
{
    Q_OBJECT

public:
    explicit StateCard(const robot::RobotState &state, QWidget *parent = nullptr);

private:
    void onChanged(const robot::TopicRange &range);

    const robot::RobotState &m_state;
    QList<widgets::StateField *> m_fields; ///< In the order of the table of fields.
};

} // namespace pages
