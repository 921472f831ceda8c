// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "virtualcontroller/server.h"
#include <QStringList>

/// What the command line asks for.
struct SimOptions {
    virtualcontroller::Options server;
    virtualcontroller::Memory memory; ///< The state to start with.
    int count = 1; ///< How many controllers; ports count upwards, unless they are 0.
    QString ended; ///< Not empty: print this on the output stream and end with 0, as for --help.
};

/// `arguments` begins with the program's name. BadInput with a sentence for a mistake in the options, LocalFile for a
/// file or folder that cannot be read or used.
[[nodiscard]] values::Result<SimOptions> parseOptions(const QStringList &arguments);
[[nodiscard]] QString usage();
