// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "session/idpool.h"
#include "session/statistics.h"
#include "session/transfer.h"
#include "session/transport.h"
#include <QPointer>
#include <QTimer>
#include <functional>
#include <random>

namespace session {

/// A conversation with the file port of one controller: one transfer at a time, the others wait in their order.
///
/// A handler runs exactly once, from the event loop and never from inside the call that gave it; it never runs after
/// its context is gone, which also ends its transfer at the next block border.
class FileSession : public QObject
{
    Q_OBJECT

public:
    using TransferId = quint64;
    /// Bytes done, and all bytes of a load (0 for the others, whose size nobody knows). Called after each block.
    using Progress = std::function<void(qint64 done, qint64 total)>;
    using ContentHandler = std::function<void(const values::Result<QByteArray> &)>;
    using ListHandler = std::function<void(const values::Result<protocol::FileList> &)>;
    using DoneHandler = std::function<void(const values::Result<void> &)>;

    /// `transport` must outlive the session.
    FileSession(Transport &transport, const FilePolicy &policy, QObject *parent = nullptr);
    ~FileSession() override;

    /// `pattern` such as "*.JBI". An empty list is a result, not an error, in whichever form the controller says it.
    TransferId list(QByteArrayView pattern, QObject *context, ListHandler handler);
    /// Controller to computer. Nothing is handed out before the last block has come.
    TransferId save(const values::FileName &name, QObject *context, ContentHandler handler, Progress progress = {});
    /// Computer to controller. BadInput for an empty file, which HSES cannot carry. UnknownOutcome if the last block
    /// was not acknowledged.
    TransferId load(const values::FileName &name, const QByteArray &content, QObject *context, DoneHandler handler,
        Progress progress = {});
    /// Sent once; UnknownOutcome without an answer.
    TransferId remove(const values::FileName &name, QObject *context, DoneHandler handler);

    /// Ends a transfer, at the next block border if it is under way; its handler is told Cancelled, unless it was too
    /// late.
    void cancel(TransferId transfer);

    [[nodiscard]] const Counters &counters() const { return m_counters; }

private:
    struct Order {
        TransferId id;
        protocol::Request request;
        QByteArray upload;
        QPointer<QObject> context;
        ContentHandler handler;
        Progress progress;
        Time notBefore {};
        int busyLeft = 0;
    };

    TransferId enqueue(protocol::Request request, const QByteArray &upload, QObject *context, ContentHandler handler,
        Progress progress);
    void startNext();
    void onReceived(QByteArrayView datagram);
    void onTimer();
    void act(const Transfer::Step &step);
    void finish(const values::Result<QByteArray> &result);
    void restId(bool isAnswered);
    bool waitForBusy(const values::Error &error);
    bool acknowledgeAgain(const protocol::Reply &reply);
    void send(const QByteArray &packet);
    void tell(const Order &order, const values::Result<QByteArray> &result);
    void tellLater(Order &&order, const values::Error &error);
    void arm(Time at);

    Transport &m_transport;
    FilePolicy m_policy;
    Retransmission m_retransmission;
    IdPool m_ids;
    std::minstd_rand m_random;
    std::deque<Order> m_orders; ///< The first one is under way if m_transfer is there.
    std::optional<Transfer> m_transfer;
    QByteArray m_lastAcknowledgement; ///< Of the last finished save or list; empty after a load.
    Counters m_counters;
    QTimer m_timer;
    TransferId m_lastId = 0;
};

} // namespace session
