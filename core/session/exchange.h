// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "protocol/packet.h"
#include "session/idpool.h"
#include "session/policy.h"
#include "session/retransmission.h"
#include "session/statistics.h"
#include <array>
#include <functional>
#include <random>
#include <vector>

namespace session {

/// Names one request from submit() to its end.
using Ticket = quint64;

/// How a request ended.
struct Ending {
    Ticket ticket;
    values::Result<protocol::Reply> reply; ///< Views the datagram it came in; an error is never a refusal's absence.
};

/// All decisions of a session and none of its devices: which request goes out when, what an answer belongs to, when to
/// repeat and when to give up. No socket, no timer, no clock; `now` is a parameter and must not run backwards.
///
/// It never sends a write, a start or a move twice. It never matches an answer by id alone, and gives no id to another
/// request while an answer may still come.
class Exchange
{
public:
    /// One try that is to leave now.
    struct Departure {
        Ticket ticket;
        quint16 command;
        QByteArrayView packet; ///< Valid until the next call.
    };

    Exchange(const Policy &policy, quint8 firstId, quint32 seed);

    /// Queues a request. It leaves with the next departures.
    Ticket submit(const protocol::Request &request, protocol::Effect effect, Priority priority, Time now);

    /// Withdraws a request: it does not leave any more, no try is repeated, no ending is told.
    void withdraw(Ticket ticket);

    /// The next try that may leave now; call until empty.
    [[nodiscard]] std::optional<Departure> depart(Time now);
    /// The departure just handed out did not leave this computer. Ends what may not be repeated as NotSent.
    [[nodiscard]] std::optional<Ending> departureFailed(const values::Error &error, Time now);
    /// The ending that `datagram` brings, if it is an answer to an open request.
    [[nodiscard]] std::optional<Ending> receive(QByteArrayView datagram, Time now);
    /// Requests whose time is over.
    [[nodiscard]] std::vector<Ending> expire(Time now);
    /// Ends everything: reads as NotSent or NoAnswer, what may have reached the controller as UnknownOutcome.
    [[nodiscard]] std::vector<Ending> abandon(Time now);

    /// When depart() or expire() should be called next; nullopt if nothing is open.
    [[nodiscard]] std::optional<Time> nextDeadline(Time now) const;

    [[nodiscard]] const Counters &counters() const { return m_counters; }
    [[nodiscard]] bool isIdle() const;

    /// Whether anybody still waits for a request; asked before each try. Set once, before the first request.
    std::function<bool(Ticket)> isWanted;
    /// A round trip was measured. Set once, before the first request.
    std::function<void(Time, quint16 command, std::chrono::microseconds)> onRoundTrip;
    /// A try was given up: it was repeated, or its request ended without an answer.
    std::function<void(Time, quint16 command)> onMiss;

private:
    struct Waiting {
        Ticket ticket;
        protocol::Request request;
        protocol::Effect effect;
        Priority priority;
        Time notBefore;
        int busyLeft;
    };
    struct Open {
        Waiting order;
        QByteArray packet {};
        quint8 id = 0;
        Time firstSent {};
        Time lastSent {};
        Time nextTry = Time::max(); ///< When to repeat.
        Time deadline {}; ///< When to give up.
        int tries = 0;
        bool isWithdrawn = false;
        QString sendTrouble {}; ///< Why the last try did not leave this computer.
    };

    std::optional<Departure> departAgain(Time now);
    std::optional<Departure> departFirst(Waiting &&order, quint8 id, Time now);
    std::array<Priority, priorityCount> turns(Time now) const;
    bool hasRoom(Time now) const;
    void countTowardsCeiling(Priority priority, Time now);
    void noteTry(Open &open, Time now);
    bool holdsWindow(const Open &open, Time now) const;
    int outstanding(Time now) const;
    bool waitForBusy(Open &open, const protocol::Reply &reply, Time now);
    void close(std::size_t index, Time now);
    void countStray(const protocol::Reply &reply);
    static values::Error silence(const Open &open);

    Policy m_policy;
    IdPool m_ids;
    Retransmission m_retransmission;
    std::minstd_rand m_random;
    std::array<std::deque<Waiting>, priorityCount> m_waiting;
    std::vector<Open> m_open;
    std::array<bool, 256> m_wasAnswered {}; ///< Tells a duplicate from a late answer.
    Counters m_counters;
    Time m_nextSlot {}; ///< The ceiling: nothing but stops leaves before.
    Time m_lastBackground {}; ///< When something of the background left last.
    Ticket m_lastTicket = 0;
    std::size_t m_departed = 0; ///< Index of the last departure in m_open.
};

} // namespace session
