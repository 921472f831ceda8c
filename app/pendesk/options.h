// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "settings/profilestore.h"
#include "ui/theme.h"

namespace pendesk {

enum ExitCode { Done = 0, Usage = 2, NoAnswer = 3, LocalFile = 5 };

/// What the command line asks for.
struct Options {
    bool isDemo = false;
    std::optional<settings::Profile> target; ///< Connect to it at once.
    QString scheme; ///< "light" or "dark"; empty: as this user chose, or as the desktop.
    QString language; ///< Code of one of ui::languages(); empty: as this user chose, or as the desktop.
    bool wantsTimings = false;
    bool isMonitorOnly = false; ///< Without the levels that change anything.
    QString pictures; ///< Folder for pictures; empty: none wanted.
    QString contactSheet; ///< File for all pictures in one; empty: none wanted.
    QString text; ///< Set by --help and --version: print it and end.
};

/// BadInput with a whole sentence if the arguments (the program first) cannot be followed.
[[nodiscard]] values::Result<Options> parse(const QStringList &arguments, const settings::ProfileStore &store);

} // namespace pendesk
