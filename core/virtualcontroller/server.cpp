// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "virtualcontroller/server.h"

#include "virtualcontroller/fileresponder.h"
#include "virtualcontroller/frames.h"
#include "virtualcontroller/responder.h"
#include <QElapsedTimer>
#include <QNetworkDatagram>
#include <QTimer>
#include <QUdpSocket>

using values::ErrorKind;
using values::Result;

namespace virtualcontroller {

namespace {

constexpr qint64 receiveSize = 2048; ///< Larger than any packet, so that an oversized one stays malformed.
constexpr auto housekeepingPeriod = 500ms; ///< So that nobody waits for an hour of jobs to be caught up with.

std::function<Time()> realTime()
{
    QElapsedTimer timer;
    timer.start();
    return [timer] { return Time {timer.elapsed()}; };
}

QByteArray peerOf(const QNetworkDatagram &datagram)
{
    return datagram.senderAddress().toString().toLatin1() + ':' + QByteArray::number(datagram.senderPort());
}

/// The command a packet belongs to, as the fault table counts: 0 for files and for what is too short to tell.
quint16 commandOf(QByteArrayView datagram)
{
    return datagram.size() < protocol::headerSize ? quint16 {0} : protocol::peekClientPacket(datagram).command;
}

template <typename Key> int countOf(const std::map<Key, int> &counts, Key key)
{
    const auto found = counts.find(key);
    return found == counts.end() ? 0 : found->second;
}

template <typename Key>
void countOne(Key key, QByteArrayView datagram, std::map<Key, int> &all, std::map<Key, int> &requests,
    std::map<Key, QByteArray> &last)
{
    ++all[key];
    if (last[key] == datagram)
        return;
    last[key] = datagram.toByteArray();
    ++requests[key];
}

} // namespace

Server::Server(const Options &options, QObject *parent)
    : QObject {parent},
      m_options {options},
      m_memory {options.settings},
      m_startMemory {m_memory},
      m_faults {options.faults},
      m_robotSocket {new QUdpSocket {this}},
      m_fileSocket {new QUdpSocket {this}},
      m_housekeeping {new QTimer {this}}
{
    if (!m_options.clock)
        m_options.clock = realTime();
    for (QUdpSocket *socket : {m_robotSocket, m_fileSocket})
        connect(socket, &QUdpSocket::readyRead, this, [this, socket] { receive(socket); });
    connect(m_housekeeping, &QTimer::timeout, this, &Server::advanceToNow);
}

Server::~Server() = default;

Result<void> Server::bind(QUdpSocket *socket, quint16 port)
{
    const QHostAddress address {m_options.address};
    if (address.isNull())
        return values::failure(ErrorKind::Network, QStringLiteral("%1 is not an IP address.").arg(m_options.address));
    if (socket->bind(address, port, QAbstractSocket::DontShareAddress))
        return {};
    return values::failure(ErrorKind::Network,
        QStringLiteral("UDP port %1 on %2 cannot be opened: %3.")
            .arg(port)
            .arg(m_options.address, socket->errorString()));
}

Result<void> Server::start()
{
    stop();
    auto opened = bind(m_robotSocket, m_options.port);
    if (opened)
        opened = bind(m_fileSocket, m_options.filePort);
    if (opened)
        m_housekeeping->start(housekeepingPeriod);
    else
        stop();
    return opened;
}

void Server::stop()
{
    m_housekeeping->stop();
    m_servoOrders.clear();
    m_robotSocket->close();
    m_fileSocket->close();
}

quint16 Server::port() const { return m_robotSocket->localPort(); }
quint16 Server::filePort() const { return m_fileSocket->localPort(); }

void Server::setMemory(Memory memory)
{
    m_startMemory = memory;
    m_memory = std::move(memory);
}

Time Server::advanceToNow()
{
    const Time now = m_options.clock();
    m_options.script.run(m_memory, now);
    answerServoOrders();
    return now;
}

int Server::arrived(quint16 command) const { return countOf(m_arrivals.commands, command); }

int Server::asked(quint16 command) const { return countOf(m_arrivals.requests, command); }

int Server::asked(protocol::Service service) const { return countOf(m_arrivals.fileRequests, service); }

/// One datagram an event, and a read in every event: after two events without one a QUdpSocket never tells again.
void Server::receive(QUdpSocket *socket)
{
    const QNetworkDatagram datagram = socket->receiveDatagram(receiveSize);
    if (!datagram.isValid())
        return;
    count(socket, datagram.data());
    if (!isSilent())
        take(socket, datagram);
}

void Server::count(QUdpSocket *socket, QByteArrayView datagram)
{
    if (datagram.size() < protocol::headerSize)
        ++m_arrivals.broken;
    else if (socket == m_fileSocket)
        countOne(protocol::peekClientPacket(datagram).service, datagram, m_arrivals.files, m_arrivals.fileRequests,
            m_lastFiles);
    else
        countOne(commandOf(datagram), datagram, m_arrivals.commands, m_arrivals.requests, m_lastCommands);
}

/// Hands each packet of a plan over, at once or when its delay is over.
void Server::deliver(const Faults::Plan &plan, const std::function<void(const QByteArray &)> &to)
{
    for (const auto &[delay, bytes] : plan.deliveries) {
        if (delay <= 0ms)
            to(bytes);
        else
            QTimer::singleShot(delay, this, [to, packet = bytes] { to(packet); });
    }
}

void Server::fallSilent(const Faults::Plan &plan)
{
    const Time now = m_memory.now;
    if (plan.isRestart) {
        m_memory = m_startMemory;
        advanceToNow();
    }
    m_memory.silentUntil = now + plan.silence.value_or(0ms);
}

void Server::take(QUdpSocket *socket, const QNetworkDatagram &datagram)
{
    const auto plan = m_faults.plan(Direction::Request, commandOf(datagram.data()), datagram.data());
    if (plan.silence)
        fallSilent(plan);
    deliver(plan, [this, socket, from = datagram, refusal = plan.refusal](const QByteArray &bytes) {
        QNetworkDatagram arrived = from;
        arrived.setData(bytes);
        answer(socket, arrived, refusal);
    });
}

void Server::answer(QUdpSocket *socket, const QNetworkDatagram &datagram, std::optional<quint16> refusal)
{
    const QByteArray bytes = datagram.data();
    const Time now = advanceToNow();
    const bool isRefused = refusal && bytes.size() >= protocol::headerSize;
    const auto reply = isRefused ? refusalReply(protocol::peekClientPacket(bytes), *refusal)
        : socket == m_fileSocket ? respondFile(bytes, peerOf(datagram), m_memory, now)
                                 : respond(bytes, m_memory, now);
    if (!reply)
        return;
    if (!isRefused && socket == m_robotSocket && isWaitingForPower(bytes, m_memory))
        return keepBack(datagram);
    this->reply(socket, datagram, *reply);
}

void Server::reply(QUdpSocket *socket, const QNetworkDatagram &datagram, const QByteArray &packet)
{
    const auto plan = m_faults.plan(Direction::Reply, commandOf(datagram.data()), packet);
    if (plan.silence)
        fallSilent(plan);
    deliver(plan, [socket, datagram](const QByteArray &bytes) {
        if (socket->state() == QAbstractSocket::BoundState)
            socket->writeDatagram(QNetworkDatagram {datagram}.makeReply(bytes));
    });
}

void Server::keepBack(const QNetworkDatagram &datagram)
{
    m_servoOrders.push_back(datagram);
    QTimer::singleShot(*m_memory.servoOnAt - m_memory.now, this, &Server::advanceToNow);
}

/// Power has come, or will not come any more.
void Server::answerServoOrders()
{
    if (m_memory.servoOnAt)
        return;
    for (const QNetworkDatagram &order : std::exchange(m_servoOrders, {}))
        reply(m_robotSocket, order, servoOnReply(order.data(), m_memory));
}

} // namespace virtualcontroller
