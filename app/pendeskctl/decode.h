// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include <QStringList>

namespace pendeskctl {

/// `pendeskctl decode`: prints the packets given as hex on the command line, or line by line on standard input, one
/// JSON object each. The exit code is 1 if one of them is malformed.
int runDecode(const QStringList &arguments);

} // namespace pendeskctl
