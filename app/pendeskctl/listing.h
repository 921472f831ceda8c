// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "desk.h"

/// The names of files at a controller.
namespace pendeskctl {

using NamesHandler = std::function<void(const QStringList &)>;

/// Hands over what the controller lists and `pattern` ("*.JBI", "WELD*") matches; ends the program when a list cannot
/// be had.
void list(Desk &desk, const QString &pattern, const NamesHandler &handler);

/// Patterns become the names that the controller has; other names stay.
void expand(Desk &desk, const QStringList &words, const QStringList &done, const NamesHandler &handler);

/// Prints names as lines, or as one list, and ends the program.
void printNames(Desk &desk, const QStringList &names);

} // namespace pendeskctl
