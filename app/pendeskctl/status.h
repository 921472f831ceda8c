// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include <QStringList>

namespace pendeskctl {

/// `pendeskctl status`: reads a controller once and prints what it says.
int runStatus(const QStringList &arguments);

} // namespace pendeskctl
