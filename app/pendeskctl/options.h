// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "settings/profile.h"
#include "values/error.h"
#include <QCommandLineParser>

namespace pendeskctl {

/// Exit codes of every verb.
enum ExitCode { Done = 0, Differences = 1, Usage = 2, NoAnswer = 3, Refused = 4, LocalFile = 5 };

/// The exit code that tells a script what kind of error it was.
[[nodiscard]] ExitCode exitCodeOf(const values::Error &error);

/// The controller that the options name; BadInput with a sentence if they do not name one.
[[nodiscard]] values::Result<settings::Profile> profileOf(const QCommandLineParser &parser);

/// Parses `arguments` (the verb first); on a mistake prints it with a hint to --help and ends with `Usage`.
/// Prints the help and ends with `Done` when asked for it. nullopt means: go on.
[[nodiscard]] std::optional<ExitCode> parse(QCommandLineParser &parser, const QStringList &arguments);

/// Prints "pendeskctl: `sentence`" on the error stream.
void complain(const QString &sentence);
/// Prints a line on the output stream.
void print(const QString &line);

} // namespace pendeskctl
