// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "options.h"

#include "settings/commandline.h"
#include <QSettings>
#include <cstdio>

using values::Error;
using values::ErrorKind;
using values::Result;

namespace pendeskctl {

namespace {

QString tr(const char *text) { return QCoreApplication::translate("pendeskctl", text); }

} // namespace

ExitCode exitCodeOf(const Error &error)
{
    switch (error.kind) {
    case ErrorKind::Refused: return Refused;
    case ErrorKind::BadInput: return Usage;
    case ErrorKind::LocalFile: return LocalFile;
    default: return NoAnswer;
    }
}

Result<settings::Profile> profileOf(const QCommandLineParser &parser)
{
    QSettings stored;
    const auto named = settings::namedController(parser, settings::ProfileStore {stored});
    if (!named)
        return tl::unexpected(named.error());
    if (!*named)
        return values::failure(ErrorKind::BadInput, tr("Name the controller with --host or --profile."));
    return **named;
}

std::optional<ExitCode> parse(QCommandLineParser &parser, const QStringList &arguments)
{
    const auto help = parser.addHelpOption();
    if (!parser.parse(arguments)) {
        complain(parser.errorText() + QLatin1Char(' ') + tr("See pendeskctl %1 --help.").arg(arguments.first()));
        return Usage;
    }
    if (parser.isSet(help)) {
        // Qt writes the program's path where a person types the program and the verb.
        const QString program = QStringLiteral("pendeskctl ") + arguments.first();
        print(parser.helpText().replace(QCoreApplication::arguments().constFirst(), program).trimmed());
        return Done;
    }
    return std::nullopt;
}

void complain(const QString &sentence) { std::fprintf(stderr, "pendeskctl: %s\n", qUtf8Printable(sentence)); }

void print(const QString &line) { std::fprintf(stdout, "%s\n", qUtf8Printable(line)); }

} // namespace pendeskctl
