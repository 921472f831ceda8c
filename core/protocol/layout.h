// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "protocol/wire.h"
#include "values/error.h"
#include "values/position.h"
#include <QByteArray>

namespace protocol {

/// Where a payload is described, once: a specialisation for each value lists its elements in the order of the
/// reference.
///
///     template <> struct Layout<values::Something> {
///         static void describe(auto &visit, auto &value)
///         {
///             visit.element("alarm_code", value.code); // attribute 1
///             visit.element("time", value.time);       // attribute 2
///         }
///     };
///
/// The reader, the writer, the field tree and the virtual controller are visitors of it, so an offset is never written
/// down. Names are those of `pendeskctl decode`. A visitor has:
///   element(name, field)        one element, one attribute number
///   axes(name, AxisWords &)     one element an axis; on reading, as many as the payload holds
///   optional()                  what follows may be missing from a reply
template <typename Value> struct Layout;

template <typename Value>
concept Described = requires
{
    sizeof(Layout<std::remove_const_t<Value>>);
};

/// Counts the elements before the current one, and selects a single one for the "single" services.
class ElementCursor
{
public:
    /// `only` is the attribute of a single-element service, or 0 for all elements.
    constexpr explicit ElementCursor(int only) : m_only {only} { }

    /// Steps to the next element; true if it takes part.
    constexpr bool next() { return ++m_index == m_only || m_only == 0; }
    [[nodiscard]] constexpr int index() const { return m_index; }
    [[nodiscard]] constexpr bool isSingle() const { return m_only != 0; }

private:
    int m_only;
    int m_index = 0;
};

/// Reads a payload into a value. Nothing is allocated.
class Reader
{
public:
    explicit Reader(QByteArrayView payload, int onlyElement = 0) : m_rest {payload}, m_cursor {onlyElement} { }

    template <typename Field> void element(const char *, Field &field)
    {
        if (m_cursor.next())
            take(field);
    }

    void axes(const char *, values::AxisWords &words)
    {
        const bool single = m_cursor.isSingle();
        words.resize(single ? values::maxAxes : int(std::min<qsizetype>(m_rest.size() / 4, values::maxAxes)));
        for (int axis = 0; axis < words.count(); ++axis) {
            if (m_cursor.next())
                take(words[axis]);
        }
    }

    void optional() { m_optional = true; }

    /// True if every element was there and no byte is left over.
    [[nodiscard]] bool isComplete() const { return !m_failed && m_rest.isEmpty(); }

private:
    template <typename Field> void take(Field &field)
    {
        constexpr auto size = Wire<Field>::size;
        if (m_rest.size() >= size) {
            field = Wire<Field>::load(m_rest.data());
            m_rest = m_rest.sliced(size);
        } else {
            m_failed |= !m_optional;
            m_rest = {};
        }
    }

    QByteArrayView m_rest;
    ElementCursor m_cursor;
    bool m_optional = false;
    bool m_failed = false;
};

/// Appends a value to a payload.
class Writer
{
public:
    explicit Writer(QByteArray &payload, int onlyElement = 0) : m_payload {payload}, m_cursor {onlyElement} { }

    template <typename Field> void element(const char *, const Field &field)
    {
        if (m_cursor.next())
            put(field);
    }

    void axes(const char *, const values::AxisWords &words)
    {
        for (int axis = 0; axis < (m_cursor.isSingle() ? values::maxAxes : words.count()); ++axis) {
            if (m_cursor.next())
                put(words[axis]);
        }
    }

    void optional() { }

private:
    template <typename Field> void put(const Field &field)
    {
        const auto at = m_payload.size();
        m_payload.resize(at + Wire<Field>::size);
        Wire<Field>::store(field, m_payload.data() + at);
    }

    QByteArray &m_payload;
    ElementCursor m_cursor;
};

/// The value in `payload`. `onlyElement` is the attribute of a single-element service: the other fields stay as they
/// are in a new value. Malformed if the payload is short or long.
template <Described Value> [[nodiscard]] values::Result<Value> decode(QByteArrayView payload, int onlyElement = 0)
{
    Value value;
    Reader reader {payload, onlyElement};
    Layout<Value>::describe(reader, value);
    if (!reader.isComplete())
        return values::failure(
            values::ErrorKind::Malformed, QStringLiteral("a payload of %1 bytes does not fit").arg(payload.size()));
    return value;
}

template <Described Value> [[nodiscard]] QByteArray encode(const Value &value, int onlyElement = 0)
{
    QByteArray payload;
    Writer writer {payload, onlyElement};
    Layout<Value>::describe(writer, value);
    return payload;
}

} // namespace protocol
