// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include <QStringList>

/// `pendeskctl decode`: prints the packets given as hex on the command line, or line by line on standard input, one
/// JSON object each. `arguments` are those behind "decode". Returns the exit code: 0, 1 if a packet is malformed, 2 for
/// usage.
int runDecode(const QStringList &arguments);
