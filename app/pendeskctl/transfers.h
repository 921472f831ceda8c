// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "desk.h"
#include "files/task.h"

namespace pendeskctl {

/// Makes a task of a file; nullptr skips it, which makes the result Partial.
using TaskMaker = std::function<std::unique_ptr<files::Task>(const values::FileName &)>;

/// Carries out a task for each name, tells how each went, and ends the program.
void transfer(Desk &desk, const QStringList &names, const TaskMaker &taskFor);

} // namespace pendeskctl
