// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "protocol/requests.h"
#include "session/exchange.h"
#include "session/linkmeter.h"
#include "session/permit.h"
#include "session/transport.h"
#include <QPointer>
#include <QTimer>
#include <unordered_map>

namespace session {

/// A conversation with the robot port of one controller: typed orders in, typed answers out.
///
///     session.send(ReadStatus {}, this, [this](const values::Result<values::Status> &status) { … });
///
/// The handler runs exactly once, from the event loop and never from inside send(); it never runs after its context is
/// gone, and an order whose context is gone before it left is not sent at all. What may be repeated, and who goes
/// first, follows from the order's effect (see Exchange). Destroying the session ends everything silently.
class Session : public QObject
{
    Q_OBJECT

public:
    /// `transport` must outlive the session.
    Session(Transport &transport, const Policy &policy, QObject *parent = nullptr);

    template <protocol::TypedRequest R, typename Handler>
    requires(!protocol::needsPermit(R::effect)) void send(
        const R &order, QObject *context, Handler handler, Priority priority = usualPriority(R::effect))
    {
        enqueue(order.request(), R::effect, priority, context, typedHandler(order, std::move(handler)));
    }

    /// For what starts or moves: only with proof that the robot is armed now.
    template <protocol::TypedRequest R, typename Handler>
    requires(protocol::needsPermit(R::effect)) void send(
        const R &order, const Permit &, QObject *context, Handler handler)
    {
        enqueue(order.request(), R::effect, usualPriority(R::effect), context, typedHandler(order, std::move(handler)));
    }

    /// Ends every open request: see Exchange::abandon(). The handlers run from the event loop.
    void abandon();

    [[nodiscard]] LinkStatistics statistics() const;

    static constexpr Priority usualPriority(protocol::Effect effect)
    {
        switch (effect) {
        case protocol::Effect::Stops: return Priority::Stop;
        case protocol::Effect::Reads: return Priority::Page;
        default: return Priority::Control;
        }
    }

Q_SIGNALS:
    /// A write, start or move was not answered; its handler has been told. The status should be read now.
    void outcomeUnknown();

private:
    using RawHandler = std::function<void(const values::Result<protocol::Reply> &)>;
    struct Pending {
        QPointer<QObject> context;
        RawHandler handler;
    };

    template <typename R, typename Handler> static RawHandler typedHandler(const R &order, Handler &&handler)
    {
        return [order, handler = std::forward<Handler>(handler)](const values::Result<protocol::Reply> &reply) mutable {
            if (reply)
                handler(order.decode(reply->payload));
            else
                handler(values::Result<typename R::Reply> {tl::unexpected(reply.error())});
        };
    }

    void enqueue(const protocol::Request &request, protocol::Effect effect, Priority priority, QObject *context,
        RawHandler handler);
    void pump();
    void onReceived(QByteArrayView datagram);
    void onDeadline();
    void finish(const Ending &ending);
    void schedule(Time now);

    Transport &m_transport;
    Exchange m_exchange;
    LinkMeter m_meter;
    std::unordered_map<Ticket, Pending> m_pending;
    std::vector<Ending> m_due; ///< Endings that wait for the event loop.
    QTimer m_timer;
    Time m_armedFor = Time::max();
    quint64 m_strangers = 0;
};

} // namespace session
