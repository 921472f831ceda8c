// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "protocol/packet.h"
#include "virtualcontroller/memory.h"

namespace virtualcontroller {

/// What stands against a valid request in the controller's present state: the first refusal of reference §10.2 that
/// holds, as an added status (reference §9), or 0 if the request may be done.
[[nodiscard]] quint16 accessRefusal(const protocol::Request &request, const Memory &memory);
/// The same for a file service, busyness with another transfer aside.
[[nodiscard]] quint16 fileAccessRefusal(protocol::Service service, const Memory &memory);

} // namespace virtualcontroller
