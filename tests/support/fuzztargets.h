// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include <QByteArrayView>

/// What must hold for any bytes at all; each aborts the program where it does not. libFuzzer calls them without end,
/// and a test a fixed number of times.
namespace fuzz {

/// A datagram: it is parsed or rejected, what was parsed encodes to what parses the same, and the decoder stands it.
void packet(QByteArrayView data);
/// The first two bytes choose a command and a service, the rest is the payload of the request and of the reply.
void payload(QByteArrayView data);
/// A sequence of blocks of a file transfer.
void fileBlocks(QByteArrayView data);
/// The first byte chooses an encoding, the second a size, the rest is text.
void text(QByteArrayView data);

} // namespace fuzz
