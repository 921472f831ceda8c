// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "session/filesession.h"

#include "protocol/codes.h"
#include <QLoggingCategory>
#include <QRandomGenerator>

using protocol::Service;
using values::Error;
using values::ErrorKind;
using values::Result;

namespace session {

namespace {

Q_LOGGING_CATEGORY(sessionLog, "pendesk.session")

/// Some controllers may say "no file of that type" by refusing (reference §7.4).
bool saysEmptyList(const Error &error)
{
    constexpr std::array<quint16, 3> codes {0xE2A7, 0xE29C, 0xE2B3};
    return error.kind == ErrorKind::Refused && std::ranges::find(codes, error.addedStatus) != codes.end();
}

FileSession::ContentHandler withoutContent(FileSession::DoneHandler handler)
{
    return [handler = std::move(handler)](
               const Result<QByteArray> &result) { handler(result.map([](const QByteArray &) {})); };
}

} // namespace

FileSession::FileSession(Transport &transport, const FilePolicy &policy, QObject *parent)
    : QObject {parent},
      m_transport {transport},
      m_policy {policy},
      m_retransmission {policy.timeout / 2, policy.repeatFloor},
      m_ids {quint8(QRandomGenerator::global()->bounded(256))},
      m_random {QRandomGenerator::global()->generate()}
{
    m_timer.setSingleShot(true);
    m_timer.setTimerType(Qt::PreciseTimer);
    connect(&m_timer, &QTimer::timeout, this, &FileSession::onTimer);
    connect(&transport, &Transport::received, this, &FileSession::onReceived);
    connect(&transport, &Transport::receivedFromStranger, this, [this] { ++m_counters.strangers; });
}

FileSession::~FileSession() = default;

FileSession::TransferId FileSession::list(QByteArrayView pattern, QObject *context, ListHandler handler)
{
    const auto parse = [handler = std::move(handler)](const Result<QByteArray> &content) {
        if (content || saysEmptyList(content.error()))
            handler(protocol::parseFileList(content.value_or(QByteArray {})));
        else
            handler(tl::unexpected(content.error()));
    };
    return enqueue(protocol::listFiles(pattern), {}, context, parse, {});
}

FileSession::TransferId FileSession::save(
    const values::FileName &name, QObject *context, ContentHandler handler, Progress progress)
{
    return enqueue(protocol::saveFile(name), {}, context, std::move(handler), std::move(progress));
}

FileSession::TransferId FileSession::load(
    const values::FileName &name, const QByteArray &content, QObject *context, DoneHandler handler, Progress progress)
{
    return enqueue(protocol::loadFile(name), content, context, withoutContent(std::move(handler)), std::move(progress));
}

FileSession::TransferId FileSession::remove(const values::FileName &name, QObject *context, DoneHandler handler)
{
    return enqueue(protocol::deleteFile(name), {}, context, withoutContent(std::move(handler)), {});
}

FileSession::TransferId FileSession::enqueue(
    protocol::Request request, const QByteArray &upload, QObject *context, ContentHandler handler, Progress progress)
{
    Q_ASSERT(context);
    const bool isReading = request.service == Service::SaveFile || request.service == Service::ListFiles;
    Order order {++m_lastId, std::move(request), upload, context, std::move(handler), std::move(progress)};
    order.busyLeft = isReading ? m_policy.busyRepeats : 0;
    if (order.request.service == Service::LoadFile && upload.isEmpty()) {
        tellLater(std::move(order), {ErrorKind::BadInput, 0, 0, tr("An empty file cannot be sent over HSES.")});
    } else {
        m_orders.push_back(std::move(order));
        startNext();
    }
    return m_lastId;
}

void FileSession::startNext()
{
    const Time at = now();
    while (!m_transfer && !m_orders.empty()) {
        Order &order = m_orders.front();
        if (!order.context) {
            m_orders.pop_front();
            continue;
        }
        if (order.notBefore > at)
            return arm(order.notBefore);
        const auto id = m_ids.take(at);
        if (!id)
            return arm(m_ids.nextFree(at));
        m_lastAcknowledgement.clear();
        m_transfer.emplace(order.request, *id, m_policy, m_retransmission, order.upload);
        ++m_counters.requests;
        act({m_transfer->start(at), {}});
    }
}

void FileSession::send(const QByteArray &packet)
{
    // What does not leave is like what is lost: the transfer repeats it once, then says that nobody answered.
    if (const auto sent = m_transport.send(packet); !sent)
        qCWarning(sessionLog, "file port: %s", qUtf8Printable(sent.error().detail));
}

void FileSession::act(const Transfer::Step &step)
{
    if (!step.packet.isEmpty())
        send(step.packet);
    if (step.end)
        finish(*step.end);
    else if (m_transfer)
        arm(m_transfer->deadline());
}

void FileSession::onReceived(QByteArrayView datagram)
{
    const auto reply = protocol::parseReply(datagram);
    if (!reply || reply->framing.division != protocol::Division::File) {
        ++m_counters.malformed;
        return;
    }
    const bool isMeant = m_transfer && reply->framing.id == m_transfer->id()
        && reply->service == protocol::replyService(m_orders.front().request.service);
    if (!isMeant) {
        if (!acknowledgeAgain(*reply))
            ++m_counters.late;
        return;
    }
    ++m_counters.answers;
    if (!m_orders.front().context)
        return act({{}, values::failure(ErrorKind::Cancelled)});
    act(m_transfer->receive(*reply, now()));
    if (m_transfer && m_transfer->id() == reply->framing.id && m_orders.front().progress)
        m_orders.front().progress(m_transfer->bytesDone(), m_transfer->bytesTotal());
}

/// Our acknowledgement of the last block was lost, and the controller sent the block once more.
bool FileSession::acknowledgeAgain(const protocol::Reply &reply)
{
    const auto last = protocol::parseClientPacket(m_lastAcknowledgement);
    if (!last || last->framing.id != reply.framing.id || last->framing.block != reply.framing.block
        || protocol::replyService(last->service) != reply.service)
        return false;
    ++m_counters.duplicates;
    send(m_lastAcknowledgement);
    return true;
}

void FileSession::onTimer()
{
    if (!m_transfer)
        return startNext();
    const auto step = m_transfer->expire(now());
    if (!step.packet.isEmpty())
        ++m_counters.repeats;
    act(step);
}

void FileSession::finish(const Result<QByteArray> &result)
{
    const Service service = m_orders.front().request.service;
    if (result && (service == Service::SaveFile || service == Service::ListFiles))
        m_lastAcknowledgement = m_transfer->lastPacket();
    const bool isAnswered = (result || result.error().kind == ErrorKind::Refused) && !m_transfer->wasRepeated();
    restId(isAnswered);
    m_transfer.reset();
    if (!result && result.error().kind != ErrorKind::Refused)
        ++m_counters.lost;
    if (result || !waitForBusy(result.error())) {
        const Order order = std::move(m_orders.front());
        m_orders.pop_front();
        tell(order, result);
    }
    startNext();
}

/// Where a step was not answered, its answer may come a time-out later.
void FileSession::restId(bool isAnswered)
{
    const Milliseconds missing = isAnswered ? Milliseconds {0} : m_policy.timeout;
    m_ids.rest(m_transfer->id(), now() + m_policy.idLinger + missing);
}

bool FileSession::waitForBusy(const Error &error)
{
    Order &order = m_orders.front();
    if (!protocol::isBusy(error) || order.busyLeft == 0)
        return false;
    ++m_counters.busy;
    --order.busyLeft;
    std::uniform_int_distribution<int> wait {int(m_policy.busyLeast.count()), int(m_policy.busyMost.count())};
    order.notBefore = now() + Milliseconds {wait(m_random)};
    return true;
}

void FileSession::tell(const Order &order, const Result<QByteArray> &result)
{
    if (order.context)
        order.handler(result);
}

void FileSession::cancel(TransferId transfer)
{
    const auto order = std::ranges::find(m_orders, transfer, &Order::id);
    if (order == m_orders.end())
        return;
    const bool isUnderWay = m_transfer && order == m_orders.begin();
    if (isUnderWay && !m_transfer->cancel().end)
        return; // the last block is out: what happens now is the truth
    if (isUnderWay) {
        restId(false);
        m_transfer.reset();
    }
    tellLater(std::move(*order), {ErrorKind::Cancelled, 0, 0, {}});
    m_orders.erase(order);
    startNext();
}

void FileSession::tellLater(Order &&order, const Error &error)
{
    QTimer::singleShot(0, this, [this, order = std::move(order), error] { tell(order, tl::unexpected(error)); });
}

void FileSession::arm(Time at)
{
    m_timer.start(std::chrono::ceil<Milliseconds>(std::max(at - now(), Time::duration::zero())));
}

} // namespace session
