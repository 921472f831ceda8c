// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "protocol/effect.h"
#include "protocol/payloads.h"
#include "protocol/plural.h"

namespace protocol {

/// A typed order to the robot port: it knows its bytes, its effect and the value that answers it.
template <typename R>
concept TypedRequest = requires(const R &request, QByteArrayView payload)
{
    typename R::Reply;
    {
        R::effect
        } -> std::convertible_to<Effect>;
    {
        request.request()
        } -> std::same_as<Request>;
    {
        request.decode(payload)
        } -> std::same_as<values::Result<typename R::Reply>>;
};

/// Reads every element of a payload.
template <quint16 command, typename Value, quint8 attribute = 0> struct ReadAll {
    using Reply = Value;
    static constexpr auto effect = Effect::Reads;
    quint16 instance = 1;

    [[nodiscard]] Request request() const { return {command, instance, attribute, Service::GetAll}; }
    [[nodiscard]] values::Result<Value> decode(QByteArrayView payload) const
    {
        return protocol::decode<Value>(payload);
    }
};

/// Reads one element. The other fields of the reply are as in a new value.
template <quint16 command, typename Value> struct ReadElement {
    using Reply = Value;
    static constexpr auto effect = Effect::Reads;
    quint16 instance = 1;
    quint8 attribute = 1; ///< In the order of the layout, from 1.

    [[nodiscard]] Request request() const { return {command, instance, attribute, Service::GetSingle}; }
    [[nodiscard]] values::Result<Value> decode(QByteArrayView payload) const
    {
        return protocol::decode<Value>(payload, attribute);
    }
};

/// What answers an order that carries no data back.
struct Acknowledged {
    using Reply = void;

    /// The status has been looked at; Malformed if there is a payload all the same.
    [[nodiscard]] values::Result<void> decode(QByteArrayView payload) const
    {
        if (!payload.isEmpty())
            return values::failure(values::ErrorKind::Malformed, QStringLiteral("a payload where none belongs"));
        return {};
    }
};

/// Writes every element of a payload.
template <quint16 command, typename Value, quint8 attribute = 0, Effect kind = Effect::Writes>
struct WriteAll : Acknowledged {
    static constexpr auto effect = kind;
    quint16 instance = 1;
    Value value;

    WriteAll(quint16 instanceToWrite, Value newValue) : instance {instanceToWrite}, value {std::move(newValue)} { }
    [[nodiscard]] Request request() const { return {command, instance, attribute, Service::SetAll, encode(value)}; }
};

/// Writes one element and leaves the others alone.
template <quint16 command, typename Value> struct WriteElement : Acknowledged {
    static constexpr auto effect = Effect::Writes;
    quint16 instance;
    Value value;
    quint8 attribute; ///< Which field of `value` is written.

    WriteElement(quint16 instanceToWrite, Value newValue, quint8 element = 1)
        : instance {instanceToWrite}, value {std::move(newValue)}, attribute {element}
    {
    }
    [[nodiscard]] Request request() const
    {
        return {command, instance, attribute, Service::SetSingle, encode(value, attribute)};
    }
};

/// The error of a plural request that the rule does not allow.
template <typename Item> [[nodiscard]] values::Result<void> checkCount(qsizetype count)
{
    if (count >= 0 && pluralRule<Item>().allows(quint32(count)))
        return {};
    return values::badInput(QStringLiteral("%1 items do not go into a packet").arg(count));
}

/// Reads several items in a row.
template <quint16 command, typename Item> class ReadPlural
{
public:
    using Reply = QList<Item>;
    static constexpr auto effect = Effect::Reads;

    /// BadInput if the count rule of the command does not allow `count`.
    static values::Result<ReadPlural> create(quint16 first, int count)
    {
        return checkCount<Item>(count).map([=] { return ReadPlural {first, quint32(count)}; });
    }

    [[nodiscard]] Request request() const
    {
        return {command, m_first, 0, Service::ReadPlural, encodePlural<Item>(m_count)};
    }
    [[nodiscard]] values::Result<QList<Item>> decode(QByteArrayView payload) const
    {
        return decodePlural<Item>(payload, m_count);
    }

private:
    ReadPlural(quint16 first, quint32 count) : m_first {first}, m_count {count} { }

    quint16 m_first;
    quint32 m_count;
};

/// Writes several items in a row.
template <quint16 command, typename Item> class WritePlural
{
public:
    using Reply = void;
    static constexpr auto effect = Effect::Writes;

    /// BadInput if the count rule of the command does not allow so many items.
    static values::Result<WritePlural> create(quint16 first, QList<Item> items)
    {
        return checkCount<Item>(items.size()).map([&] { return WritePlural {first, std::move(items)}; });
    }

    [[nodiscard]] Request request() const
    {
        return {command, m_first, 0, Service::WritePlural, encodePlural(quint32(m_items.size()), m_items)};
    }
    /// The count, or nothing (reference §12, conflict 46).
    [[nodiscard]] values::Result<void> decode(QByteArrayView payload) const
    {
        if (payload.isEmpty() || payload == encodePlural<Item>(quint32(m_items.size())))
            return {};
        return values::failure(values::ErrorKind::Malformed, QStringLiteral("another count than was written"));
    }

private:
    WritePlural(quint16 first, QList<Item> items) : m_first {first}, m_items {std::move(items)} { }

    quint16 m_first;
    QList<Item> m_items;
};

/// Executes a single-word control command (reference §6).
template <quint16 command, quint16 instance, quint32 word, Effect kind> struct Control : Acknowledged {
    static constexpr auto effect = kind;

    [[nodiscard]] Request request() const
    {
        return {command, instance, 1, Service::SetSingle, encode(values::ControlWord {word})};
    }
};

} // namespace protocol
