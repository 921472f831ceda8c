// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "robot/variables.h"

namespace robot {

using variables::Reference;

namespace {

/// In the order of variables::Kind.
constexpr std::array kinds {Kind::ByteVariable, Kind::IntegerVariable, Kind::DoubleVariable, Kind::RealVariable,
    Kind::StringVariable, Kind::PositionVariable, Kind::BasePosition, Kind::ExternalPosition, Kind::Register};
static_assert(kinds.size() == variables::allKinds.size());

template <std::size_t... index>
VariableReading read(const RobotState &state, const Reference &variable, std::index_sequence<index...>)
{
    VariableReading result;
    const auto take = [&](const auto &reading) {
        if (reading.value)
            result.value = *reading.value;
        result.clock = reading.clock;
        result.refusal = reading.refusal;
    };
    ((std::size_t(variable.kind) == index ? take(state.reading<kinds[index]>(variable.number)) : void()), ...);
    result.freshness = state.freshness(topicOf(variable));
    return result;
}

template <std::size_t... index>
void note(Poller &poller, int number, const variables::Value &value, std::index_sequence<index...>)
{
    ((value.index() == index ? poller.note<kinds[index]>(number, std::get<index>(value)) : void()), ...);
}

} // namespace

Topic topicOf(const Reference &variable) { return {kinds[std::size_t(variable.kind)], quint16(variable.number)}; }

std::optional<variables::Kind> variableKindOf(Kind kind)
{
    const auto found = std::ranges::find(kinds, kind);
    return found == kinds.end() ? std::nullopt : std::optional {variables::Kind(found - kinds.begin())};
}

VariableReading readingOf(const RobotState &state, const Reference &variable)
{
    return read(state, variable, std::make_index_sequence<kinds.size()> {});
}

void note(Poller &poller, const Reference &variable, const variables::Value &value)
{
    if (value.index() == std::size_t(variable.kind))
        note(poller, variable.number, value, std::make_index_sequence<kinds.size()> {});
}

variables::Format formatOf(const settings::Profile &profile)
{
    return {QLocale(), protocol::TextCodec {profile.encoding}, profile.dialect().stringSize, variables::Base::Decimal};
}

} // namespace robot
