// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include <QByteArrayView>

/// What must hold for any bytes at all; each aborts the program where it does not. libFuzzer calls them without end,
/// and a test a fixed number of times. One call tries one thing, chosen by the first bytes, so that calls are quick and
/// the fuzzer sees what its choice led to.
namespace fuzz {

/// A datagram: it is parsed or rejected, what was parsed encodes to what parses the same, and the decoder stands it.
void packet(QByteArrayView data);
/// Six bytes choose a command, its service, instance and attribute, and what is tried with the payload that follows.
void payload(QByteArrayView data);
/// The first byte chooses: the blocks of a save or list, or those of a load.
void fileBlocks(QByteArrayView data);
/// The names in the content of a list.
void fileList(QByteArrayView data);
/// Three bytes choose an encoding, a direction and a size; text follows.
void text(QByteArrayView data);
/// A job: the first byte chooses whether it is only read, or offered to the virtual controller as a file whose name is
/// the first line.
void inform(QByteArrayView data);

/// Three bytes choose a type of controller file, an encoding, and whether the file that follows is read or compared with
/// its first half.
void cellFile(QByteArrayView data);

} // namespace fuzz
