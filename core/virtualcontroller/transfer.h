// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "protocol/packet.h"
#include "virtualcontroller/time.h"

namespace virtualcontroller {

/// A file transfer that has been begun (reference §7).
struct Transfer {
    QByteArray peer; ///< Who began it; opaque.
    protocol::Service service = protocol::Service::SaveFile;
    quint8 id = 0; ///< The request's; all packets of the transfer carry it.
    QByteArray name {}; ///< Of the file that is loaded.
    QByteArray data {}; ///< What has come so far, or all that is being sent.
    quint32 block = 0; ///< The last block taken or sent, bit 31 included; 0 before the first.
    QByteArray lastPacket {}; ///< The client's last packet that was in order.
    QByteArray lastReply {}; ///< What it was answered: a repeat of it is answered the same way.
    Time heard {}; ///< When the client was last heard of.
    bool isCutOff = false; ///< The mode was changed meanwhile (reference §7.6).
    bool isOver = false; ///< Kept to answer a repeat of the last packet; nobody else has to wait for it.
};

} // namespace virtualcontroller
