// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/pages/jobcard.h"

#include "ui/widgets/statefield.h"
#include "ui/words.h"
#include <QCoreApplication>
#include <QHBoxLayout>
#include <QLocale>

namespace pages {

namespace {

using protocol::Encoding;
using values::ExecutingJob;

/// Without a job there is no place in it.
QString placeIn(const ExecutingJob &job, quint32 number)
{
    return job.name.isEmpty() ? widgets::dash() : QLocale().toString(number);
}
QString line(const ExecutingJob &job, Encoding) { return placeIn(job, job.line); }
QString step(const ExecutingJob &job, Encoding) { return placeIn(job, job.step); }

QString speedOverride(const ExecutingJob &job, Encoding) { return ui::overrideText(job); }

struct JobRow {
    const char *name;
    const char *title;
    QString (*text)(const ExecutingJob &, Encoding);
    int stretch;
};

constexpr JobRow jobRows[] {
    {"job", QT_TRANSLATE_NOOP("pages::JobCard", "Job"), ui::jobName, 4},
    {"line", QT_TRANSLATE_NOOP("pages::JobCard", "Line"), line, 1},
    {"step", QT_TRANSLATE_NOOP("pages::JobCard", "Step"), step, 1},
    {"override", QT_TRANSLATE_NOOP("pages::JobCard", "Speed override"), speedOverride, 2},
};

} // namespace

JobCard::JobCard(const robot::RobotState &state, protocol::Encoding encoding, QWidget *parent)
    : Card(tr("Job"), parent), m_state {state}, m_encoding {encoding}
{
    setNote(tr("master task"));
    auto *row = new QHBoxLayout;
    row->setSpacing(ui::space::gap);
    for (const JobRow &field : jobRows) {
        auto *widget = new widgets::StateField(tr(field.title), ui::Type::State);
        widget->value()->setObjectName(QLatin1String(field.name));
        row->addWidget(widget, field.stretch);
        m_fields << widget;
    }
    m_fields.front()->value()->setElided(true);
    body()->addLayout(row);
    body()->addStretch();
    connect(&state, &robot::RobotState::changed, this, &JobCard::onChanged);
    onChanged(robot::topics::masterJob);
}

void JobCard::onChanged(const robot::TopicRange &range)
{
    if (!range.contains(robot::topics::masterJob))
        return;
    const auto freshness = m_state.freshness(robot::topics::masterJob);
    for (qsizetype i = 0; i < m_fields.size(); ++i) {
        const auto word = [this, i](
                              const ExecutingJob &job) { return widgets::Word {jobRows[i].text(job, m_encoding)}; };
        m_fields[i]->show(widgets::shown(m_state.job(), freshness, word));
    }
    setReason(freshness == robot::Freshness::Refused ? m_fields.front()->value()->shown().note : QString());
}

} // namespace pages
