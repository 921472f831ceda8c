// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "variables/value.h"

#include <cmath>

namespace variables {

bool isSame(const Value &a, const Value &b)
{
    const auto *real = std::get_if<values::RealVariable>(&a);
    const auto *other = std::get_if<values::RealVariable>(&b);
    return a == b || (real && other && std::isnan(real->value) && std::isnan(other->value));
}

std::optional<values::Position> positionOf(const Value &value)
{
    if (const auto *position = std::get_if<values::PositionVariable>(&value))
        return position->position;
    values::Position position;
    if (const auto *base = std::get_if<values::BasePosition>(&value)) {
        position.type = base->type;
        position.axes = base->axes;
        return position;
    }
    if (const auto *external = std::get_if<values::ExternalPosition>(&value)) {
        position.type = external->type;
        position.axes = external->axes;
        return position;
    }
    return std::nullopt;
}

Value valueWith(Kind kind, values::Position position)
{
    position.axes.resize(values::maxAxes);
    if (kind == Kind::BP)
        return values::BasePosition {position.type, position.axes};
    if (kind == Kind::EX)
        return values::ExternalPosition {position.type, position.axes};
    return values::PositionVariable {position};
}

QList<values::PositionType> positionTypes(Kind kind)
{
    using enum values::PositionType;
    switch (kind) {
    case Kind::P: return {Pulse, Base, Robot, User, Tool};
    case Kind::BP: return {Pulse, Base};
    case Kind::EX: return {Pulse};
    default: return {};
    }
}

} // namespace variables
