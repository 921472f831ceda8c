// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/pages/jobs/selectcard.h"

#include "ui/widgets/flow.h"
#include "ui/widgets/text.h"
#include "ui/words.h"
#include <QAbstractItemView>
#include <QComboBox>
#include <QHBoxLayout>
#include <QSpinBox>

namespace pages {

using robot::Act;
using robot::Situation;
using values::JobTarget;

namespace {

constexpr int lastLine = 9999; // reference §6.1

} // namespace

SelectCard::SelectCard(const Context &context, QWidget *parent)
    : OrderCard(context, tr("Select"), parent), m_target {new QComboBox}, m_line {new QSpinBox}
{
    m_target->setObjectName(QStringLiteral("selectTarget"));
    m_target->view()->setObjectName(QStringLiteral("selectTargets"));
    m_target->setAccessibleName(tr("Select as"));
    m_target->addItem(tr("to be executed"));
    m_target->addItem(tr("master job"));
    const int subTasks = context.station.profile().dialect().lastMasterJob - JobTarget::masterOf(0).instance;
    for (int task = 1; task <= subTasks; ++task)
        m_target->addItem(tr("master job of sub task %1").arg(task));
    m_line->setObjectName(QStringLiteral("selectLine"));
    m_line->setAccessibleName(tr("From line"));
    m_line->setPrefix(tr("line "));
    m_line->setRange(0, lastLine);
    auto *row = new widgets::Flow;
    row->addWidget(m_target);
    row->addWidget(m_line);
    body()->addLayout(row);
    m_execute = addButton(Act::SelectJob);
    m_master = addButton(Act::SelectMasterJob);
    for (widgets::OrderButton *button : {m_execute, m_master})
        widgets::reserveWidth(button->button(), {tr("Select %1").arg(QStringLiteral("WELD_PART_A12"))});
    connect(m_execute, &widgets::OrderButton::clicked, this, &SelectCard::selectToExecute);
    connect(m_master, &widgets::OrderButton::clicked, this, &SelectCard::selectMaster);
    connect(m_target, &QComboBox::currentIndexChanged, this, &SelectCard::showTarget);
    showTarget();
}

QString SelectCard::jobText() const
{
    return m_job ? ui::controllerText(m_job->base(), m_profile.encoding) : QString();
}

void SelectCard::setJob(const values::FileName &job)
{
    if (m_job == job)
        return;
    m_job = job;
    m_line->setValue(0);
    showTarget();
}

void SelectCard::showTarget()
{
    const bool isMaster = m_target->currentIndex() > 0;
    m_line->setVisible(!isMaster); // it has no meaning for master jobs
    m_execute->setVisible(!isMaster);
    m_master->setVisible(isMaster);
    for (widgets::OrderButton *button : {m_execute, m_master}) {
        button->setText(m_job ? tr("Select %1").arg(jobText()) : tr("Select"));
        button->setComplaint(m_job ? QString() : tr("Choose a job in the list first."));
    }
}

void SelectCard::selectToExecute()
{
    const values::JobSelection selection {values::JobName {m_job->base()}, quint32(m_line->value())};
    const auto &before = m_orders.situation().job;
    const QString old = before ? ui::jobName(*before, m_profile.encoding) : QString();
    order(m_execute, protocol::SelectJob {selection},
        {Act::SelectJob, jobText(), old, tr("%1, line %2").arg(jobText()).arg(selection.line)},
        [selection](const Situation &s) { return s.job && s.job->name == selection.job; });
}

void SelectCard::selectMaster()
{
    const int task = m_target->currentIndex() - 1;
    const values::JobSelection selection {values::JobName {m_job->base()}, 0};
    order(m_master, protocol::SelectJob {selection, JobTarget::masterOf(task)},
        {Act::SelectMasterJob, tr("task %1").arg(task), {}, jobText()});
}

} // namespace pages
