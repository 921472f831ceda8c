// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "trend/track.h"
#include <QByteArray>

namespace trend {

/// Tracks as RFC 4180 lines in UTF-8 and the C locale: a column `time_utc`, then one for each track with its unit in
/// brackets; a row for each moment of `range` at which any of them was read. An empty field was not read at that
/// moment; `NaN` begins a gap.
[[nodiscard]] QByteArray toCsv(std::span<const Track *const> tracks, const Range &range);

} // namespace trend
