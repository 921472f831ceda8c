// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "protocol/dialect.h"
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
    SystemCard(const robot::RobotState &state, protocol::Model expected, QWidget *parent = nullptr);

private:
    void onChanged(const robot::TopicRange &range);
    void copy() const;
    /// Why the card needs attention: a refusal, or another model than the profile says. Empty: it does not.
    [[nodiscard]] QString reason() const;

    const robot::RobotState &m_state;
    protocol::Model m_expected;
    widgets::Rows *m_rows;
};

} // namespace pages
