// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "session/transfer.h"

using protocol::BlockCollector;
using protocol::Reply;
using protocol::Service;
using values::ErrorKind;

namespace session {

Transfer::Transfer(
    protocol::Request request, quint8 id, const FilePolicy &policy, Retransmission &retransmission, QByteArray upload)
    : m_request {std::move(request)},
      m_id {id},
      m_policy {policy},
      m_retransmission {retransmission},
      m_upload {std::move(upload)},
      m_collector {protocol::sizeLimit(m_request)}
{
    Q_ASSERT(isLoad() == !m_upload.isEmpty());
    if (isLoad())
        m_blockCount = protocol::blockCount(m_upload, m_policy.blockSize);
}

QByteArray Transfer::start(Time now)
{
    m_markedAt = now;
    return send(protocol::encodeFileRequest(m_request, m_id), now).packet;
}

Transfer::Step Transfer::send(const QByteArray &packet, Time now)
{
    m_packet = packet;
    m_tries = 1;
    m_sentAt = now;
    m_nextTry = now + m_retransmission.wait(1);
    return {packet, {}};
}

void Transfer::measure(Time now)
{
    if (m_tries == 1)
        m_retransmission.measure(std::chrono::duration_cast<Retransmission::Duration>(now - m_sentAt));
}

Transfer::Step Transfer::receive(const Reply &reply, Time now)
{
    if (reply.isRefusal())
        return {{}, tl::unexpected(reply.refusal())};
    switch (m_request.service) {
    case Service::SaveFile:
    case Service::ListFiles: return receiveBlock(reply, now);
    case Service::LoadFile: return receiveAcknowledgement(reply, now);
    default: return {{}, QByteArray {}};
    }
}

/// What does not acknowledge the block under way is an old answer, and nothing to act upon.
Transfer::Step Transfer::receiveAcknowledgement(const Reply &reply, Time now)
{
    const bool isMeant = m_block == 0
        ? protocol::checkGoAhead(reply).has_value()
        : protocol::checkAcknowledgement(reply, protocol::blockNumber(m_block, m_blockCount)).has_value();
    if (!isMeant)
        return {};
    measure(now);
    if (isLastBlockOut())
        return {{}, QByteArray {}};
    ++m_block;
    return send(protocol::encodeLoadBlock(m_upload, m_block, m_id, m_policy.blockSize), now);
}

Transfer::Step Transfer::receiveBlock(const Reply &reply, Time now)
{
    const auto taken = m_collector.take(reply);
    if (m_collector.fault())
        return {{}, tl::unexpected(*m_collector.fault())};
    if (!taken)
        return {}; // an older block that took its time
    const QByteArray acknowledgement = protocol::encodeAcknowledgement(m_request.service, m_id, reply.framing.block);
    if (*taken == BlockCollector::Step::Repeated)
        return {acknowledgement, {}};
    if (*taken == BlockCollector::Step::Next && hasStalled(now))
        return {{}, values::failure(ErrorKind::Malformed, QStringLiteral("the transfer gets nowhere"))};
    measure(now);
    Step step = send(acknowledgement, now);
    if (*taken == BlockCollector::Step::Complete)
        step.end = m_collector.content();
    return step;
}

bool Transfer::hasStalled(Time now)
{
    if (now - m_markedAt < m_policy.progressPeriod)
        return false;
    const qsizetype size = m_collector.content().size();
    m_markedAt = now;
    return size - std::exchange(m_markedSize, size) < m_policy.leastProgress;
}

bool Transfer::mayRepeat() const
{
    const bool isOrder = m_request.service == Service::DeleteFile || (isLoad() && m_block == 0);
    return m_tries == 1 && !isOrder;
}

values::Error Transfer::silence() const
{
    const bool mayHaveHappened = m_request.service == Service::DeleteFile || isLastBlockOut();
    return {mayHaveHappened ? ErrorKind::UnknownOutcome : ErrorKind::NoAnswer, 0, 0, {}};
}

Transfer::Step Transfer::expire(Time now)
{
    if (now < m_nextTry)
        return {};
    const Time end = m_sentAt + m_policy.timeout;
    if (now < end && !mayRepeat()) {
        m_nextTry = end;
        return {};
    }
    if (!mayRepeat())
        return {{}, tl::unexpected(silence())};
    ++m_tries;
    m_wasRepeated = true;
    m_nextTry = std::max(end, now + Milliseconds {1});
    return {m_packet, {}};
}

Transfer::Step Transfer::cancel()
{
    if (isLastBlockOut() || m_request.service == Service::DeleteFile)
        return {};
    return {{}, values::failure(ErrorKind::Cancelled)};
}

qint64 Transfer::bytesDone() const
{
    if (!isLoad())
        return m_collector.content().size();
    return std::min<qint64>(m_upload.size(), (m_block > 0 ? m_block - 1 : 0) * m_policy.blockSize);
}

} // namespace session
