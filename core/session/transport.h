// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "values/error.h"
#include <QByteArrayView>
#include <QObject>

namespace session {

/// The seam between a session and the network: datagrams out, datagrams in. Tests put their own behind it.
class Transport : public QObject
{
    Q_OBJECT

public:
    using QObject::QObject;

    /// Sends one datagram to the controller; an error says why it did not leave this computer.
    virtual values::Result<void> send(QByteArrayView datagram) = 0;

Q_SIGNALS:
    /// A datagram came from the controller's address and port. The view is valid during the call only.
    void received(QByteArrayView datagram);
    /// A datagram came from somewhere else. It is never shown to anyone; it is counted.
    void receivedFromStranger();
};

} // namespace session
