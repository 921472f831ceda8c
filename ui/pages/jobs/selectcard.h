// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "ui/pages/jobs/ordercard.h"
#include "values/filename.h"

class QComboBox;
class QSpinBox;

namespace pages {

/// Selects the job that is looked at: to be executed from a line, or as the master job of a task.
class SelectCard : public OrderCard
{
    Q_OBJECT

public:
    explicit SelectCard(const Context &context, QWidget *parent = nullptr);

    void setJob(const values::FileName &job);

private:
    void showTarget();
    void selectToExecute();
    void selectMaster();
    [[nodiscard]] QString jobText() const;

    std::optional<values::FileName> m_job;
    QComboBox *m_target;
    QSpinBox *m_line;
    widgets::OrderButton *m_execute;
    widgets::OrderButton *m_master;
};

} // namespace pages
