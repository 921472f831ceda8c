// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "trend/measured.h"

#include "trend/moment.h"

namespace trend {

namespace {

template <robot::Kind kind> std::optional<Measured> measuredAs(const robot::RobotState &state, const Signal &signal)
{
    const auto &reading = state.reading<kind>(signal.topic.number);
    if (!reading.value || state.freshness(signal.topic) != robot::Freshness::Live)
        return std::nullopt;
    const auto found = quantity(*reading.value, signal.element);
    return found ? std::optional(Measured {toMoment(reading.clock), *found}) : std::nullopt;
}

using Measure = std::optional<Measured> (*)(const robot::RobotState &, const Signal &);

/// One function a kind, in the order of robot::Kind.
template <std::size_t... kinds> constexpr auto measures(std::index_sequence<kinds...>)
{
    return std::array<Measure, sizeof...(kinds)> {measuredAs<robot::Kind(kinds)>...};
}
constexpr auto measureOf = measures(std::make_index_sequence<robot::kindCount> {});

} // namespace

std::optional<Measured> measured(const robot::RobotState &state, const Signal &signal)
{
    return measureOf[std::size_t(signal.topic.kind)](state, signal);
}

QString axisName(const robot::RobotState &state, const Signal &signal)
{
    const auto topic = namesOf(signal);
    if (!topic || signal.element >= values::maxAxes)
        return {};
    const auto &names = state.reading<robot::Kind::AxisNames>(topic->number).value;
    return names ? QString::fromLatin1(names->names[signal.element].bytes()) : QString {};
}

QString label(const robot::RobotState &state, const Signal &signal) { return label(signal, axisName(state, signal)); }

} // namespace trend
