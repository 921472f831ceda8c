// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "settings/profile.h"
#include "values/error.h"
#include <QCommandLineParser>
#include <QJsonDocument>
#include <QJsonValue>
#include <limits>

namespace pendeskctl {

/// Exit codes of every verb.
enum ExitCode {
    Done = 0,
    Differences = 1,
    Usage = 2,
    NoAnswer = 3, ///< Or the outcome is unknown.
    Refused = 4,
    LocalFile = 5,
    VerificationFailed = 6,
    Partial = 7,
    Interrupted = 130,
};

/// The exit code that tells a script what kind of error it was.
[[nodiscard]] ExitCode exitCodeOf(const values::Error &error);

/// The controller that the options name; BadInput with a sentence if they do not name one.
[[nodiscard]] values::Result<settings::Profile> profileOf(const QCommandLineParser &parser);

/// Parses `arguments` (the verb first), among which a negative number is a word and no option; on a mistake prints it
/// with a hint to --help and ends with `Usage`. Prints the help and ends with `Done` when asked for it. nullopt means:
/// go on. `words` are what the verb takes beside options.
[[nodiscard]] std::optional<ExitCode> parse(
    QCommandLineParser &parser, const QStringList &arguments, const QString &words = {});
/// The words behind the verb, as they were given.
[[nodiscard]] QStringList wordsOf(const QCommandLineParser &parser);
/// A whole number that is not negative; nullopt, after a complaint, for anything else.
[[nodiscard]] std::optional<int> numberOf(const QCommandLineParser &parser, const QCommandLineOption &option);

/// What a verb is told.
struct Call {
    settings::Profile profile;
    QStringList words; ///< Behind the verb.
    bool isJson = false;
    bool isQuiet = false;
    bool mayWrite = false; ///< --yes
    bool hasNumbering = false; ///< --numbering; it is in the profile.
    bool hasModel = false; ///< --model or --profile; else the controller is asked for it.
};

/// What a verb can be told.
struct VerbHelp {
    QString description;
    QString words; ///< Such as "get|set NAME".
    QList<QCommandLineOption> options = {};
    bool needsController = true;
    qsizetype fewestWords = 0; ///< Behind the verb; more or fewer end with Usage.
    qsizetype mostWords = 0;
};
inline constexpr qsizetype anyNumber = std::numeric_limits<qsizetype>::max();

/// Reads a call. Ends with an exit code where the program ends here: a mistake, or help was asked for.
[[nodiscard]] std::optional<ExitCode> read(
    Call &call, QCommandLineParser &parser, const VerbHelp &help, const QStringList &arguments);
/// Complains and returns Usage unless --yes was given.
[[nodiscard]] std::optional<ExitCode> requireYes(const Call &call);

[[nodiscard]] QString tr(const char *text);
/// "ISO-8859-1, UTF-8, …": what --encoding takes.
[[nodiscard]] QString encodingList();

// Whatever is printed may hold text from a controller: it stays on its line and does nothing to a terminal.

/// Prints "pendeskctl: `sentence`" on the error stream.
void complain(const QString &sentence);
/// Complains about how the program was called; Usage.
[[nodiscard]] ExitCode mistake(const QString &sentence);
/// Prints a line on the output stream.
void print(const QString &line);
/// Prints several lines.
void print(const QStringList &lines);
/// Prints an object or array on the output stream.
void print(const QJsonValue &json, QJsonDocument::JsonFormat format = QJsonDocument::Compact);
/// Shows how far it has come in one line of the error stream, if that is a terminal. Empty takes the line away.
void showProgress(const Call &call, const QString &line);

} // namespace pendeskctl
