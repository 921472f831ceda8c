// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "options.h"

#include "settings/commandline.h"
#include "settings/settingsfile.h"
#include "values/foreigntext.h"
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QRegularExpression>
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

/// Before a negative number while the options are parsed: without it "-7" would be an option.
constexpr QChar numberMark {0xE000};

QStringList marked(QStringList arguments)
{
    static const QRegularExpression negative {QStringLiteral("^-[.,]?[0-9]")};
    for (QString &argument : arguments) {
        if (argument.contains(negative))
            argument.prepend(numberMark);
    }
    return arguments;
}

void addCommonOptions(QCommandLineParser &parser, bool needsController)
{
    if (needsController) {
        settings::addConnectionOptions(parser);
        parser.addOption({QStringLiteral("numbering"),
            tr("Instance of the first variable on this controller, 0 or 1 (parameter RS022)."), QStringLiteral("0|1")});
        parser.addOption({QStringLiteral("encoding"),
            tr("The encoding of the pendant's language instead of the stored one: %1.").arg(encodingList()),
            QStringLiteral("NAME")});
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
    if (parser.isSet(QStringLiteral("encoding"))) {
        const auto encoding = protocol::findEncoding(parser.value(QStringLiteral("encoding")));
        if (!encoding)
            return values::badInput(tr("--encoding takes one of %1.").arg(encodingList()));
        call.profile.encoding = *encoding;
    }
    call.hasNumbering = parser.isSet(QStringLiteral("numbering"));
    call.hasModel = parser.isSet(QStringLiteral("model")) || parser.isSet(QStringLiteral("profile"));
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

QString encodingList()
{
    QStringList keys;
    for (const protocol::EncodingName &row : protocol::encodings())
        keys << QLatin1String(row.key);
    return keys.join(QStringLiteral(", "));
}

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
    if (!parser.parse(marked(arguments))) {
        complain(parser.errorText() + QLatin1Char(' ') + tr("See pendeskctl %1 --help.").arg(arguments.first()));
        return Usage;
    }
    if (parser.isSet(help)) {
        // Qt writes the program's path where a person types the program and the verb.
        const QString program = QStringLiteral("pendeskctl ") + arguments.first();
        QString text = parser.helpText().replace(QCoreApplication::arguments().constFirst(), program);
        if (!words.isEmpty())
            text.insert(text.indexOf(u'\n'), u' ' + words);
        print(text.trimmed().split(u'\n'));
        return Done;
    }
    return std::nullopt;
}

QStringList wordsOf(const QCommandLineParser &parser)
{
    QStringList words = parser.positionalArguments();
    for (QString &word : words)
        word.remove(numberMark);
    return words;
}

std::optional<int> numberOf(const QCommandLineParser &parser, const QCommandLineOption &option)
{
    bool isNumber = false;
    const int number = parser.value(option).toInt(&isNumber);
    if (isNumber && number >= 0)
        return number;
    complain(tr("--%1 takes a whole number that is not negative.").arg(option.names().constFirst()));
    return std::nullopt;
}

namespace {

/// What a verb does not take is a mistake, not something to pass over.
std::optional<ExitCode> countWords(const QStringList &words, const VerbHelp &help, const QString &verb)
{
    if (words.size() > help.mostWords)
        return mistake(tr("%1 does not take “%2”. See pendeskctl %1 --help.").arg(verb, words[help.mostWords]));
    if (words.size() < help.fewestWords)
        return mistake(tr("%1 takes %2. See pendeskctl %1 --help.").arg(verb, help.words));
    return std::nullopt;
}

} // namespace

std::optional<ExitCode> read(Call &call, QCommandLineParser &parser, const VerbHelp &help, const QStringList &arguments)
{
    parser.setApplicationDescription(help.description);
    parser.setOptionsAfterPositionalArgumentsMode(QCommandLineParser::ParseAsOptions);
    addCommonOptions(parser, help.needsController);
    parser.addOptions(help.options);
    if (const auto end = parse(parser, arguments, help.words))
        return end;
    settings::applyLogOption(parser);
    call.words = wordsOf(parser);
    if (const auto end = countWords(call.words, help, arguments.first()))
        return end;
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

void complain(const QString &sentence)
{
    std::fprintf(stderr, "pendeskctl: %s\n", qUtf8Printable(values::oneLine(sentence)));
}

ExitCode mistake(const QString &sentence)
{
    complain(sentence);
    return Usage;
}

void print(const QString &line)
{
    std::fprintf(stdout, "%s\n", qUtf8Printable(values::oneLine(line)));
    std::fflush(stdout);
}

void print(const QStringList &lines)
{
    for (const QString &line : lines)
        print(line);
}

void print(const QJsonValue &json, QJsonDocument::JsonFormat format)
{
    const QJsonDocument document = json.isArray() ? QJsonDocument {json.toArray()} : QJsonDocument {json.toObject()};
    std::fprintf(stdout, "%s\n", values::plainJson(document.toJson(format)).trimmed().constData());
    std::fflush(stdout);
}

void showProgress(const Call &call, const QString &line)
{
    if (call.isQuiet || !isTerminal())
        return;
    std::fprintf(stderr, "\r\x1b[K%s", qUtf8Printable(values::oneLine(line)));
    std::fflush(stderr);
}

} // namespace pendeskctl
