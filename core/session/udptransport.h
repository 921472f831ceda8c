// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "session/transport.h"
#include <QHostAddress>
#include <array>

class QUdpSocket;

namespace session {

/// The network: one unconnected UDP socket for one port of one controller. It tells answers of the controller from
/// those of strangers by address and port (reference §1). The only client QUdpSocket of the program.
class UdpTransport : public Transport
{
    Q_OBJECT

public:
    /// `address` is IPv4.
    UdpTransport(const QHostAddress &address, quint16 port, QObject *parent = nullptr);
    ~UdpTransport() override;

    [[nodiscard]] values::Result<void> send(QByteArrayView datagram) override;

private:
    void receive();

    QHostAddress m_address;
    quint16 m_port;
    QUdpSocket *m_socket;
    QString m_bindError; ///< Why the socket has no port; empty if it has.
    std::array<char, 2048> m_buffer; ///< Larger than any packet, so that an oversized one is noticed.
};

} // namespace session
