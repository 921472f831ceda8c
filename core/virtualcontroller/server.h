// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "protocol/packet.h"
#include "values/error.h"
#include "virtualcontroller/memory.h"
#include <QHostAddress>
#include <QObject>
#include <functional>

class QUdpSocket;

namespace virtualcontroller {

struct Options {
    QHostAddress address = QHostAddress::LocalHost;
    quint16 port = protocol::robotPort; ///< 0: a free one.
    quint16 filePort = protocol::filePort; ///< 0: a free one.
    Settings settings {};
    /// Tells the time since switching on; without one the server counts real time from start() on.
    std::function<Time()> clock {};
};

/// A virtual controller on real UDP sockets: the pure responder with a wire and a clock. Each reply leaves the port
/// that was addressed and goes to the address and port that asked (reference §1). Live from start() to stop().
class Server : public QObject
{
    Q_OBJECT

public:
    explicit Server(const Options &options = {}, QObject *parent = nullptr);
    ~Server() override;

    /// Opens both ports, or neither: an Error of kind Network says in `detail` which port could not be had and why.
    [[nodiscard]] values::Result<void> start();
    void stop();

    /// The ports it really listens on; 0 while it does not.
    [[nodiscard]] quint16 port() const;
    [[nodiscard]] quint16 filePort() const;

    /// The controller's state: free to look at and to change between two datagrams.
    [[nodiscard]] Memory &memory() { return m_memory; }
    /// Moves the memory on to the present time and returns that.
    Time advanceToNow();

private:
    [[nodiscard]] values::Result<void> bind(QUdpSocket *socket, quint16 port);
    void receive(QUdpSocket *socket);

    Options m_options;
    Memory m_memory;
    QUdpSocket *m_robotSocket;
    QUdpSocket *m_fileSocket;
};

} // namespace virtualcontroller
