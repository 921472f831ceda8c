// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/pages/jobs/selectioncard.h"

#include "ui/widgets/statefield.h"
#include "ui/words.h"
#include <QHBoxLayout>

namespace pages {

using values::ExecutingJob;
using widgets::StateField;

namespace {

StateField *field(const char *name, const QString &title, ui::Type type)
{
    auto *result = new StateField(title, type);
    result->value()->setObjectName(QLatin1String(name));
    result->value()->setElided(true);
    result->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    return result;
}

} // namespace

SelectionCard::SelectionCard(const Context &context, QWidget *parent)
    : Card(tr("Job"), parent),
      m_state {context.station.state()},
      m_encoding {context.station.profile().encoding},
      m_job {field("jobsJob", tr("Job"), ui::Type::State)},
      m_run {field("jobsRun", tr("Run"), ui::Type::State)},
      m_place {field("jobsPlace", tr("Where it is"), ui::Type::Body)}
{
    setNote(tr("master task"));
    auto *row = new QHBoxLayout;
    row->setSpacing(ui::space::gap);
    row->addWidget(m_job, 3);
    row->addWidget(m_run, 2);
    row->addWidget(m_place, 3);
    body()->addLayout(row);
    connect(&m_state, &robot::RobotState::changed, this, &SelectionCard::showJob);
    showJob();
}

void SelectionCard::showJob()
{
    const auto freshness = m_state.freshness(robot::topics::masterJob);
    m_job->show(widgets::shown(m_state.job(), freshness,
        [this](const ExecutingJob &job) { return widgets::Word {ui::jobName(job, m_encoding)}; }));
    m_place->show(widgets::shown(m_state.job(), freshness, [](const ExecutingJob &job) {
        const QString place = ui::jobPlace(job);
        return widgets::Word {place.isEmpty() ? widgets::dash() : place};
    }));
    m_run->show(widgets::shown(m_state.status(), m_state.freshness(robot::topics::status), ui::runWord));
}

} // namespace pages
