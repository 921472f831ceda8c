// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "protocol/text.h"
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
    JobCard(const robot::RobotState &state, protocol::Encoding encoding, QWidget *parent = nullptr);

private:
    void onChanged(const robot::TopicRange &range);

    const robot::RobotState &m_state;
    protocol::Encoding m_encoding;
    QList<widgets::StateField *> m_fields;
};

} // namespace pages
