// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/pages/jobs/jobtextcard.h"

#include "protocol/codes.h"
#include "ui/widgets/flow.h"
#include "ui/widgets/jobview.h"
#include "ui/widgets/tickbox.h"
#include "ui/words.h"
#include <QCheckBox>
#include <QGridLayout>
#include <QListWidget>
#include <QPushButton>
#include <algorithm>

namespace pages {

using robot::JobLibrary;
using values::FileName;

JobTextCard::JobTextCard(const Context &context, JobLibrary &library, QWidget *parent)
    : Card(tr("Job text"), parent),
      m_state {context.station.state()},
      m_library {library},
      m_encoding {context.station.profile().encoding},
      m_view {new widgets::JobView},
      m_empty {widgets::sentence(tr("Choose a job in the list to read it."), ui::Role::Text2)},
      m_outline {new QListWidget},
      m_follow {new widgets::TickBox(tr("Follow what is executed"))},
      m_read {new QPushButton(tr("Read again"))}
{
    m_view->setObjectName(QStringLiteral("jobText"));
    m_empty->setObjectName(QStringLiteral("jobTextEmpty"));
    m_follow->setObjectName(QStringLiteral("followJob"));
    m_follow->setChecked(true);
    m_read->setObjectName(QStringLiteral("readJob"));
    m_read->setEnabled(false);
    widgets::keepRoom(m_view);
    auto *texts = new QGridLayout; // while there is no text, a sentence stands in its place
    texts->addWidget(m_view, 0, 0);
    texts->addWidget(m_empty, 0, 0, Qt::AlignTop);
    texts->addWidget(outline(), 0, 1);
    texts->setColumnStretch(0, 3);
    texts->setColumnStretch(1, 1);
    auto *row = new widgets::Flow;
    row->addWidget(m_follow);
    row->addStretch();
    row->addWidget(m_read);
    body()->addLayout(texts, 1);
    body()->addLayout(row);
    connect(m_read, &QPushButton::clicked, this, [this] { m_library.readText(*m_job); });
    connect(m_follow, &QCheckBox::toggled, m_view, &widgets::JobView::setFollowing);
    connect(&library, &JobLibrary::copyChanged, this, &JobTextCard::showCopy);
    connect(&m_state, &robot::RobotState::changed, this, &JobTextCard::onStateChanged);
    m_view->hide();
}

QWidget *JobTextCard::outline()
{
    m_outline->setObjectName(QStringLiteral("jobOutline"));
    m_outline->setAccessibleName(tr("Labels and calls"));
    m_outline->setFrameShape(QFrame::NoFrame);
    m_outline->setFont(ui::font(ui::Type::Label));
    const auto jump = [this](int row) {
        if (row >= 0 && row < m_marks.size())
            m_view->goTo(m_marks[row].line);
    };
    connect(m_outline, &QListWidget::currentRowChanged, this, jump);
    auto *result = new QWidget;
    auto *column = new QVBoxLayout(result);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(widgets::text(tr("Labels and calls"), ui::Type::Label, ui::Role::Text2));
    column->addWidget(m_outline, 1);
    return result;
}

QString JobTextCard::text(QByteArrayView bytes) const { return ui::controllerText(bytes, m_encoding); }

void JobTextCard::showJob(const FileName &job)
{
    if (m_job == job)
        return;
    m_job = job;
    m_read->setEnabled(true);
    const auto &copy = m_library.copy(job);
    if (!copy.text.value || copy.mayBeOld)
        m_library.readText(job);
    showCopy();
}

void JobTextCard::showCopy()
{
    if (!m_job)
        return;
    const JobLibrary::Copy &copy = m_library.copy(*m_job);
    const inform::Job parsed = inform::parse(copy.text.value.value_or(QByteArray()));
    QStringList lines;
    for (int line = 0; line < parsed.lineCount(); ++line)
        lines << text(parsed.at(line).text);
    m_view->showLines(lines, parsed.aliases);
    showOutline(parsed);
    showNotes(copy, parsed);
    showExecutingLine();
}

/// "*NEXT" and "JOB:CLAMP", in the order of their lines.
QList<inform::Mark> JobTextCard::marksOf(const inform::Job &parsed)
{
    QList<inform::Mark> marks;
    for (const inform::Mark &label : parsed.labels())
        marks << inform::Mark {'*' + label.name, label.line};
    for (const inform::Mark &call : parsed.calls())
        marks << inform::Mark {"JOB:" + call.name, call.line};
    std::ranges::stable_sort(marks, {}, &inform::Mark::line);
    return marks;
}

void JobTextCard::showOutline(const inform::Job &parsed)
{
    const auto marks = marksOf(parsed);
    if (marks == m_marks)
        return;
    m_marks = marks;
    m_outline->clear();
    for (const inform::Mark &mark : m_marks)
        m_outline->addItem(tr("%1  %2", "line and label").arg(mark.line).arg(text(mark.name)));
}

void JobTextCard::showNotes(const JobLibrary::Copy &copy, const inform::Job &parsed)
{
    const QString clock = copy.text.clock.toString(u"HH:mm:ss");
    setTitle(
        parsed.comment.isEmpty() ? text(m_job->base()) : tr("%1 · %2").arg(text(m_job->base()), text(parsed.comment)));
    setNote(copy.isReading ? tr("reading…") : copy.text.value ? tr("read at %1").arg(clock) : QString());
    const QString old = tr("Read at %1. The controller was in TEACH or the link was lost since: this copy may be old.");
    setReason(copy.trouble ? tr("The job could not be read: %1.").arg(protocol::explain(*copy.trouble))
            : copy.mayBeOld && !copy.isReading ? old.arg(clock)
                                               : QString());
    if (copy.text.value && parsed.instructions.empty())
        m_empty->setText(tr("This file holds no instructions that could be shown."));
    else
        m_empty->setText(copy.isReading ? tr("Reading the job…") : tr("The job was not read yet."));
    m_empty->setVisible(parsed.instructions.empty());
    m_view->setVisible(!parsed.instructions.empty());
}

void JobTextCard::onStateChanged(const robot::TopicRange &range)
{
    if (!range.contains(robot::topics::masterJob) && !range.contains(robot::topics::status))
        return;
    const auto &job = m_state.job().value;
    const QByteArray executing = job ? job->name.bytes().toByteArray() : QByteArray();
    const bool isRunning = m_state.status().value && m_state.status().value->isRunning();
    if (isRunning && std::exchange(m_executing, executing) != executing && m_follow->isChecked()) {
        if (const auto name = FileName::create(executing + ".JBI"); name && !executing.isEmpty())
            Q_EMIT followed(*name);
    }
    showExecutingLine();
}

/// At rest it is the line that a start begins with, which is marked all the same: the pendant's cursor stands there.
void JobTextCard::showExecutingLine()
{
    const bool isLive = m_state.freshness(robot::topics::masterJob) == robot::Freshness::Live;
    const bool isThis = m_job && m_state.job().value && m_job->base() == m_state.job().value->name.bytes();
    m_view->setExecutingLine(isLive && isThis ? std::optional(int(m_state.job().value->line)) : std::nullopt);
}

} // namespace pages
