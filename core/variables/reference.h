// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "protocol/dialect.h"
#include "values/error.h"
#include <QHashFunctions>
#include <QStringView>
#include <array>

namespace variables {

/// What can be named, shown and edited by letter and number, in the order of the pendant's menus (reference §4).
enum class Kind {
    B, ///< Unsigned 8-bit.
    I, ///< Signed 16-bit.
    D, ///< Signed 32-bit.
    R, ///< Single-precision real.
    S, ///< Text.
    P, ///< Robot position.
    BP, ///< Base position.
    EX, ///< External axis position.
    M, ///< Register: raw 16-bit. Its instance is its number whatever the numbering is.
};
inline constexpr std::array allKinds {
    Kind::B, Kind::I, Kind::D, Kind::R, Kind::S, Kind::P, Kind::BP, Kind::EX, Kind::M};

/// P, BP and EX: a type and axes instead of one number or text.
constexpr bool isPosition(Kind kind) { return kind == Kind::P || kind == Kind::BP || kind == Kind::EX; }

/// "B", "BP", as on the pendant.
[[nodiscard]] QString letters(Kind kind);
/// The kind with these letters, any case; nullopt if there is none.
[[nodiscard]] std::optional<Kind> findKind(QStringView letters);
/// How many of a kind the controller has, from 0.
[[nodiscard]] int countOf(Kind kind, const protocol::Dialect &dialect);
/// How many of a kind can be written, from 0 (reference §4.2).
[[nodiscard]] int writableCountOf(Kind kind, const protocol::Dialect &dialect);

/// One variable or register by the name of the pendant.
struct Reference {
    Kind kind = Kind::B;
    int number = 0;

    auto operator<=>(const Reference &) const = default;
};
inline size_t qHash(const Reference &reference, size_t seed = 0)
{
    return qHashMulti(seed, int(reference.kind), reference.number);
}

/// "B007", "BP012".
[[nodiscard]] QString toString(const Reference &reference);

/// The numbers first..last of a kind, both included.
struct Range {
    Kind kind = Kind::B;
    int first = 0;
    int last = 0;

    bool operator==(const Range &) const = default;
};

/// "P012", "b 7", "B007": letters in any case, a decimal number. BadInput with a whole, translated sentence for
/// anything else and for what the controller does not have.
[[nodiscard]] values::Result<Reference> referenceFromText(QStringView text, const protocol::Dialect &dialect);
/// The same, and "D000..D099" or "D0..99".
[[nodiscard]] values::Result<Range> rangeFromText(QStringView text, const protocol::Dialect &dialect);

} // namespace variables
