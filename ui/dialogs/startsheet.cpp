// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/dialogs/startsheet.h"

#include "ui/conditionwords.h"
#include "ui/widgets/rows.h"
#include "ui/widgets/startbutton.h"
#include "ui/widgets/text.h"
#include "ui/words.h"
#include <QKeyEvent>
#include <QLineEdit>
#include <QLocale>
#include <QVBoxLayout>

using namespace std::chrono_literals;
using robot::Act;
using robot::JobStart;
using values::Status;

namespace dialogs {

StartSheet::StartSheet(robot::Orders &orders, QWidget *parent)
    : DialogSheet(parent),
      m_orders {orders},
      m_rows {new widgets::Rows(Qt::AlignLeft)},
      m_reason {widgets::sentence({}, ui::Role::Amber)},
      m_phase {widgets::sentence({}, ui::Role::Text1)},
      m_words {new QLineEdit},
      m_start {new widgets::StartButton(tr("Start"))},
      m_close {new QPushButton(tr("Cancel"))}
{
    setObjectName(QStringLiteral("startSheet"));
    setWindowTitle(tr("Start at %1").arg(orders.controller().profile().name));
    setMinimumWidth(440);
    makeWidgets();
    m_guard.setSingleShot(true);
    m_guard.setInterval(1s);
    m_guard.setTimerType(Qt::PreciseTimer);
    connect(&m_guard, &QTimer::timeout, this, &StartSheet::onGuardPassed);
    connect(m_start, &QPushButton::clicked, this, &StartSheet::start);
    connect(m_close, &QPushButton::clicked, this, &QDialog::close);
    connect(&orders, &robot::Orders::situationChanged, this, &StartSheet::update);
    update();
}

void StartSheet::makeWidgets()
{
    m_rows->add(QStringLiteral("sheetController"), tr("Controller"));
    m_rows->add(QStringLiteral("sheetJob"), tr("Job"));
    m_rows->add(QStringLiteral("sheetLine"), tr("From line"));
    m_rows->add(QStringLiteral("sheetCycle"), tr("Cycle"));
    m_rows->add(QStringLiteral("sheetOverride"), tr("Speed override"));
    m_reason->setObjectName(QStringLiteral("sheetReason"));
    m_reason->setMinimumHeight(2 * m_reason->fontMetrics().lineSpacing()); // whether or not there is one
    m_phase->setObjectName(QStringLiteral("sheetPhase"));
    m_words->setObjectName(QStringLiteral("sheetWords"));
    m_start->setObjectName(QStringLiteral("sheetStart"));
    m_close->setObjectName(QStringLiteral("sheetClose"));
    m_close->setDefault(true);
    auto *buttons = new QHBoxLayout;
    buttons->addWidget(widgets::text(tr("HOLD: Pause key"), ui::Type::Label, ui::Role::Text2));
    buttons->addStretch();
    buttons->addWidget(m_close);
    buttons->addWidget(m_start);
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(ui::space::page, ui::space::page, ui::space::page, ui::space::page);
    column->setSpacing(10);
    column->addWidget(widgets::text(tr("The robot will move"), ui::Type::State, ui::Role::Text1));
    column->addWidget(m_rows);
    column->addWidget(m_reason);
    column->addWidget(m_phase);
    column->addWidget(m_words);
    column->addLayout(buttons);
    m_close->setFocus();
}

std::optional<StartSheet::Subject> StartSheet::subject() const
{
    const robot::Situation &situation = m_orders.situation();
    if (!situation.status || !situation.job)
        return std::nullopt;
    const auto cycle = situation.status->data1 & (Status::Data1 {Status::Step} | Status::OneCycle | Status::Continuous);
    return Subject {*situation.job, cycle};
}

QString StartSheet::jobText() const
{
    const auto subject = this->subject();
    return subject ? ui::jobName(subject->job, m_orders.controller().profile().encoding) : QString();
}

QString StartSheet::startWords() const { return QStringLiteral("START %1").arg(jobText()); }

void StartSheet::showSubject()
{
    const auto &state = m_orders.controller().state();
    const auto freshness = state.freshness(robot::topics::masterJob);
    const auto show = [&](int row, const auto &toText) {
        m_rows->show(row, widgets::shown(state.job(), freshness, [&](const values::ExecutingJob &job) {
            return widgets::Word {toText(job)};
        }));
    };
    m_rows->showText(0, m_orders.controller().profile().name);
    show(1, [this](const auto &) { return jobText(); });
    show(2, [](const auto &job) { return QLocale().toString(job.line); });
    m_rows->show(3, widgets::shown(state.status(), state.freshness(robot::topics::status), ui::cycleWord));
    show(4, ui::overrideText);
}

/// The second begins again whenever something else would be started, or it became possible only now.
void StartSheet::update()
{
    if (m_attempt)
        return;
    showSubject();
    const auto obstacle = m_orders.obstacle(Act::StartJob);
    const auto subject = this->subject();
    m_reason->setText(obstacle ? ui::reason(*obstacle, m_orders.controller().profile().model) : QString());
    const bool isPossible = !obstacle && subject;
    if (isPossible && subject == m_shown)
        return;
    m_shown = isPossible ? subject : std::nullopt;
    m_start->setEnabled(false);
    m_words->setPlaceholderText(tr("With the keyboard: type %1, then F9").arg(startWords()));
    m_words->setAccessibleName(m_words->placeholderText());
    m_words->clear();
    if (isPossible)
        m_guard.start();
    else
        m_guard.stop();
}

void StartSheet::onGuardPassed() { m_start->setEnabled(true); }

void StartSheet::keyPressEvent(QKeyEvent *event)
{
    const bool isStart = event->key() == Qt::Key_F9 && event->modifiers() == Qt::NoModifier && !event->isAutoRepeat();
    if (!isStart)
        return QDialog::keyPressEvent(event);
    if (m_start->isEnabled() && m_words->text() == startWords())
        start();
}

void StartSheet::start()
{
    if (m_attempt || !m_start->isEnabled())
        return;
    m_start->setEnabled(false);
    m_attempt = new JobStart(m_orders, jobText(), this);
    m_words->hide();
    m_close->setText(tr("Close"));
    connect(m_attempt, &JobStart::phaseChanged, this, &StartSheet::showPhase);
    m_attempt->start();
    showPhase();
}

/// That it runs is said by the strip, as long as it is so.
void StartSheet::showPhase()
{
    if (m_attempt->phase() == JobStart::Phase::Running) {
        accept();
        return;
    }
    m_phase->setText(phaseText());
    widgets::setTextRole(m_phase, m_attempt->isFinished() ? ui::Role::Amber : ui::Role::Text1);
}

QString StartSheet::phaseText() const
{
    using Phase = JobStart::Phase;
    switch (m_attempt->phase()) {
    case Phase::Sent: return tr("Start sent…");
    case Phase::Waiting: return tr("Accepted. Waiting for RUN…");
    case Phase::Running: break;
    case Phase::NotRunning:
        return tr("The start was accepted, but no RUN was seen for 3 s. Usual causes: the job was so short that it has "
                  "ended, it waits for a condition of the cell, or the pendant shows a question. Look at the pendant.");
    case Phase::Refused:
        return ui::explain(
            Act::StartJob, m_attempt->error().value_or(values::Error {}), m_orders.controller().profile().model);
    case Phase::Asking: return tr("No answer to the start: it may or may not have happened. Reading the status…");
    case Phase::UnknownRunning:
        return tr("No answer to the start, but a status that was read afterwards said RUN. It was sent once.");
    case Phase::UnknownNotRunning:
        return tr(
            "No answer to the start, and a status that was read afterwards said no RUN. Look at the robot before you "
            "start again.");
    case Phase::UnknownStatus:
        return tr("No answer to the start, and none to the status: whether the robot runs is unknown. Look at it.");
    }
    return {};
}

} // namespace dialogs
