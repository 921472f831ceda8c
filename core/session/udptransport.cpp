// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "session/udptransport.h"

#include <QNetworkProxy>
#include <QUdpSocket>

namespace session {

UdpTransport::UdpTransport(const QHostAddress &address, quint16 port, QObject *parent)
    : Transport {parent}, m_address {address}, m_port {port}, m_socket {new QUdpSocket {this}}
{
    connect(m_socket, &QUdpSocket::readyRead, this, &UdpTransport::receive);
    m_socket->setProxy(QNetworkProxy::NoProxy); // a controller is in this network; asking for the desktop's takes time
    if (!m_socket->bind(QHostAddress {QHostAddress::AnyIPv4}, 0))
        m_bindError = m_socket->errorString();
}

UdpTransport::~UdpTransport() = default;

values::Result<void> UdpTransport::send(QByteArrayView datagram)
{
    if (!m_bindError.isEmpty()) // without a port of its own no answer could come
        return values::failure(values::ErrorKind::Network, m_bindError);
    if (m_socket->writeDatagram(datagram.data(), datagram.size(), m_address, m_port) == datagram.size())
        return {};
    return values::failure(values::ErrorKind::Network, m_socket->errorString());
}

/// One datagram an event: with many sockets in a thread none starves, and asking whether there is a second one would
/// cost as much as the event loop telling.
void UdpTransport::receive()
{
    QHostAddress sender;
    quint16 port = 0;
    const qint64 size = m_socket->readDatagram(m_buffer.data(), qint64(m_buffer.size()), &sender, &port);
    if (size < 0)
        return; // an ICMP error of an earlier datagram; the request's own deadline tells
    if (port != m_port || sender != m_address)
        Q_EMIT receivedFromStranger();
    else
        Q_EMIT received(QByteArrayView {m_buffer.data(), size});
}

} // namespace session
