// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "ui/pages/jobs/ordercard.h"

namespace widgets {
class StateField;
}

namespace pages {

/// Who holds the robot, and the release of what a command holds. HOLD itself is in the strip.
class HoldCard : public OrderCard
{
    Q_OBJECT

public:
    explicit HoldCard(const Context &context, QWidget *parent = nullptr);

private:
    void showStatus();
    void release();

    widgets::StateField *m_hold;
    widgets::OrderButton *m_release;
    widgets::Line *m_others; ///< Who else holds, and where to release it.
};

} // namespace pages
