// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/pages/motion/jogcard.h"

#include "ui/conditionwords.h"
#include "ui/widgets/jogpad.h"
#include "ui/widgets/orderbutton.h"
#include "ui/widgets/segments.h"
#include "ui/widgets/tickbox.h"
#include "variables/text.h"

namespace pages {

using motion::JogChoice;
using motion::JogFrame;
using motion::Limits;
using motion::StepEngine;
using robot::Kind;

namespace {

/// What can be chosen; the limits of the controller lower it.
struct StepRow {
    double length; ///< mm
    double angle; ///< degrees
    int pulses;
};
constexpr StepRow steps[] {{0.1, 0.1, 10}, {1, 1, 100}, {5, 5, 500}, {10, 5, 1000}};
constexpr motion::Speeds speeds[] {{2, 1, 0.5}, {10, 3, 1}, {50, 10, 2}, {250, 30, 5}};
constexpr int usualChoice = 1;

StepRow lowered(const StepRow &row, const Limits &limits)
{
    return {std::min(row.length, limits.stepLength), std::min(row.angle, limits.stepAngle),
        std::min(row.pulses, int(limits.stepPulses))};
}

motion::Speeds lowered(const motion::Speeds &row, const Limits &limits)
{
    return {std::min(row.tool, limits.toolSpeed), std::min(row.rotation, limits.rotationSpeed),
        std::min(row.joint, limits.jointSpeed)};
}

QString brief(double value) { return QLocale().toString(value, 'g', 4); }

} // namespace

JogCard::JogCard(const Context &context, robot::Jog &jog, QWidget *parent)
    : Card(tr("Jog"), parent),
      m_jog {jog},
      m_orders {context.station.orders},
      m_state {context.station.state()},
      m_step {new widgets::Segments(QStringLiteral("jogStep"), tr("Step"))},
      m_speed {new widgets::Segments(QStringLiteral("jogSpeed"), tr("Speed"))},
      m_frame {new widgets::Segments(QStringLiteral("jogFrame"), tr("Frame"))},
      m_pad {new widgets::JogPad},
      m_keys {new widgets::TickBox(tr("Keyboard too: hold Ctrl and Space on the button that has the focus"))},
      m_worst {widgets::sentence({}, ui::Role::Text1)},
      m_result {new widgets::Line(ui::Role::Text2, ui::Type::Body)}
{
    m_pad->setObjectName(QStringLiteral("jogPad"));
    m_keys->setObjectName(QStringLiteral("jogKeys"));
    m_worst->setObjectName(QStringLiteral("jogWorstCase"));
    m_result->setObjectName(QStringLiteral("jogResult"));
    addRow(tr("Frame"), m_frame);
    addRow(tr("Step"), m_step);
    addRow(tr("Speed"), m_speed);
    addRow(tr("Hold a button: one bounded step after another"), m_pad);
    body()->addWidget(m_keys);
    addRow(tr("After a lost link"), m_worst);
    addRow(tr("Last step"), m_result);
    body()->addStretch();
    m_frame->setChoices({tr("Base"), tr("Robot"), tr("Axes (pulses)")});
    for (auto *segments : {m_frame, m_step, m_speed})
        connect(segments, &widgets::Segments::changed, this, &JogCard::choose);
    connect(m_frame, &widgets::Segments::changed, this, &JogCard::showChoices);
    connect(m_pad, &widgets::JogPad::pressed, &jog, &robot::Jog::press);
    connect(m_pad, &widgets::JogPad::released, &jog, &robot::Jog::release);
    connect(m_keys, &QCheckBox::toggled, m_pad, &widgets::JogPad::setKeysAllowed);
    connect(&jog, &robot::Jog::changed, this, &JogCard::showState);
    connect(&context.station.orders, &robot::Orders::situationChanged, this, &JogCard::showState);
    connect(&m_state, &robot::RobotState::changed, this, [this](const robot::TopicRange &range) {
        if (range.kind == Kind::AxisNames)
            showAxes();
    });
    setGroup(m_group);
}

void JogCard::addRow(const QString &title, QWidget *widget)
{
    body()->addWidget(widgets::text(title, ui::Type::Label, ui::Role::Text2));
    body()->addWidget(widget);
}

JogFrame JogCard::frame() const { return m_group.instance > 8 ? JogFrame::Axes : JogFrame(m_frame->chosen()); }

void JogCard::setGroup(values::ControlGroup group)
{
    m_group = group;
    m_frame->setEnabled(group.instance <= 8);
    if (group.instance > 8)
        m_frame->choose(int(JogFrame::Axes));
    showChoices();
}

/// Lengths and angles, or pulses.
void JogCard::showChoices()
{
    const Limits limits = m_jog.limits().value_or(Limits {});
    const bool isAxes = frame() == JogFrame::Axes;
    QStringList stepWords;
    for (const StepRow &row : steps) {
        const StepRow step = lowered(row, limits);
        stepWords << (isAxes ? brief(step.pulses) : tr("%1 mm · %2°").arg(brief(step.length), brief(step.angle)));
    }
    QStringList speedWords;
    for (const motion::Speeds &row : speeds) {
        const motion::Speeds speed = lowered(row, limits);
        speedWords << (isAxes ? tr("%1 %").arg(brief(speed.joint))
                              : tr("%1 mm/s · %2 °/s").arg(brief(speed.tool), brief(speed.rotation)));
    }
    m_step->setChoices(stepWords, m_step->chosen() < 0 ? usualChoice : m_step->chosen());
    m_speed->setChoices(speedWords, m_speed->chosen() < 0 ? usualChoice : m_speed->chosen());
    showAxes();
    choose();
}

void JogCard::choose()
{
    const Limits limits = m_jog.limits().value_or(Limits {});
    const StepRow step = lowered(steps[m_step->chosen()], limits);
    m_jog.setChoice(
        {m_group, frame(), step.length, step.angle, step.pulses, lowered(speeds[m_speed->chosen()], limits)});
    m_worst->setText(worstCase());
    showState();
}

/// The controller's own names; the usual ones until they were read.
void JogCard::showAxes()
{
    const bool isAxes = frame() == JogFrame::Axes;
    const quint16 instance = isAxes ? m_group.instance : quint16(100 + m_group.instance);
    QStringList names;
    if (const auto &read = m_state.reading<Kind::AxisNames>(instance).value) {
        for (int axis = 0; axis < read->count(); ++axis)
            names << QString::fromLatin1(read->names[std::size_t(axis)].bytes());
    }
    const auto type = isAxes ? values::PositionType::Pulse : values::PositionType::Base;
    for (int axis = 0; names.size() < (m_group.instance > 8 ? 1 : 6); ++axis)
        names << variables::axisName(variables::Kind::P, type, axis);
    m_pad->setAxes(names);
}

QString JogCard::worstCase() const
{
    const JogChoice &choice = m_jog.choice();
    if (choice.frame == JogFrame::Axes)
        return tr("at most one step: %1 pulses").arg(choice.pulses);
    const double seconds = std::max(choice.length / choice.speeds.tool, choice.angle / choice.speeds.rotation);
    return tr("at most one step: %1 mm or %2°, in %3 s at most")
        .arg(brief(choice.length), brief(choice.angle), QLocale().toString(seconds, 'f', 1));
}

/// What forbids a step now; that it runs itself is none of it.
std::optional<robot::Condition> JogCard::obstacle() const
{
    const bool isJogging = m_jog.pressed() || m_jog.progress() != StepEngine::Progress::Idle;
    for (const robot::Finding &finding : m_orders.findings(robot::Act::Jog)) {
        if (finding.blocks() && !(isJogging && finding.condition == robot::Condition::NotRunning))
            return finding.condition;
    }
    return std::nullopt;
}

void JogCard::showState()
{
    m_pad->setEnabled(m_jog.limits() && !obstacle());
    m_result->setWords(stateText());
    const auto &reply = m_jog.lastReply();
    const bool isFine = m_jog.complaint().isEmpty() && (!reply || *reply) && m_jog.limits();
    m_result->setRole(isFine ? ui::Role::Text2 : ui::Role::Amber);
}

QString JogCard::stateText() const
{
    const auto model = m_orders.controller().profile().model;
    if (!m_jog.limits())
        return tr("Off: the profile has a motion limit that is no number above 0 (%1).")
            .arg(m_jog.limits().error().detail);
    if (!m_jog.complaint().isEmpty())
        return m_jog.complaint();
    if (const auto &reply = m_jog.lastReply(); reply && !*reply)
        return reply->error().kind == values::ErrorKind::UnknownOutcome
            ? tr("No answer to the step: whether it was taken is unknown. HOLD was sent. Look at the robot.")
            : ui::explain(robot::Act::Jog, reply->error(), model);
    switch (m_jog.progress()) {
    case StepEngine::Progress::Sent: return tr("Step sent…");
    case StepEngine::Progress::Moving: return tr("Moving…");
    case StepEngine::Progress::Idle: break;
    }
    if (m_jog.stepsSent() > 0)
        return tr("%n step(s), at rest.", nullptr, m_jog.stepsSent());
    const auto forbids = obstacle();
    return forbids ? ui::reason(*forbids, model) : tr("None yet.");
}

} // namespace pages
