// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "robot/joblibrary.h"
#include "ui/pages/page.h"

namespace pages {

class JobListCard;
class JobTextCard;
class SelectCard;
class TasksCard;

/// Jobs: list, text, selection and start, with servo, hold, cycle and what reaches the pendant.
class JobsPage : public Page
{
    Q_OBJECT

public:
    explicit JobsPage(const Context &context, QWidget *parent = nullptr);

    [[nodiscard]] QList<robot::TopicRange> topics() const override;

protected:
    void showEvent(QShowEvent *event) override;

private:
    [[nodiscard]] QWidget *orderColumn(const Context &context);
    void readListOnce();
    void chooseFirst();
    void showJob(const values::FileName &job);

    robot::Orders &m_orders;
    robot::JobLibrary &m_library;
    JobListCard *m_list;
    JobTextCard *m_text;
    SelectCard *m_select;
    TasksCard *m_tasks;
};

} // namespace pages
