// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "ui/pages/page.h"
#include "ui/widgets/card.h"

namespace widgets {
class StateField;
}

namespace pages {

/// Two boxes: the job that a start would take, and the job that is being executed. HSES tells one job only, which is
/// the selected one at rest and the executing one while running; meanwhile the other box shows what was last seen.
class SelectionCard : public widgets::Card
{
    Q_OBJECT

public:
    explicit SelectionCard(const Context &context, QWidget *parent = nullptr);

private:
    void showJobs();
    void showSelected(bool isRunning);
    void showExecuting(bool isRunning);

    const robot::RobotState &m_state;
    protocol::Encoding m_encoding;
    robot::Reading<values::ExecutingJob> m_selected; ///< As read the last time at rest.
    widgets::StateField *m_selectedJob;
    widgets::StateField *m_selectedPlace;
    widgets::StateField *m_executingJob;
    widgets::StateField *m_executingPlace;
};

} // namespace pages
