// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "protocol/wire.h"
#include "values/error.h"
#include "values/position.h"
#include <QByteArray>
#include <array>

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
///   paddedElement(name, field)  the same, but some leave out the padding at its end
///   each(name, fields)          one element each, under one name
///   axes(name, words, type)     one element an axis; on reading, as many as the payload holds
///   eightAxes(name, words, type)  the same, but eight axis words always stand on the wire
///   optional()                  what follows may be missing from a payload, or be cut short
///   rest()                      further bytes may follow; nobody knows them
///   derived(name, function)     no bytes: something that follows from the fields, for people
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
    /// `payload` must outlive the reader.
    explicit Reader(QByteArrayView payload, int onlyElement = 0) : m_rest {payload}, m_cursor {onlyElement} { }
    explicit Reader(QByteArray &&payload, int onlyElement = 0) = delete;

    /// True if the element takes part and was there.
    template <typename Field> bool element(const char *, Field &field) { return m_cursor.next() && take(field); }

    template <typename Field> bool paddedElement(const char *name, Field &field)
    {
        m_isOptional = true;
        const bool isThere = element(name, field);
        m_isOptional = false;
        return isThere;
    }

    void each(const char *name, auto &fields)
    {
        for (auto &field : fields)
            element(name, field);
    }

    void axes(const char *name, values::AxisWords &words, values::PositionType)
    {
        takeAxes(name, words, int(std::min<qsizetype>(m_rest.size() / 4, values::maxAxes)));
    }
    void eightAxes(const char *name, values::AxisWords &words, values::PositionType)
    {
        takeAxes(name, words, values::maxAxes);
    }

    void optional() { m_isOptional = !m_cursor.isSingle(); }
    void rest() { m_rest = m_cursor.isSingle() ? m_rest : QByteArrayView {}; }
    void derived(const char *, auto) { }

    /// True if every element was there and no byte is left over.
    [[nodiscard]] bool isComplete() const { return !m_hasFailed && m_rest.isEmpty(); }
    /// How many elements were passed.
    [[nodiscard]] int index() const { return m_cursor.index(); }

private:
    void takeAxes(const char *name, values::AxisWords &words, int count)
    {
        words.resize(m_cursor.isSingle() ? values::maxAxes : count);
        for (int axis = 0; axis < words.count(); ++axis)
            element(name, words[axis]);
    }

    template <typename Field> bool take(Field &field)
    {
        constexpr auto size = Wire<Field>::size;
        if (m_rest.size() < size)
            return takeCut(field);
        field = Wire<Field>::load(m_rest.data());
        m_rest = m_rest.sliced(size);
        return true;
    }

    /// An element that the payload holds in part or not at all: zeros stand for what is missing.
    template <typename Field> bool takeCut(Field &field)
    {
        const bool isThere = m_isOptional && !m_rest.isEmpty();
        m_hasFailed |= !m_isOptional;
        if (isThere) {
            std::array<char, Wire<Field>::size> padded {};
            std::copy(m_rest.begin(), m_rest.end(), padded.begin());
            field = Wire<Field>::load(padded.data());
        }
        m_rest = {};
        return isThere;
    }

    QByteArrayView m_rest;
    ElementCursor m_cursor;
    bool m_isOptional = false;
    bool m_hasFailed = false;
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

    void paddedElement(const char *name, const auto &field) { element(name, field); }

    void each(const char *name, const auto &fields)
    {
        for (const auto &field : fields)
            element(name, field);
    }

    void axes(const char *name, const values::AxisWords &words, values::PositionType)
    {
        putAxes(name, words, m_cursor.isSingle() ? values::maxAxes : words.count());
    }
    void eightAxes(const char *name, const values::AxisWords &words, values::PositionType)
    {
        putAxes(name, words, values::maxAxes);
    }

    void optional() { }
    void rest() { }
    void derived(const char *, auto) { }

private:
    void putAxes(const char *name, const values::AxisWords &words, int count)
    {
        for (int axis = 0; axis < count; ++axis)
            element(name, words[axis]);
    }

    template <typename Field> void put(const Field &field)
    {
        const auto at = m_payload.size();
        m_payload.resize(at + Wire<Field>::size);
        Wire<Field>::store(field, m_payload.data() + at);
    }

    QByteArray &m_payload;
    ElementCursor m_cursor;
};

/// Counts the elements of a layout, and the bytes of a payload that holds them all with every axis.
class Measure
{
public:
    template <typename Field> void element(const char *, const Field &) { count(1, Wire<Field>::size); }
    void paddedElement(const char *name, const auto &field) { element(name, field); }
    template <typename Fields> void each(const char *, const Fields &fields)
    {
        count(int(fields.size()), Wire<typename Fields::value_type>::size);
    }
    void axes(const char *, const values::AxisWords &, values::PositionType) { count(values::maxAxes, 4); }
    void eightAxes(const char *, const values::AxisWords &, values::PositionType) { count(values::maxAxes, 4); }
    void optional() { }
    void rest() { }
    void derived(const char *, auto) { }

    int elements = 0;
    qsizetype bytes = 0;

private:
    void count(int fields, qsizetype each)
    {
        elements += fields;
        bytes += fields * each;
    }
};

/// How many elements `Value` has, and how many bytes at most: see Measure.
template <typename Value> [[nodiscard]] Measure measure()
{
    Measure measure;
    Value value;
    Layout<Value>::describe(measure, value);
    return measure;
}

/// The value in `payload`. `onlyElement` is the attribute of a single-element service: the other fields stay as they
/// are in a new value. Malformed if the payload is short or long.
template <typename Value> [[nodiscard]] values::Result<Value> decode(QByteArrayView payload, int onlyElement = 0)
{
    Value value;
    Reader reader {payload, onlyElement};
    Layout<Value>::describe(reader, value);
    if (!reader.isComplete())
        return values::failure(
            values::ErrorKind::Malformed, QStringLiteral("a payload of %1 bytes does not fit").arg(payload.size()));
    return value;
}

template <typename Value> [[nodiscard]] QByteArray encode(const Value &value, int onlyElement = 0)
{
    QByteArray payload;
    Writer writer {payload, onlyElement};
    Layout<Value>::describe(writer, value);
    return payload;
}

} // namespace protocol
