// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "robot/signalwatch.h"
#include "settings/notes.h"

namespace station {

/// Watches the signals that were watched the last time, and keeps every change of their list from now on.
void keepWatchList(robot::SignalWatch &watch, settings::Notes notes, const protocol::Dialect &dialect);

} // namespace station
