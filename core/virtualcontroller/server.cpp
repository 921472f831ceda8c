// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "virtualcontroller/server.h"

#include "virtualcontroller/machine.h"
#include "virtualcontroller/responder.h"
#include <QElapsedTimer>
#include <QNetworkDatagram>
#include <QTimer>
#include <QUdpSocket>

namespace virtualcontroller {

namespace {

constexpr int datagramsAtOnce = 16; ///< Then the event loop gets its turn.

std::function<Time()> realTime()
{
    QElapsedTimer timer;
    timer.start();
    return [timer] { return Time {timer.elapsed()}; };
}

} // namespace

Server::Server(const Options &options, QObject *parent)
    : QObject {parent},
      m_options {options},
      m_memory {options.settings},
      m_robotSocket {new QUdpSocket {this}},
      m_fileSocket {new QUdpSocket {this}}
{
    if (!m_options.clock)
        m_options.clock = realTime();
    for (QUdpSocket *socket : {m_robotSocket, m_fileSocket})
        connect(socket, &QUdpSocket::readyRead, this, [this, socket] { receive(socket); });
}

Server::~Server() = default;

values::Result<void> Server::bind(QUdpSocket *socket, quint16 port)
{
    if (socket->bind(m_options.address, port, QAbstractSocket::DontShareAddress))
        return {};
    return values::failure(values::ErrorKind::Network,
        QStringLiteral("UDP port %1 on %2 cannot be opened: %3.")
            .arg(port)
            .arg(m_options.address.toString(), socket->errorString()));
}

values::Result<void> Server::start()
{
    stop();
    return bind(m_robotSocket, m_options.port)
        .and_then([this] { return bind(m_fileSocket, m_options.filePort); })
        .map_error([this](const values::Error &error) {
            stop();
            return error;
        });
}

void Server::stop()
{
    m_robotSocket->close();
    m_fileSocket->close();
}

quint16 Server::port() const { return m_robotSocket->localPort(); }
quint16 Server::filePort() const { return m_fileSocket->localPort(); }

Time Server::advanceToNow()
{
    const Time now = m_options.clock();
    advance(m_memory, now);
    return now;
}

void Server::receive(QUdpSocket *socket)
{
    for (int count = 0; count < datagramsAtOnce && socket->hasPendingDatagrams(); ++count) {
        const QNetworkDatagram datagram = socket->receiveDatagram();
        if (socket == m_fileSocket)
            continue;
        if (const auto reply = respond(datagram.data(), m_memory, m_options.clock()))
            socket->writeDatagram(datagram.makeReply(*reply));
    }
    if (socket->hasPendingDatagrams())
        QTimer::singleShot(0, this, [this, socket] { receive(socket); });
}

} // namespace virtualcontroller
