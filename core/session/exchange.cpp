// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "session/exchange.h"

#include "protocol/codes.h"
#include <algorithm>

using protocol::Effect;
using values::Error;
using values::ErrorKind;

namespace session {

namespace {

constexpr Milliseconds backgroundTurn {50};

} // namespace

Exchange::Exchange(const Policy &policy, quint8 firstId, quint32 seed)
    : m_policy {policy},
      m_ids {firstId},
      m_retransmission {policy.timeout, policy.isAdaptive ? Milliseconds {20} : policy.timeout},
      m_random {seed}
{
    m_open.reserve(16);
}

Ticket Exchange::submit(const protocol::Request &request, Effect effect, Priority priority, Time now)
{
    const int busyLeft = effect == Effect::Reads ? m_policy.busyRepeats : 0;
    m_waiting[std::size_t(priority)].push_back({++m_lastTicket, request, effect, priority, now, busyLeft});
    return m_lastTicket;
}

void Exchange::withdraw(Ticket ticket)
{
    for (auto &queue : m_waiting)
        std::erase_if(queue, [ticket](const Waiting &order) { return order.ticket == ticket; });
    for (Open &open : m_open) {
        if (open.order.ticket == ticket) {
            open.isWithdrawn = true;
            open.nextTry = Time::max();
        }
    }
}

/// What is sent once may be answered late (servo on takes seconds); reading must not stand still for that.
bool Exchange::holdsWindow(const Open &open, Time now) const
{
    if (open.order.priority == Priority::Stop)
        return false;
    return protocol::isRepeatable(open.order.effect) || now - open.firstSent < m_policy.timeout;
}

int Exchange::outstanding(Time now) const
{
    return int(std::ranges::count_if(m_open, [&](const Open &open) { return holdsWindow(open, now); }));
}

bool Exchange::hasRoom(Time now) const { return m_nextSlot <= now && outstanding(now) < m_policy.window; }

/// Whatever leaves but a stop pushes the next slot away; a slot that was missed is not made up for.
void Exchange::countTowardsCeiling(Priority priority, Time now)
{
    if (m_policy.requestsPerSecond > 0 && priority != Priority::Stop)
        m_nextSlot = now + std::chrono::microseconds {1'000'000 / m_policy.requestsPerSecond};
}

/// Who goes first. On a link that pages fill, what waits in the background gets its turn all the same: else it would wait
/// as long as the page is in view.
std::array<Priority, priorityCount> Exchange::turns(Time now) const
{
    using enum Priority;
    const auto &background = m_waiting[std::size_t(Background)];
    const bool isDue = !background.empty() && background.front().notBefore + backgroundTurn <= now
        && m_lastBackground + backgroundTurn <= now;
    if (isDue)
        return {Stop, Control, Background, Page};
    return {Stop, Control, Page, Background};
}

std::optional<Exchange::Departure> Exchange::depart(Time now)
{
    if (m_waiting[std::size_t(Priority::Stop)].empty()) { // nothing of ours goes before a stop
        if (auto again = departAgain(now))
            return again;
    }
    const bool hasRoom = this->hasRoom(now);
    for (const Priority priority : turns(now)) {
        auto &queue = m_waiting[std::size_t(priority)];
        const auto next = std::ranges::find_if(queue, [&](const Waiting &order) {
            return order.priority == Priority::Stop || (hasRoom && order.notBefore <= now);
        });
        if (next == queue.end())
            continue;
        if (isWanted && !isWanted(next->ticket)) {
            queue.erase(next);
            return depart(now);
        }
        const auto id = next->priority == Priority::Stop ? m_ids.takeForStop(now) : m_ids.take(now);
        if (!id)
            return std::nullopt;
        Waiting order = std::move(*next);
        queue.erase(next);
        return departFirst(std::move(order), *id, now);
    }
    return std::nullopt;
}

std::optional<Exchange::Departure> Exchange::departAgain(Time now)
{
    const auto due = std::ranges::find_if(m_open, [now](const Open &open) { return open.nextTry <= now; });
    if (due == m_open.end())
        return std::nullopt;
    m_departed = std::size_t(due - m_open.begin());
    if (isWanted && !isWanted(due->order.ticket)) {
        withdraw(due->order.ticket);
        return departAgain(now);
    }
    ++m_counters.repeats;
    if (onMiss)
        onMiss(now, due->order.request.command);
    countTowardsCeiling(due->order.priority, now);
    noteTry(*due, now);
    return Departure {due->order.ticket, due->order.request.command, due->packet};
}

std::optional<Exchange::Departure> Exchange::departFirst(Waiting &&order, quint8 id, Time now)
{
    countTowardsCeiling(order.priority, now);
    if (order.priority == Priority::Background)
        m_lastBackground = now;
    m_wasAnswered[id] = false;
    Open open {.order = std::move(order), .id = id, .firstSent = now, .lastSent = now};
    open.packet = protocol::encode(open.order.request, {protocol::Division::Robot, false, id, 0});
    open.deadline = now + m_policy.patience(open.order.effect, open.order.priority);
    ++m_counters.requests;
    noteTry(open, now);
    m_departed = m_open.size();
    m_open.push_back(std::move(open));
    return Departure {m_open.back().order.ticket, m_open.back().order.request.command, m_open.back().packet};
}

/// One more try leaves. Only what may be repeated gets a time for another.
void Exchange::noteTry(Open &open, Time now)
{
    ++open.tries;
    open.lastSent = now;
    open.nextTry = Time::max();
    if (open.isWithdrawn || !protocol::isRepeatable(open.order.effect))
        return;
    const bool isStop = open.order.priority == Priority::Stop;
    const Time next = now + (isStop ? Time::duration {m_policy.stopRepeat} : m_retransmission.wait(open.tries));
    if (next < open.deadline)
        open.nextTry = next;
}

std::optional<Ending> Exchange::departureFailed(const Error &error, Time now)
{
    Open &open = m_open[m_departed];
    if (protocol::isRepeatable(open.order.effect)) {
        open.sendTrouble = error.detail; // a lost try like any other
        return std::nullopt;
    }
    Ending ending {open.order.ticket, tl::unexpected(Error {ErrorKind::NotSent, 0, 0, error.detail})};
    close(m_departed, now);
    return ending;
}

void Exchange::countStray(const protocol::Reply &reply)
{
    if (std::ranges::any_of(m_open, [&](const Open &open) { return open.id == reply.framing.id; }))
        ++m_counters.mismatched;
    else if (m_wasAnswered[reply.framing.id])
        ++m_counters.duplicates;
    else
        ++m_counters.late;
}

std::optional<Ending> Exchange::receive(QByteArrayView datagram, Time now)
{
    const auto reply = protocol::parseReply(datagram);
    if (!reply || reply->framing.division != protocol::Division::Robot) {
        ++m_counters.malformed;
        return std::nullopt;
    }
    const auto open = std::ranges::find_if(m_open, [&](const Open &candidate) {
        return candidate.id == reply->framing.id
            && protocol::replyService(candidate.order.request.service) == reply->service;
    });
    if (open == m_open.end()) {
        countStray(*reply);
        return std::nullopt;
    }
    ++m_counters.answers;
    if (open->tries == 1) {
        const auto roundTrip = std::chrono::duration_cast<std::chrono::microseconds>(now - open->lastSent);
        m_retransmission.measure(roundTrip);
        if (onRoundTrip)
            onRoundTrip(now, open->order.request.command, roundTrip);
    }
    m_wasAnswered[open->id] = true;
    const bool ends = !waitForBusy(*open, *reply, now) && !open->isWithdrawn;
    Ending ending {open->order.ticket, *reply};
    if (reply->isRefusal())
        ending.reply = tl::unexpected(reply->refusal());
    close(std::size_t(open - m_open.begin()), now);
    return ends ? std::optional {std::move(ending)} : std::nullopt;
}

/// A read that was answered "busy" goes back into its queue for a moment; true if it did.
bool Exchange::waitForBusy(Open &open, const protocol::Reply &reply, Time now)
{
    if (open.isWithdrawn || open.order.busyLeft == 0 || !reply.isRefusal() || !protocol::isBusy(reply.refusal()))
        return false;
    ++m_counters.busy;
    std::uniform_int_distribution<int> wait {int(m_policy.busyLeast.count()), int(m_policy.busyMost.count())};
    Waiting order = open.order;
    --order.busyLeft;
    order.notBefore = now + Milliseconds {wait(m_random)};
    m_waiting[std::size_t(order.priority)].push_back(std::move(order));
    return true;
}

Error Exchange::silence(const Open &open)
{
    if (!open.sendTrouble.isEmpty())
        return {ErrorKind::Network, 0, 0, open.sendTrouble};
    return {protocol::isRepeatable(open.order.effect) ? ErrorKind::NoAnswer : ErrorKind::UnknownOutcome, 0, 0, {}};
}

std::vector<Ending> Exchange::expire(Time now)
{
    std::vector<Ending> endings;
    for (std::size_t i = m_open.size(); i-- > 0;) {
        const Open &open = m_open[i];
        if (open.deadline > now)
            continue;
        ++m_counters.lost;
        if (onMiss)
            onMiss(now, open.order.request.command);
        if (!open.isWithdrawn)
            endings.push_back({open.order.ticket, tl::unexpected(silence(open))});
        close(i, now);
    }
    std::ranges::reverse(endings);
    return endings;
}

std::vector<Ending> Exchange::abandon(Time now)
{
    std::vector<Ending> endings;
    for (auto &queue : m_waiting) {
        for (const Waiting &order : queue)
            endings.push_back({order.ticket, values::failure(ErrorKind::NotSent)});
        queue.clear();
    }
    while (!m_open.empty()) {
        if (!m_open.back().isWithdrawn)
            endings.push_back({m_open.back().order.ticket, tl::unexpected(silence(m_open.back()))});
        close(m_open.size() - 1, now);
    }
    return endings;
}

void Exchange::close(std::size_t index, Time now)
{
    m_ids.rest(m_open[index].id, now + m_policy.idLinger);
    m_open.erase(m_open.begin() + std::ptrdiff_t(index));
}

std::optional<Time> Exchange::nextDeadline(Time now) const
{
    Time next = Time::max();
    for (const Open &open : m_open) {
        next = std::min({next, open.nextTry, open.deadline});
        if (!protocol::isRepeatable(open.order.effect) && open.firstSent + m_policy.timeout > now)
            next = std::min(next, open.firstSent + m_policy.timeout);
    }
    if (outstanding(now) >= m_policy.window)
        return next == Time::max() ? std::nullopt : std::optional {next}; // an answer or a deadline makes room first
    const Time nextId = m_ids.nextFree(now);
    for (const auto &queue : m_waiting) {
        for (const Waiting &order : queue) {
            next = std::min(next, std::max({order.notBefore, m_nextSlot, nextId, now}));
            if (order.notBefore <= now)
                break;
        }
    }
    return next == Time::max() ? std::nullopt : std::optional {next};
}

bool Exchange::isIdle() const
{
    return m_open.empty() && std::ranges::all_of(m_waiting, [](const auto &queue) { return queue.empty(); });
}

} // namespace session
