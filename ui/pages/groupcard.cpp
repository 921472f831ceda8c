// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/pages/groupcard.h"

#include "ui/pages/controlgroups.h"
#include "ui/widgets/valuegrid.h"
#include "ui/words.h"

namespace pages {

using robot::Kind;
using robot::Topic;

namespace {

/// What was is this computer's own knowledge, and never stale.
widgets::Shown bound(const values::Position &position, int axis, qint32 word)
{
    return {{ui::axisText(position.type, axis, word)}, robot::Freshness::Live, {}};
}

} // namespace

GroupCard::GroupCard(const QString &title, const robot::RobotState &state, QWidget *parent)
    : Card(title, parent), m_state {state}
{
    connect(&state, &robot::RobotState::changed, this, [this](const robot::TopicRange &range) {
        take(range);
        onChanged(range);
    });
}

void GroupCard::setGroup(values::ControlGroup group)
{
    m_group = group;
    showAll();
}

void GroupCard::resetExtremes()
{
    m_extremes.clear();
    if (position().value && m_state.freshness(positionTopic()) == robot::Freshness::Live)
        m_extremes[positionInstance()].include(position().value->axes);
    showAll();
}

/// Every group's extremes are kept, whichever is shown.
void GroupCard::take(const robot::TopicRange &range)
{
    if (range.kind != Kind::Position)
        return;
    for (int number = range.first; number <= range.last; ++number) {
        const auto &reading = m_state.reading<Kind::Position>(number);
        if (reading.value && m_state.freshness({Kind::Position, quint16(number)}) == robot::Freshness::Live)
            m_extremes[quint16(number)].include(reading.value->axes);
    }
}

int GroupCard::axisCount() const { return position().value ? position().value->axes.count() : usualAxes; }

void GroupCard::nameRows(widgets::ValueGrid &grid, bool withUnits) const
{
    const auto &names = m_state.reading<Kind::AxisNames>(positionInstance()).value;
    const auto type = positionInstance() > 100 ? values::PositionType::Base : values::PositionType::Pulse;
    for (int axis = 0; axis < values::maxAxes; ++axis) {
        const bool isNamed = names && !names->names[std::size_t(axis)].isEmpty();
        const QString name =
            isNamed ? ui::controllerText(names->names[std::size_t(axis)].bytes()) : tr("axis %1").arg(axis + 1);
        grid.setRowName(axis, name, withUnits ? ui::axisUnit(type, axis) : QString());
    }
}

void GroupCard::showExtremes(widgets::ValueGrid &grid, int lowestColumn)
{
    for (int axis = 0; axis < values::maxAxes; ++axis) {
        const auto &bounds = extremes()[axis];
        const bool isKnown = bounds && position().value;
        grid.show(axis, lowestColumn, isKnown ? bound(*position().value, axis, bounds->lowest) : widgets::unknown());
        grid.show(
            axis, lowestColumn + 1, isKnown ? bound(*position().value, axis, bounds->highest) : widgets::unknown());
    }
}

} // namespace pages
