// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "options.h"

/// The second half of "var set", "registers set" and "io set". Each returns the exit code.
namespace pendeskctl {

/// Writes a variable or register once and reads it back. A variable only with --numbering, or if the profile's
/// numbering was verified with the software that the controller has now.
int setVariable(const Call &call, const QString &word, const QString &typed);
/// Writes one network input.
int setSignal(const Call &call, const QString &word, const QString &typed);

} // namespace pendeskctl
