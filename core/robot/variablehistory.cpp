// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "robot/variablehistory.h"

namespace robot {

VariableHistory::VariableHistory(const RobotState &state, QObject *parent) : QObject {parent}, m_state {state}
{
    connect(&state, &RobotState::changed, this, &VariableHistory::onChanged);
}

void VariableHistory::onChanged(const TopicRange &range)
{
    const auto kind = variableKindOf(range.kind);
    if (!kind)
        return;
    for (int number = range.first; number <= range.last; ++number)
        look({*kind, number});
    Q_EMIT changed({*kind, range.first, range.last});
}

void VariableHistory::look(const variables::Reference &variable)
{
    const VariableReading reading = readingOf(m_state, variable);
    if (!reading.value)
        return;
    VariablePast &past = m_past[variable];
    if (past.latest && !variables::isSame(*past.latest, *reading.value)) {
        past.previous = past.latest;
        past.changed = reading.clock;
    }
    past.latest = reading.value;
}

} // namespace robot
