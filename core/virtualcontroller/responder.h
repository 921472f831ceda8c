// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "virtualcontroller/memory.h"
#include <QByteArray>
#include <QByteArrayView>
#include <optional>

namespace virtualcontroller {

/// The reply of the robot port to one datagram, after the memory was advanced to `now`. Nothing is answered to what is
/// too short or does not begin with the identifier. The order of validation is that of reference §1.7.
///
/// Servo on is answered when servo power is on: while isWaitingForPower(), the reply is to be kept back, and then
/// servoOnReply() is to be sent in its place (reference §0.1 h).
[[nodiscard]] std::optional<QByteArray> respond(QByteArrayView datagram, Memory &memory, Time now);

/// Whether the reply to `datagram`, which was just answered, must wait for servo power.
[[nodiscard]] bool isWaitingForPower(QByteArrayView datagram, const Memory &memory);
/// The reply to the servo-on order in `datagram` when it need not wait any more: 0x3450 if something has taken the
/// power away before it came.
[[nodiscard]] QByteArray servoOnReply(QByteArrayView datagram, const Memory &memory);

} // namespace virtualcontroller
