// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "session/session.h"

#include <QRandomGenerator>

namespace session {

Session::Session(Transport &transport, const Policy &policy, QObject *parent)
    : QObject {parent},
      m_transport {transport},
      m_exchange {policy, quint8(QRandomGenerator::global()->bounded(256)), QRandomGenerator::global()->generate()}
{
    m_exchange.isWanted = [this](Ticket ticket) {
        const auto pending = m_pending.find(ticket);
        if (pending == m_pending.end())
            return false;
        if (pending->second.context)
            return true;
        m_pending.erase(pending);
        return false;
    };
    m_exchange.onRoundTrip = [this](Time at, quint16 command, std::chrono::microseconds roundTrip) {
        m_meter.roundTrip(at, command, roundTrip);
    };
    m_exchange.onMiss = [this](Time at, quint16 command) { m_meter.miss(at, command); };
    m_timer.setSingleShot(true);
    m_timer.setTimerType(Qt::PreciseTimer);
    connect(&m_timer, &QTimer::timeout, this, &Session::onDeadline);
    connect(&transport, &Transport::received, this, &Session::onReceived);
    connect(&transport, &Transport::receivedFromStranger, this, [this] { ++m_strangers; });
}

void Session::enqueue(
    const protocol::Request &request, protocol::Effect effect, Priority priority, QObject *context, RawHandler handler)
{
    Q_ASSERT(context);
    const Ticket ticket = m_exchange.submit(request, effect, priority, now());
    m_pending.emplace(ticket, Pending {context, std::move(handler)});
    pump();
}

/// Lets everything leave that may leave now. Never runs a handler.
void Session::pump()
{
    const Time at = now();
    while (const auto departure = m_exchange.depart(at)) {
        m_meter.sent(at, departure->command);
        if (const auto sent = m_transport.send(departure->packet); !sent) {
            if (auto ending = m_exchange.departureFailed(sent.error(), at))
                m_due.push_back(*ending);
        }
    }
    schedule(at);
}

/// Arms the one timer for the next deadline. A timer that fires too early costs less than moving it with every request.
void Session::schedule(Time at)
{
    const auto next = m_due.empty() ? m_exchange.nextDeadline(at) : at;
    if (!next || (m_timer.isActive() && m_armedFor <= *next))
        return;
    m_armedFor = *next;
    m_timer.start(std::chrono::ceil<Milliseconds>(std::max(*next - at, Time::duration::zero())));
}

void Session::onDeadline()
{
    m_armedFor = Time::max();
    for (const Ending &ending : std::exchange(m_due, {}))
        finish(ending);
    for (const Ending &ending : m_exchange.expire(now()))
        finish(ending);
    pump();
}

void Session::onReceived(QByteArrayView datagram)
{
    const auto ending = m_exchange.receive(datagram, now());
    if (ending)
        finish(*ending);
    pump();
}

void Session::finish(const Ending &ending)
{
    auto pending = m_pending.extract(ending.ticket);
    if (ending.reply || ending.reply.error().kind == values::ErrorKind::Refused)
        m_meter.answer(now());
    if (!pending.empty() && pending.mapped().context)
        pending.mapped().handler(ending.reply);
    if (!ending.reply && ending.reply.error().kind == values::ErrorKind::UnknownOutcome)
        Q_EMIT outcomeUnknown();
}

void Session::abandon()
{
    for (Ending &ending : m_exchange.abandon(now()))
        m_due.push_back(std::move(ending));
    schedule(now());
}

LinkStatistics Session::statistics() const
{
    LinkStatistics statistics = m_meter.statistics(now());
    statistics.counters = m_exchange.counters();
    statistics.counters.strangers = m_strangers;
    return statistics;
}

} // namespace session
