// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "protocol/packet.h"
#include "values/error.h"
#include "virtualcontroller/faults.h"
#include "virtualcontroller/memory.h"
#include "virtualcontroller/script.h"
#include <QNetworkDatagram>
#include <QObject>
#include <functional>

class QTimer;
class QUdpSocket;

namespace virtualcontroller {

struct Options {
    QString address = QStringLiteral("127.0.0.1"); ///< An IP address; loopback alone unless told otherwise.
    quint16 port = protocol::robotPort; ///< 0: a free one.
    quint16 filePort = protocol::filePort; ///< 0: a free one.
    Settings settings {};
    Faults faults {}; ///< None, unless told otherwise.
    Script script {}; ///< What happens by itself.
    /// Tells the time since switching on; without one the server counts real time from its construction on. Delays of
    /// faults are real time in either case.
    std::function<Time()> clock {};
};

/// What has arrived at the sockets, faults or not: so often was it really sent.
struct Arrivals {
    std::map<quint16, int> commands; ///< Robot port, by command number.
    std::map<quint16, int> requests; ///< Robot port, without what only repeats the last one of that command.
    std::map<protocol::Service, int> files; ///< File port, by service; acknowledgements and blocks count too.
    std::map<protocol::Service, int> fileRequests; ///< The same, without repeats.
    int broken = 0; ///< Shorter than a header.
};

/// A virtual controller on real UDP sockets: the pure responders with a wire, faults and a clock. Each reply leaves the
/// port that was addressed and goes to the address and port that asked (reference §1). Live from start() to stop().
class Server : public QObject
{
    Q_OBJECT

public:
    explicit Server(const Options &options = {}, QObject *parent = nullptr);
    ~Server() override;

    /// Opens both ports, or neither: an Error of kind Network says in `detail`, in a sentence, which port could not be
    /// had and why.
    [[nodiscard]] values::Result<void> start();
    void stop();

    /// The ports it really listens on; 0 while it does not.
    [[nodiscard]] quint16 port() const;
    [[nodiscard]] quint16 filePort() const;

    /// The controller's state: free to look at and to change between two datagrams.
    [[nodiscard]] Memory &memory() { return m_memory; }
    /// Another state, to which a restart by fault returns too.
    void setMemory(Memory memory);
    void setFaults(Faults faults) { m_faults = std::move(faults); }
    /// Moves the memory on to the present time and returns that.
    Time advanceToNow();

    [[nodiscard]] const Arrivals &arrivals() const { return m_arrivals; }
    [[nodiscard]] int arrived(quint16 command) const;
    /// How often it was asked for; a busy computer repeats what it was not answered in time.
    [[nodiscard]] int asked(quint16 command) const;
    [[nodiscard]] int asked(protocol::Service service) const;

private:
    [[nodiscard]] values::Result<void> bind(QUdpSocket *socket, quint16 port);
    void receive(QUdpSocket *socket);
    void count(QUdpSocket *socket, QByteArrayView datagram);
    void take(QUdpSocket *socket, const QNetworkDatagram &datagram);
    void answer(QUdpSocket *socket, const QNetworkDatagram &datagram, std::optional<quint16> refusal);
    void reply(QUdpSocket *socket, const QNetworkDatagram &datagram, const QByteArray &packet);
    void keepBack(const QNetworkDatagram &datagram);
    void answerServoOrders();
    void deliver(const Faults::Plan &plan, const std::function<void(const QByteArray &)> &to);
    [[nodiscard]] bool isSilent() { return advanceToNow() < m_memory.silentUntil; }
    void fallSilent(const Faults::Plan &plan);

    Options m_options;
    Memory m_memory;
    Memory m_startMemory;
    Faults m_faults;
    Arrivals m_arrivals;
    std::vector<QNetworkDatagram> m_servoOrders; ///< Answered when servo power is on.
    std::map<quint16, QByteArray> m_lastCommands; ///< The last datagram of each command: it may be repeated.
    std::map<protocol::Service, QByteArray> m_lastFiles;
    QUdpSocket *m_robotSocket;
    QUdpSocket *m_fileSocket;
    QTimer *m_housekeeping;
};

} // namespace virtualcontroller
