// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include <chrono>

namespace values {

/// What ages and time-outs are counted from: it never jumps, whatever is done to the wall clock.
using Time = std::chrono::steady_clock::time_point;

[[nodiscard]] inline Time now() { return std::chrono::steady_clock::now(); }

} // namespace values
