// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/pages/jobs/selectioncard.h"

#include "ui/widgets/flow.h"
#include "ui/widgets/statefield.h"
#include "ui/words.h"
#include <QHBoxLayout>

namespace pages {

using robot::Freshness;
using values::ExecutingJob;
using widgets::StateField;

namespace {

StateField *field(const char *name, const QString &title, ui::Type type)
{
    auto *result = new StateField(title, type);
    result->value()->setObjectName(QLatin1String(name));
    result->value()->setElided(true);
    return result;
}

/// The two stand together, beside or above the other two.
QLayout *pair(QWidget *job, QWidget *place)
{
    auto *result = new QHBoxLayout;
    result->setSpacing(ui::space::gap);
    for (QWidget *field : {job, place})
        field->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    result->addWidget(job, 2);
    result->addWidget(place, 3);
    return result;
}

} // namespace

SelectionCard::SelectionCard(const Context &context, QWidget *parent)
    : Card(tr("Job"), parent),
      m_state {context.station.state()},
      m_encoding {context.station.profile().encoding},
      m_selectedJob {field("selectedJob", tr("Selected"), ui::Type::State)},
      m_selectedPlace {field("selectedPlace", tr("Starts at"), ui::Type::Body)},
      m_executingJob {field("executingJob", tr("Executing"), ui::Type::State)},
      m_executingPlace {field("executingPlace", tr("Where it is"), ui::Type::Body)}
{
    setNote(tr("master task"));
    auto *row = new widgets::Flow;
    row->setSpacing(ui::space::gap);
    row->addLayout(pair(m_selectedJob, m_selectedPlace));
    row->addLayout(pair(m_executingJob, m_executingPlace));
    body()->addLayout(row);
    connect(&m_state, &robot::RobotState::changed, this, &SelectionCard::showJobs);
    showJobs();
}

void SelectionCard::showJobs()
{
    const auto &status = m_state.status();
    const bool isRunning = status.value && status.value->isRunning();
    if (status.value && !isRunning && m_state.freshness(robot::topics::masterJob) == Freshness::Live)
        m_selected = m_state.job();
    if (!m_state.job().value)
        m_selected = {};
    showSelected(isRunning);
    showExecuting(isRunning);
}

void SelectionCard::showSelected(bool isRunning)
{
    auto freshness = m_state.freshness(robot::topics::masterJob);
    if (isRunning)
        freshness = m_selected.value ? Freshness::Stale : Freshness::Unknown;
    const auto &reading = isRunning ? m_selected : m_state.job();
    m_selectedJob->show(widgets::shown(
        reading, freshness, [this](const ExecutingJob &job) { return widgets::Word {ui::jobName(job, m_encoding)}; }));
    m_selectedPlace->show(
        widgets::shown(reading, freshness, [](const ExecutingJob &job) { return widgets::Word {ui::jobPlace(job)}; }));
}

void SelectionCard::showExecuting(bool isRunning)
{
    const auto freshness = m_state.freshness(robot::topics::masterJob);
    if (!isRunning && freshness == Freshness::Live) {
        const widgets::Shown nothing {{widgets::dash()}, Freshness::Live, tr("No job is running.")};
        m_executingJob->show(nothing);
        m_executingPlace->show(nothing);
        return;
    }
    m_executingJob->show(widgets::shown(m_state.job(), freshness,
        [this](const ExecutingJob &job) { return widgets::Word {ui::jobName(job, m_encoding)}; }));
    m_executingPlace->show(widgets::shown(
        m_state.job(), freshness, [](const ExecutingJob &job) { return widgets::Word {ui::jobPlace(job)}; }));
}

} // namespace pages
