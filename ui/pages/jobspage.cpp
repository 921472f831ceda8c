// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/pages/jobspage.h"

#include "ui/pages/jobs/cyclecard.h"
#include "ui/pages/jobs/holdcard.h"
#include "ui/pages/jobs/joblistcard.h"
#include "ui/pages/jobs/jobtextcard.h"
#include "ui/pages/jobs/pendantcard.h"
#include "ui/pages/jobs/selectcard.h"
#include "ui/pages/jobs/selectioncard.h"
#include "ui/pages/jobs/servocard.h"
#include "ui/pages/jobs/startcard.h"
#include "ui/pages/jobs/taskscard.h"
#include "ui/widgets/scrollcolumn.h"
#include <QHBoxLayout>

namespace pages {

JobsPage::JobsPage(const Context &context, QWidget *parent)
    : Page(context, parent),
      m_orders {context.station.orders},
      m_library {context.station.jobs},
      m_list {new JobListCard(context, m_library)},
      m_text {new JobTextCard(context, m_library)},
      m_select {new SelectCard(context)},
      m_tasks {new TasksCard(context)}
{
    auto *middle = new QVBoxLayout;
    middle->setSpacing(ui::space::gap);
    middle->addWidget(new SelectionCard(context));
    middle->addWidget(m_text, 1);
    auto *content = new QWidget;
    content->setObjectName(QStringLiteral("jobsContent"));
    auto *row = new QHBoxLayout(content);
    row->setContentsMargins(ui::space::page, 0, ui::space::page, ui::space::page);
    row->setSpacing(ui::space::gap);
    row->addWidget(m_list, 2);
    row->addLayout(middle, 5);
    row->addWidget(orderColumn(context), 3);
    setContent(content);
    connect(m_list, &JobListCard::chosen, this, &JobsPage::showJob);
    connect(m_text, &JobTextCard::followed, this, [this](const values::FileName &job) {
        if (isVisible())
            m_text->showJob(job); // what the person chose in the list stays chosen
    });
    connect(m_tasks, &TasksCard::topicsChanged, this, &JobsPage::topicsChanged);
    connect(&m_orders, &robot::Orders::situationChanged, this, [this] {
        readListOnce();
        chooseFirst();
    });
    connect(&m_library, &robot::JobLibrary::listChanged, this, &JobsPage::chooseFirst);
}

QWidget *JobsPage::orderColumn(const Context &context)
{
    auto *inner = new QWidget;
    auto *column = new QVBoxLayout(inner);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(ui::space::gap);
    for (QWidget *card : std::initializer_list<QWidget *> {m_select, new StartCard(context), new HoldCard(context),
             new ServoCard(context), new CycleCard(context), new PendantCard(context), m_tasks})
        column->addWidget(card);
    column->addStretch();
    auto *scroll = new widgets::ScrollColumn(inner);
    scroll->setObjectName(QStringLiteral("jobOrders"));
    scroll->setAccessibleName(tr("Orders"));
    return scroll;
}

QList<robot::TopicRange> JobsPage::topics() const
{
    return QList<robot::TopicRange> {robot::topics::status, robot::topics::masterJob} + m_tasks->topics();
}

void JobsPage::showEvent(QShowEvent *event)
{
    Page::showEvent(event);
    readListOnce();
}

/// The list is read when the page comes into view the first time on a link; after that by hand.
void JobsPage::readListOnce()
{
    const bool isNeeded = !m_library.list().value || m_library.isListOld();
    const auto &trouble = m_library.listTrouble();
    const bool mayTry = !trouble || trouble->kind == values::ErrorKind::NotSent;
    if (isVisible() && m_orders.situation().isLinkUp && isNeeded && mayTry && !m_library.isListing())
        m_library.readList();
}

/// Until the person has chosen one, the controller's own job is shown.
void JobsPage::chooseFirst()
{
    const auto &job = m_orders.situation().job;
    if (!m_text->job() && job && isVisible())
        m_list->choose(job->name.bytes());
}

void JobsPage::showJob(const values::FileName &job)
{
    m_text->showJob(job);
    m_select->setJob(job);
}

} // namespace pages
