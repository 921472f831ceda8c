// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "values/fixedtext.h"

namespace values {

/// A job name without extension, in the pendant's encoding: 1 to 32 bytes (reference §8).
using JobName = FixedText<32>;

/// Where a task stands (reference §3.5).
struct ExecutingJob {
    JobName name;
    quint32 line = 0; ///< 0 to 9999; 0 is the top.
    quint32 step = 0; ///< 0 on an idle controller, else 1 to 9998.
    quint32 speedOverride = 0; ///< In 0.01 %: 10000 is 100 %.

    bool operator==(const ExecutingJob &) const = default;
};

} // namespace values
