// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include <chrono>

namespace virtualcontroller {

/// Since the virtual controller was switched on. It is a parameter everywhere; only the server reads a clock.
using Time = std::chrono::milliseconds;
using namespace std::chrono_literals;

} // namespace virtualcontroller
