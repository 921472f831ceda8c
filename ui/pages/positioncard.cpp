// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/pages/positioncard.h"

#include "ui/pages/controlgroups.h"
#include "ui/widgets/valuelabel.h"
#include "ui/words.h"
#include <QGridLayout>
#include <QPainter>

namespace pages {

using robot::Topic;
namespace topics = robot::topics;
using widgets::ValueLabel;

namespace {

constexpr int rowGap = 9;

ValueLabel *valueLabel(const QString &name, ui::Type type, const QString &reserve)
{
    auto *label = new ValueLabel(type);
    label->setObjectName(name);
    label->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    label->setTabular(true);
    label->setReserve(reserve);
    return label;
}

/// The word of one axis, for shown().
auto wordOf(int axis)
{
    return [axis](const values::Position &position) {
        return widgets::Word {
            axis < position.axes.count() ? ui::axisText(position.type, axis, position.axes[axis]) : widgets::dash()};
    };
}

int axesOf(const robot::Reading<values::Position> &reading) { return reading.value ? reading.value->axes.count() : 0; }

} // namespace

void PositionCard::Cell::setVisible(bool visible) const
{
    name->setVisible(visible);
    value->setVisible(visible);
    if (unit)
        unit->setVisible(visible);
}

PositionCard::PositionCard(const robot::RobotState &state, QWidget *parent)
    : Card(tr("Position"), parent), m_state {state}
{
    auto *grid = new QGridLayout;
    grid->setHorizontalSpacing(8);
    grid->setVerticalSpacing(rowGap);
    grid->setColumnStretch(1, 3);
    grid->setColumnStretch(5, 2);
    grid->setColumnMinimumWidth(3, 6);
    for (int axis = 0; axis < values::maxAxes; ++axis)
        addRow(grid, axis);
    body()->addLayout(grid);
    body()->addStretch();
    connect(&state, &robot::RobotState::changed, this, &PositionCard::onChanged);
    for (const Topic topic :
        {topics::baseAxisNames, topics::pulseAxisNames, topics::basePosition, topics::pulsePosition})
        onChanged(topic);
}

void PositionCard::addRow(QGridLayout *grid, int axis)
{
    using widgets::text;
    Cell &base = m_base[std::size_t(axis)];
    Cell &pulse = m_pulse[std::size_t(axis)];
    base = {text({}, ui::Type::Body, ui::Role::Text2),
        valueLabel(QStringLiteral("base%1").arg(axis + 1), ui::Type::Position, ui::millimetres(-8888888)),
        text({}, ui::Type::Body, ui::Role::Text3)};
    pulse = {text({}, ui::Type::Body, ui::Role::Text2),
        valueLabel(QStringLiteral("pulse%1").arg(axis + 1), ui::Type::Body, ui::pulses(-8888888)), nullptr};
    pulse.value->setRole(ui::Role::Text2);
    grid->addWidget(base.name, axis, 0);
    grid->addWidget(base.value, axis, 1);
    grid->addWidget(base.unit, axis, 2);
    grid->addWidget(pulse.name, axis, 4);
    grid->addWidget(pulse.value, axis, 5);
}

void PositionCard::paintEvent(QPaintEvent *event)
{
    Card::paintEvent(event);
    QPainter painter(this);
    painter.setPen(ui::color(ui::Role::Hairline, this));
    for (std::size_t axis = 1; axis < m_base.size(); ++axis) {
        const QWidget *value = m_base[axis].value->isVisible() ? m_base[axis].value : m_pulse[axis].value;
        const int y = value->geometry().top() - rowGap / 2 - 1;
        if (value->isVisible())
            painter.drawLine(ui::space::inside, y, width() - ui::space::inside, y);
    }
}

void PositionCard::onChanged(const robot::TopicRange &range)
{
    if (range.contains(topics::baseAxisNames))
        return showNames(m_base, m_state.baseAxisNames());
    if (range.contains(topics::pulseAxisNames))
        return showNames(m_pulse, m_state.pulseAxisNames());
    if (range.contains(topics::basePosition))
        showBase();
    else if (range.contains(topics::pulsePosition))
        showPulses();
    else
        return;
    showRows();
    showReason();
}

void PositionCard::showBase()
{
    const auto &reading = m_state.basePosition();
    const auto type = reading.value ? reading.value->type : values::PositionType::Base;
    for (int axis = 0; axis < values::maxAxes; ++axis) {
        const Cell &cell = m_base[std::size_t(axis)];
        cell.value->show(widgets::shown(reading, m_state.freshness(topics::basePosition), wordOf(axis)));
        cell.unit->setText(ui::axisUnit(type, axis));
    }
    setNote(reading.value ? tr("R1 · base frame, tool %1  ·  pulses").arg(reading.value->tool)
                          : tr("R1 · base frame  ·  pulses"));
}

void PositionCard::showPulses()
{
    for (int axis = 0; axis < values::maxAxes; ++axis)
        m_pulse[std::size_t(axis)].value->show(
            widgets::shown(m_state.pulsePosition(), m_state.freshness(topics::pulsePosition), wordOf(axis)));
}

/// Where the controller does not tell its names, axes are counted: a guessed name would look like a read one.
void PositionCard::showNames(const Column &column, const robot::Reading<values::AxisNames> &names)
{
    for (std::size_t axis = 0; axis < column.size(); ++axis) {
        const bool isNamed = names.value && !names.value->names[axis].isEmpty();
        const QString name =
            isNamed ? ui::controllerText(names.value->names[axis].bytes()) : tr("axis %1").arg(axis + 1);
        column[axis].name->setText(name);
        column[axis].value->setTitle(name);
    }
}

void PositionCard::showRows()
{
    const int base = axesOf(m_state.basePosition());
    const int pulse = axesOf(m_state.pulsePosition());
    for (int axis = 0; axis < values::maxAxes; ++axis) {
        m_base[std::size_t(axis)].setVisible(axis < (base > 0 ? base : usualAxes));
        m_pulse[std::size_t(axis)].setVisible(axis < (pulse > 0 ? pulse : usualAxes));
    }
}

void PositionCard::showReason()
{
    for (const Topic topic : {topics::basePosition, topics::pulsePosition}) {
        const auto &reading = topic == topics::basePosition ? m_state.basePosition() : m_state.pulsePosition();
        if (m_state.freshness(topic) == robot::Freshness::Refused && reading.refusal)
            return setReason(widgets::refused(*reading.refusal).note);
    }
    setReason({});
}

} // namespace pages
