// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "options.h"

#include "settings/commandline.h"
#include "settings/settingsfile.h"
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <cstdio>
#ifdef Q_OS_UNIX
#include <unistd.h>
#endif

using values::Error;
using values::ErrorKind;
using values::Result;

namespace pendeskctl {

namespace {

bool isTerminal()
{
#ifdef Q_OS_UNIX
    return ::isatty(STDERR_FILENO) == 1;
#else
    return false;
#endif
}

void addCommonOptions(QCommandLineParser &parser, bool needsController)
{
    if (needsController) {
        settings::addConnectionOptions(parser);
        parser.addOption({QStringLiteral("numbering"),
            tr("Instance of the first variable on this controller, 0 or 1 (parameter RS022)."), QStringLiteral("0|1")});
    }
    parser.addOption({QStringLiteral("json"), tr("Print JSON.")});
    parser.addOption({QStringLiteral("yes"), tr("Yes, write: what changes something does nothing without it.")});
    parser.addOption({QStringLiteral("quiet"), tr("No progress and no remarks.")});
    settings::addLogOption(parser);
}

Result<void> readController(Call &call, const QCommandLineParser &parser)
{
    const auto profile = profileOf(parser);
    if (!profile)
        return tl::unexpected(profile.error());
    call.profile = *profile;
    call.hasNumbering = parser.isSet(QStringLiteral("numbering"));
    if (!call.hasNumbering)
        return {};
    const QString numbering = parser.value(QStringLiteral("numbering"));
    if (numbering != u"0" && numbering != u"1")
        return values::badInput(tr("--numbering takes 0 or 1."));
    call.profile.numbering = protocol::Numbering(numbering.toInt());
    return {};
}

} // namespace

QString tr(const char *text) { return QCoreApplication::translate("pendeskctl", text); }

ExitCode exitCodeOf(const Error &error)
{
    switch (error.kind) {
    case ErrorKind::Refused: return Refused;
    case ErrorKind::BadInput: return Usage;
    case ErrorKind::NotSent: return Refused;
    case ErrorKind::LocalFile: return LocalFile;
    default: return NoAnswer;
    }
}

Result<settings::Profile> profileOf(const QCommandLineParser &parser)
{
    settings::SettingsFile stored;
    const auto named = settings::namedController(parser, settings::ProfileStore {stored});
    if (!named)
        return tl::unexpected(named.error());
    if (!*named)
        return values::badInput(tr("Name the controller with --host or --profile."));
    return **named;
}

std::optional<ExitCode> parse(QCommandLineParser &parser, const QStringList &arguments, const QString &words)
{
    const QCommandLineOption help {{QStringLiteral("h"), QStringLiteral("help")}, tr("Print this and end.")};
    parser.addOption(help);
    if (!parser.parse(arguments)) {
        complain(parser.errorText() + QLatin1Char(' ') + tr("See pendeskctl %1 --help.").arg(arguments.first()));
        return Usage;
    }
    if (parser.isSet(help)) {
        // Qt writes the program's path where a person types the program and the verb.
        const QString program = QStringLiteral("pendeskctl ") + arguments.first();
        QString text = parser.helpText().replace(QCoreApplication::arguments().constFirst(), program);
        if (!words.isEmpty())
            text.insert(text.indexOf(u'\n'), u' ' + words);
        print(text.trimmed());
        return Done;
    }
    return std::nullopt;
}

std::optional<ExitCode> read(Call &call, QCommandLineParser &parser, const VerbHelp &help, const QStringList &arguments)
{
    parser.setApplicationDescription(help.description);
    parser.setOptionsAfterPositionalArgumentsMode(QCommandLineParser::ParseAsOptions);
    addCommonOptions(parser, help.needsController);
    parser.addOptions(help.options);
    if (const auto end = parse(parser, arguments, help.words))
        return end;
    settings::applyLogOption(parser);
    call.words = parser.positionalArguments();
    call.isJson = parser.isSet(QStringLiteral("json"));
    call.isQuiet = parser.isSet(QStringLiteral("quiet"));
    call.mayWrite = parser.isSet(QStringLiteral("yes"));
    const auto controller = help.needsController ? readController(call, parser) : Result<void> {};
    if (controller)
        return std::nullopt;
    complain(controller.error().detail);
    return Usage;
}

std::optional<ExitCode> requireYes(const Call &call)
{
    if (call.mayWrite)
        return std::nullopt;
    complain(tr("This changes something at the controller or on this computer. Add --yes to do it."));
    return Usage;
}

void complain(const QString &sentence) { std::fprintf(stderr, "pendeskctl: %s\n", qUtf8Printable(sentence)); }

ExitCode mistake(const QString &sentence)
{
    complain(sentence);
    return Usage;
}

void print(const QString &line)
{
    std::fprintf(stdout, "%s\n", qUtf8Printable(line));
    std::fflush(stdout);
}

void print(const QJsonValue &json)
{
    const QJsonDocument document = json.isArray() ? QJsonDocument {json.toArray()} : QJsonDocument {json.toObject()};
    print(QString::fromUtf8(document.toJson(QJsonDocument::Compact)));
}

void showProgress(const Call &call, const QString &line)
{
    if (call.isQuiet || !isTerminal())
        return;
    std::fprintf(stderr, "\r\x1b[K%s", qUtf8Printable(line));
    std::fflush(stderr);
}

} // namespace pendeskctl
