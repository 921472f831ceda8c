// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "values/variable.h"
#include "variables/reference.h"
#include <variant>

namespace variables {

/// The value of a variable or register. The alternatives stand in the order of Kind. S variables are held with the room
/// of the longest; a controller with 16 bytes gets and gives the first 16 (reference §4.3).
using Value = std::variant<values::ByteVariable, values::IntegerVariable, values::DoubleVariable, values::RealVariable,
    values::StringVariable32, values::PositionVariable, values::BasePosition, values::ExternalPosition,
    values::Register>;
static_assert(std::variant_size_v<Value> == allKinds.size());

constexpr Kind kindOf(const Value &value) { return Kind(value.index()); }

template <Kind kind> using ValueOf = std::variant_alternative_t<std::size_t(kind), Value>;

/// As operator==, but a real that is no number is the same as itself.
[[nodiscard]] bool isSame(const Value &a, const Value &b);

/// The parts that P, BP and EX have in common; nullopt for the other kinds. A BP and an EX have no form, tool or frame.
[[nodiscard]] std::optional<values::Position> positionOf(const Value &value);
/// The value of this kind with these parts; `kind` is P, BP or EX. All eight axes stand in it.
[[nodiscard]] Value valueWith(Kind kind, values::Position position);
/// How many axes a position of this kind has at least: those of an arm, a base, a station.
constexpr int usualAxes(Kind kind) { return kind == Kind::P ? 6 : kind == Kind::BP ? 3 : 1; }
/// The types that a variable of this kind may have (reference §4.4).
[[nodiscard]] QList<values::PositionType> positionTypes(Kind kind);

} // namespace variables
