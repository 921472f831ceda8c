// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "protocol/packet.h"

/// How many bytes a controller or a file may bring before it is taken for broken. HSES tells no size beforehand
/// (reference §7.4), so without these a block that never is the last one would fill the memory.
namespace protocol {

/// A line of a list is a name of at most 43 bytes with CR LF (reference §7): room for 24,000 files.
inline constexpr qsizetype listLimit = qsizetype {1} << 20;
/// A job has at most 9,999 lines and 9,999 steps (reference §3.5). With 255 bytes a line and two position lines of 120
/// bytes a step that is 5 MB.
inline constexpr qsizetype jobLimit = qsizetype {8} << 20;
/// The largest text file known is ALL.PRM with 1.4 MB, the largest file at all the image of the batch backup, which
/// must fit into the controller's RAM disk (reference §7.5).
inline constexpr qsizetype fileLimit = qsizetype {64} << 20;

/// The bound of what `request`, one of the file port, brings.
[[nodiscard]] qsizetype sizeLimit(const Request &request);

} // namespace protocol
