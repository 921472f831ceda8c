// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "virtualcontroller/memory.h"
#include <QByteArrayView>

namespace virtualcontroller {

/// The reply of the file port to one datagram from `peer`, any bytes that tell clients apart, after the memory was
/// advanced to `now` (reference §7). Nothing is answered to a broken frame and to the last acknowledgement of a save or
/// list. A repeat of the client's last packet is answered as it was the first time.
///
/// One transfer goes on at a time. It ends with its last block, when its client asks for something else, or after
/// Settings::transferTimeout of silence.
[[nodiscard]] std::optional<QByteArray> respondFile(
    QByteArrayView datagram, const QByteArray &peer, Memory &memory, Time now);

} // namespace virtualcontroller
