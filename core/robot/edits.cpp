// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "robot/edits.h"

namespace robot {

using values::Error;
using values::ErrorKind;
using values::Result;
using variables::Edit;
using variables::Reference;
using variables::Value;

namespace {

template <typename Item> Value valueOf(const Item &item) { return item; }
Value valueOf(const values::StringVariable16 &item)
{
    return values::StringVariable32 {values::FixedText<32> {item.value.bytes()}};
}

} // namespace

Edits::Edits(Orders &orders, const variables::Format &format, QObject *parent)
    : QObject {parent}, m_orders {orders}, m_format {format}
{
}

std::optional<Value> Edits::now(const Reference &variable) const
{
    return readingOf(m_orders.controller().state(), variable).value;
}

void Edits::stage(const Reference &variable, const Value &value)
{
    m_staged.stage(variable, value, now(variable));
    Q_EMIT changed();
}

void Edits::stage(const QList<variables::Difference> &differences)
{
    for (const auto &difference : differences)
        m_staged.stage(difference.variable, difference.value, now(difference.variable));
    Q_EMIT changed();
}

void Edits::discard(const Reference &variable)
{
    m_staged.discard(variable);
    Q_EMIT changed();
}

void Edits::discard(const QList<Reference> &variables)
{
    for (const Reference &variable : variables)
        m_staged.discard(variable);
    Q_EMIT changed();
}

void Edits::clear()
{
    m_staged.clear();
    Q_EMIT changed();
}

void Edits::undo()
{
    m_staged.undo();
    Q_EMIT changed();
}

void Edits::apply()
{
    QList<Reference> all;
    for (const Edit &edit : m_staged.toApply())
        all << edit.variable;
    apply(all);
}

void Edits::apply(const QList<Reference> &variables)
{
    if (m_isApplying || std::ranges::none_of(variables, [this](const auto &one) { return m_staged.find(one); }))
        return;
    m_isApplying = true;
    m_staged.beginBatch();
    m_left = variables;
    writeNext();
}

void Edits::writeNext()
{
    while (!m_left.isEmpty() && !m_staged.find(m_left.first()))
        m_left.removeFirst(); // discarded meanwhile
    if (m_left.isEmpty())
        return finish();
    const Reference variable = m_left.takeFirst();
    const Value value = m_staged.find(variable)->value;
    m_staged.setWriting(variable, now(variable));
    std::visit(
        [&](const auto &item) {
            using Item = std::decay_t<decltype(item)>;
            if constexpr (std::is_same_v<Item, values::StringVariable32>) {
                if (m_format.stringSize <= values::FixedText<16>::capacity)
                    return write(variable, values::StringVariable16 {values::FixedText<16> {item.value.bytes()}});
            }
            write(variable, item);
        },
        value);
    Q_EMIT changed();
}

template <typename Item> void Edits::write(const Reference &variable, const Item &item)
{
    const protocol::WriteItem<Item> request {instanceOf(variable), item};
    m_orders.send(request, orderOf(*m_staged.find(variable)), this, [this, variable](const Result<void> &result) {
        if (result)
            readBack<Item>(variable);
        else
            onWritten(variable, result.error());
    });
}

/// A write that was not done, or perhaps not.
void Edits::onWritten(const Reference &variable, const Error &error)
{
    if (error.kind == ErrorKind::NotSent) {
        m_staged.setNotSent(variable, error);
        m_left.clear(); // what stands against one stands against all
    } else if (error.kind == ErrorKind::Refused) {
        m_staged.setRefused(variable, error);
    } else {
        m_staged.setUnknown(variable, error);
    }
    step();
}

template <typename Item> void Edits::readBack(const Reference &variable)
{
    const protocol::ReadItem<Item> request {instanceOf(variable)};
    m_orders.read(request, this, [this, variable](const Result<Item> &item) {
        if (item) {
            note(m_orders.controller().poller(), variable, valueOf(*item));
            m_staged.setReadBack(variable, valueOf(*item));
        } else {
            m_staged.setUnknown(variable, item.error());
        }
        step();
    });
}

void Edits::step()
{
    Q_EMIT changed();
    writeNext();
}

void Edits::finish()
{
    m_isApplying = false;
    Q_EMIT changed();
    Q_EMIT applied();
}

quint16 Edits::instanceOf(const Reference &variable) const
{
    if (variable.kind == variables::Kind::M)
        return quint16(variable.number);
    return protocol::variableInstance(variable.number, m_orders.controller().profile().numbering);
}

Order Edits::orderOf(const Edit &edit) const
{
    const bool isRegister = edit.variable.kind == variables::Kind::M;
    return {isRegister ? Act::WriteRegister : Act::WriteVariable, toString(edit.variable),
        edit.was ? toText(*edit.was, m_format) : QString(), toText(edit.value, m_format)};
}

} // namespace robot
