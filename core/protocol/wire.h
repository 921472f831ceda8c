// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "values/fixedtext.h"
#include <QFlags>
#include <QtEndian>
#include <array>
#include <cstring>
#include <type_traits>

namespace protocol {

/// How one field stands on the wire: its size, and how to load and store it. Little-endian (reference §12, conflict 2).
template <typename Field> struct Wire;

template <typename Number>
requires std::is_arithmetic_v<Number>
struct Wire<Number> {
    static constexpr qsizetype size = sizeof(Number);
    static Number load(const char *from) { return qFromLittleEndian<Number>(from); }
    static void store(Number value, char *to) { qToLittleEndian(value, to); }
};

template <typename Enum>
requires std::is_enum_v<Enum>
struct Wire<Enum> {
    using Number = std::underlying_type_t<Enum>;
    static constexpr qsizetype size = sizeof(Number);
    static Enum load(const char *from) { return Enum(Wire<Number>::load(from)); }
    static void store(Enum value, char *to) { Wire<Number>::store(Number(value), to); }
};

template <typename Enum> struct Wire<QFlags<Enum>> {
    using Flags = QFlags<Enum>;
    static constexpr qsizetype size = sizeof(typename Flags::Int);
    static Flags load(const char *from) { return Flags::fromInt(qFromLittleEndian<typename Flags::Int>(from)); }
    static void store(Flags value, char *to) { qToLittleEndian(value.toInt(), to); }
};

template <qsizetype Size> struct Wire<values::FixedText<Size>> {
    static constexpr qsizetype size = Size;
    static values::FixedText<Size> load(const char *from)
    {
        return values::FixedText<Size> {QByteArrayView {from, Size}};
    }
    static void store(const values::FixedText<Size> &value, char *to) { memcpy(to, value.data(), size_t(Size)); }
};

/// Several numbers that make up one element.
template <typename Number, std::size_t Count> struct Wire<std::array<Number, Count>> {
    static constexpr qsizetype size = Wire<Number>::size * qsizetype(Count);
    static std::array<Number, Count> load(const char *from)
    {
        std::array<Number, Count> numbers;
        for (Number &number : numbers) {
            number = Wire<Number>::load(from);
            from += Wire<Number>::size;
        }
        return numbers;
    }
    static void store(const std::array<Number, Count> &numbers, char *to)
    {
        for (const Number number : numbers) {
            Wire<Number>::store(number, to);
            to += Wire<Number>::size;
        }
    }
};

} // namespace protocol
