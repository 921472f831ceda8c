// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/pages/jobs/taskscard.h"

#include "ui/widgets/rows.h"
#include "ui/words.h"
#include <QPushButton>

namespace pages {

TasksCard::TasksCard(const Context &context, QWidget *parent)
    : Card(tr("Tasks"), parent),
      m_state {context.station.state()},
      m_encoding {context.station.profile().encoding},
      m_count {context.station.profile().dialect().tasks - 1},
      m_open {new QPushButton(tr("Show the sub tasks"))},
      m_rows {new widgets::Rows(Qt::AlignLeft)}
{
    setNote(tr("%n sub task(s)", nullptr, m_count));
    m_open->setObjectName(QStringLiteral("showTasks"));
    m_open->setCheckable(true);
    for (int task = 1; task <= m_count; ++task)
        m_rows->add(QStringLiteral("task%1").arg(task), tr("Sub task %1").arg(task));
    m_rows->hide();
    body()->addWidget(m_open);
    body()->addWidget(m_rows);
    connect(m_open, &QPushButton::toggled, this, &TasksCard::onToggled);
    connect(&m_state, &robot::RobotState::changed, this, [this](const robot::TopicRange &range) {
        if (range.kind == robot::Kind::Job)
            showTasks();
    });
}

QList<robot::TopicRange> TasksCard::topics() const
{
    if (!m_open->isChecked())
        return {};
    return {{robot::Kind::Job, 1, m_count}};
}

void TasksCard::onToggled(bool isOpen)
{
    m_rows->setVisible(isOpen);
    showTasks();
    Q_EMIT topicsChanged();
}

void TasksCard::showTasks()
{
    if (!m_open->isChecked())
        return;
    for (int task = 1; task <= m_count; ++task) {
        const auto freshness = m_state.freshness({robot::Kind::Job, quint16(task)});
        m_rows->show(task - 1, widgets::shown(m_state.job(task), freshness, [this](const values::ExecutingJob &job) {
            return widgets::Word {tr("%1 · %2").arg(ui::jobName(job, m_encoding), ui::jobPlace(job))};
        }));
    }
}

} // namespace pages
