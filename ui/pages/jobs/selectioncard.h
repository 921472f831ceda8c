// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "ui/pages/page.h"
#include "ui/widgets/card.h"

namespace widgets {
class StateField;
}

namespace pages {

/// The job that the controller names (reference §3.5): at rest it is the one that a start would take, while running the
/// one that is executed. Beside it whether it runs, and where it is.
class SelectionCard : public widgets::Card
{
    Q_OBJECT

public:
    explicit SelectionCard(const Context &context, QWidget *parent = nullptr);

private:
    void showJob();

    const robot::RobotState &m_state;
    protocol::Encoding m_encoding;
    widgets::StateField *m_job;
    widgets::StateField *m_run;
    widgets::StateField *m_place;
};

} // namespace pages
