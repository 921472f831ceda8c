// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/pages/activealarmscard.h"

#include "ui/alarmwords.h"
#include "ui/conditionwords.h"
#include "ui/widgets/orderbutton.h"
#include "ui/widgets/shown.h"
#include "ui/widgets/table.h"
#include "ui/widgets/tabletools.h"
#include <QHBoxLayout>
#include <QPushButton>

using namespace std::chrono_literals;

namespace pages {

using journal::AlarmState;
using journal::Sighting;
using robot::Act;
using robot::Freshness;
using robot::Kind;
using robot::LinkState;

namespace {

constexpr int rowsInView = 2; ///< At the least: more where there is room.
constexpr int wideEnough = 900; ///< For a column of its own for "first seen"; else a tool tip has it.
constexpr auto resetPatience = 1500ms; ///< Alarms that are still there then did not go.

bool isActive(const Sighting &sighting)
{
    return sighting.state == AlarmState::Unacknowledged || sighting.state == AlarmState::Acknowledged;
}

bool isUnacknowledged(const Sighting &sighting)
{
    return sighting.state == AlarmState::Unacknowledged || sighting.state == AlarmState::ClearedUnacknowledged;
}

widgets::Line *small(const char *name)
{
    auto *label = new widgets::Line(ui::Role::Text2);
    label->setObjectName(QLatin1String(name));
    return label;
}

bool hasAlarm(const robot::Situation &situation) { return situation.status && situation.status->hasAlarm(); }

} // namespace

ActiveAlarmsCard::ActiveAlarmsCard(robot::AlarmLog &log, robot::Orders &orders, QWidget *parent)
    : Card(tr("Active alarms"), parent),
      m_log {log},
      m_orders {orders},
      m_codec {orders.controller().profile().encoding},
      m_model {new models::ActiveAlarmModel(log, orders.controller().state(), m_codec, this)},
      m_table {new widgets::Table},
      m_sentence {new widgets::Line(ui::Role::Text2, ui::Type::Body)},
      m_acknowledge {new QPushButton(tr("Acknowledge"))},
      m_acknowledgeAll {new QPushButton(tr("Acknowledge all"))},
      m_reset {new widgets::OrderButton(orders, Act::ResetAlarm)},
      m_cancel {new widgets::OrderButton(orders, Act::CancelError)},
      m_resetTarget {small("resetTarget")},
      m_cancelTarget {small("cancelTarget")},
      m_outcome {new widgets::Line(ui::Role::Text2)}
{
    m_table->setObjectName(QStringLiteral("activeAlarms"));
    m_table->setAccessibleName(tr("Active alarms"));
    m_table->setModel(m_model);
    m_table->verticalHeader()->hide();
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_table->setMinimumHeight((rowsInView + 1) * widgets::Table::rowHeight + 2);
    widgets::fitColumns(m_table,
        {ui::word(AlarmState::ClearedUnacknowledged), QStringLiteral("9999"), QStringLiteral("S L U R B T"), {},
            QStringLiteral("2026/01/12 08:30"), QStringLiteral("2026-01-12 08:30:05"), QStringLiteral("99999")});
    m_sentence->setObjectName(QStringLiteral("alarmSentence"));
    m_outcome->setObjectName(QStringLiteral("clearOutcome"));
    body()->addWidget(m_sentence);
    body()->addWidget(m_table, 1);
    body()->addWidget(acknowledging());
    body()->addWidget(clearing());
    body()->addWidget(m_outcome);
    m_resetPatience.setSingleShot(true);
    connect(&m_resetPatience, &QTimer::timeout, this, &ActiveAlarmsCard::checkReset);
    connect(&log, &robot::AlarmLog::alarmsChanged, this, &ActiveAlarmsCard::refresh);
    connect(&orders, &robot::Orders::situationChanged, this, &ActiveAlarmsCard::refresh);
    connect(&orders.controller(), &robot::Controller::linkStateChanged, this, &ActiveAlarmsCard::refresh);
    connect(&orders.controller().state(), &robot::RobotState::changed, this, [this](const robot::TopicRange &range) {
        if (range.kind == Kind::Alarm)
            refresh();
    });
    refresh();
}

QWidget *ActiveAlarmsCard::acknowledging()
{
    m_acknowledge->setObjectName(QStringLiteral("acknowledge"));
    m_acknowledgeAll->setObjectName(QStringLiteral("acknowledgeAll"));
    auto *hint = small("acknowledgeHint");
    hint->setWords(tr("Acknowledging is noted on this computer only. The robot does not hear of it."));
    auto *result = new QWidget;
    auto *row = new QHBoxLayout(result);
    row->setContentsMargins(0, 0, 0, 0);
    row->addWidget(m_acknowledge);
    row->addWidget(m_acknowledgeAll);
    row->addWidget(hint, 1);
    connect(m_acknowledge, &QPushButton::clicked, this, &ActiveAlarmsCard::acknowledgeSelected);
    connect(m_acknowledgeAll, &QPushButton::clicked, this, &ActiveAlarmsCard::acknowledgeAll);
    connect(m_table->selectionModel(), &QItemSelectionModel::selectionChanged, this, &ActiveAlarmsCard::refresh);
    connect(m_table->selectionModel(), &QItemSelectionModel::currentRowChanged, this, [this](const QModelIndex &now) {
        if (now.isValid())
            Q_EMIT codeChosen(m_model->at(now.row()).sighting.alarm.alarm.code);
    });
    return result;
}

QWidget *ActiveAlarmsCard::clearing()
{
    auto *result = new QWidget;
    auto *row = new QHBoxLayout(result);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(ui::space::gap);
    const auto column = [row](widgets::OrderButton *button, QLabel *target) {
        auto *side = new QVBoxLayout;
        side->setSpacing(2);
        side->addWidget(button);
        side->addWidget(target);
        side->addStretch();
        row->addLayout(side, 1);
    };
    column(m_reset, m_resetTarget);
    column(m_cancel, m_cancelTarget);
    connect(m_reset, &widgets::OrderButton::clicked, this, &ActiveAlarmsCard::reset);
    connect(m_cancel, &widgets::OrderButton::clicked, this, &ActiveAlarmsCard::cancelError);
    return result;
}

void ActiveAlarmsCard::resizeEvent(QResizeEvent *event)
{
    Card::resizeEvent(event);
    m_table->setColumnHidden(models::ActiveAlarmModel::FirstSeen, width() < wideEnough);
}

void ActiveAlarmsCard::refresh()
{
    m_sentence->setWords(stateSentence());
    const bool isAnyLeft =
        std::ranges::any_of(m_log.alarms(), [](const auto &entry) { return isUnacknowledged(entry.sighting); });
    m_acknowledge->setEnabled(isAnyLeft && m_table->selectionModel()->hasSelection());
    m_acknowledge->setToolTip(tr("Choose one or more alarms in the table first."));
    m_acknowledgeAll->setEnabled(isAnyLeft);
    showRefusal();
    showTargets();
    if (m_resetPatience.isActive() && m_orders.situation().status && !hasAlarm(m_orders.situation()))
        checkReset();
}

void ActiveAlarmsCard::showRefusal()
{
    const auto &state = m_orders.controller().state();
    for (int slot = 1; slot <= values::activeAlarmCount; ++slot) {
        const auto &refusal = state.reading<Kind::Alarm>(slot).refusal;
        if (refusal && state.freshness({Kind::Alarm, quint16(slot)}) == Freshness::Refused)
            return setReason(widgets::refused(*refusal).note);
    }
    setReason({});
}

/// What each of the two orders will clear.
void ActiveAlarmsCard::showTargets()
{
    const auto &status = m_orders.situation().status;
    const QString active = activeNames();
    if (!status)
        m_resetTarget->setWords(tr("Whether there is an alarm is not known now."));
    else if (!status->hasAlarm())
        m_resetTarget->setWords(tr("There is no alarm to clear."));
    else if (active.isEmpty())
        m_resetTarget->setWords(tr("Clears the alarms whose causes are gone."));
    else
        m_resetTarget->setWords(tr("Clears, if the cause is gone: %1.").arg(active));
    if (!status)
        m_cancelTarget->setWords(tr("Whether there is an error is not known now."));
    else if (status->hasError())
        m_cancelTarget->setWords(tr("Clears the error message at the pendant, and no alarm."));
    else
        m_cancelTarget->setWords(tr("There is no error to clear."));
}

/// Codes and names of the alarms that the controller tells now, in a line.
QString ActiveAlarmsCard::activeNames() const
{
    QStringList parts;
    for (const auto &entry : m_log.alarms()) {
        if (isActive(entry.sighting) && entry.isInSlot)
            parts += QStringLiteral("%1 %2")
                         .arg(entry.sighting.alarm.alarm.code)
                         .arg(m_codec.decode(entry.sighting.alarm.alarm.name.bytes()));
    }
    return parts.join(QStringLiteral(", "));
}

QString ActiveAlarmsCard::stateSentence() const
{
    const auto &controller = m_orders.controller();
    if (controller.linkState() == LinkState::Disconnected)
        return tr("Not connected: nothing is known of the active alarms.");
    const auto freshness = controller.state().freshness({Kind::Alarm, 1});
    if (freshness == Freshness::Unknown)
        return tr("The alarms have not been read yet.");
    if (freshness == Freshness::Refused)
        return tr("The controller does not tell its alarms.");
    const int active =
        int(std::ranges::count_if(m_log.alarms(), [](const auto &entry) { return isActive(entry.sighting); }));
    if (freshness == Freshness::Stale)
        return tr("%n alarm(s) active when last seen.", nullptr, active);
    return active == 0 ? tr("No alarm is active.") : tr("%n alarm(s) active, the newest first.", nullptr, active);
}

void ActiveAlarmsCard::acknowledgeSelected()
{
    QList<values::AlarmWithTexts> seen;
    for (const QModelIndex &index : m_table->selectionModel()->selectedRows())
        seen += m_model->at(index.row()).sighting.alarm;
    m_log.acknowledge(seen);
}

void ActiveAlarmsCard::acknowledgeAll()
{
    QList<values::AlarmWithTexts> seen;
    for (const auto &entry : m_log.alarms())
        seen += entry.sighting.alarm;
    m_log.acknowledge(seen);
}

void ActiveAlarmsCard::reset()
{
    say({}, ui::Role::Text2);
    m_orders.send(protocol::ResetAlarm {}, {Act::ResetAlarm, activeNames()}, this,
        [this](const values::Result<void> &result) { onReset(result); });
}

void ActiveAlarmsCard::onReset(const values::Result<void> &result)
{
    if (!result)
        return say(
            ui::explain(Act::ResetAlarm, result.error(), m_orders.controller().profile().model), ui::Role::Amber);
    say(tr("Reset accepted. Reading the alarms…"), ui::Role::Text2);
    for (int slot = 1; slot <= values::activeAlarmCount; ++slot)
        m_orders.controller().poller().readNow({Kind::Alarm, quint16(slot)});
    m_resetPatience.start(resetPatience);
    refresh();
}

/// A reset is accepted even where a cause remains (reference §10.2): only the status tells.
void ActiveAlarmsCard::checkReset()
{
    m_resetPatience.stop();
    if (!m_orders.situation().status)
        return say(
            tr("Reset accepted. Whether an alarm is left is not known: the status cannot be read."), ui::Role::Amber);
    if (!hasAlarm(m_orders.situation()))
        return say(tr("Reset accepted. No alarm is active any more."), ui::Role::Text2);
    const QString active = activeNames();
    say(active.isEmpty() ? tr("▲ Accepted, still active: remove the cause first.")
                         : tr("▲ Accepted, still active: remove the cause first. Left are: %1.").arg(active),
        ui::Role::Amber);
}

void ActiveAlarmsCard::cancelError()
{
    say({}, ui::Role::Text2);
    const auto onReply = [this](const values::Result<void> &result) {
        if (result)
            say(tr("Cancel error accepted."), ui::Role::Text2);
        else
            say(ui::explain(Act::CancelError, result.error(), m_orders.controller().profile().model), ui::Role::Amber);
    };
    m_orders.send(protocol::CancelError {}, {Act::CancelError}, this, onReply);
}

void ActiveAlarmsCard::say(const QString &sentence, ui::Role role)
{
    m_outcome->setRole(role);
    m_outcome->setWords(sentence);
}

} // namespace pages
