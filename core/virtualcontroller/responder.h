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
[[nodiscard]] std::optional<QByteArray> respond(QByteArrayView datagram, Memory &memory, Time now);

} // namespace virtualcontroller
