// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "robot/iowrite.h"

#include <functional>

namespace robot {

using values::Error;
using values::ErrorKind;
using values::IoGroup;
using values::Result;

namespace {

QString bitsText(const IoGroup &group) { return QStringLiteral("0b%1").arg(group.bits, 8, 2, QChar(u'0')); }

} // namespace

IoWrite::IoWrite(Orders &orders, const names::Signal &signal, QObject *parent)
    : QObject {parent}, m_orders {orders}, m_signal {signal}
{
}

std::optional<IoGroup> IoWrite::after() const
{
    return m_before ? std::optional {m_before->with(m_signal.bit, m_isOn)} : std::nullopt;
}

void IoWrite::setOn(bool on)
{
    m_isOn = on;
    Q_EMIT changed();
}

void IoWrite::read()
{
    m_before.reset();
    set(Step::Reading);
    ask(&IoWrite::show);
}

void IoWrite::write()
{
    if (m_step != Step::Ready && m_step != Step::Changed)
        return;
    set(Step::Writing);
    ask(&IoWrite::send);
}

/// Reads the group; what was not read after it was written is unknown, else nothing was changed.
void IoWrite::ask(void (IoWrite::*take)(const IoGroup &))
{
    const bool isWritten = take == &IoWrite::compare;
    const protocol::ReadItem<IoGroup> request {quint16(m_signal.group)};
    m_orders.read(request, this, [this, take, isWritten](const Result<IoGroup> &group) {
        if (group)
            std::invoke(take, this, *group);
        else
            set(isWritten ? Step::Unknown : Step::Failed, group.error());
    });
}

void IoWrite::show(const IoGroup &group)
{
    m_before = group;
    m_isOn = !group.isOn(m_signal.bit);
    set(Step::Ready);
}

void IoWrite::send(const IoGroup &group)
{
    if (group != *m_before) {
        m_before = group;
        return set(Step::Changed);
    }
    m_sent = *after();
    const Order order {Act::WriteIo, toString(m_signal), bitsText(group), bitsText(m_sent)};
    m_orders.send(protocol::WriteItem<IoGroup> {quint16(m_signal.group), m_sent}, order, this,
        [this](const Result<void> &result) { onWritten(result); });
}

void IoWrite::onWritten(const Result<void> &result)
{
    if (result)
        return ask(&IoWrite::compare);
    switch (result.error().kind) {
    case ErrorKind::NotSent: return set(Step::Failed, result.error());
    case ErrorKind::Refused: return set(Step::Refused, result.error());
    default: return set(Step::Unknown, result.error());
    }
}

void IoWrite::compare(const IoGroup &group)
{
    m_readBack = group;
    m_orders.controller().poller().note<Kind::IoGroup>(m_signal.group, group);
    set(group == m_sent ? Step::Done : Step::Mismatch);
}

void IoWrite::set(Step step, const Error &error)
{
    m_step = step;
    m_error = error;
    Q_EMIT changed();
}

} // namespace robot
