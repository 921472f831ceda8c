// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "options.h"

#include "settings/profilestore.h"
#include <QRegularExpression>
#include <QSettings>
#include <cstdio>

using values::Error;
using values::ErrorKind;
using values::Result;

namespace pendeskctl {

namespace {

QString tr(const char *text) { return QCoreApplication::translate("pendeskctl", text); }

/// "300ms", "2s" or plain milliseconds.
std::optional<std::chrono::milliseconds> duration(const QString &text)
{
    static const QRegularExpression form {QStringLiteral("^(\\d{1,6})(ms|s)?$")};
    const auto match = form.match(text);
    if (!match.hasMatch())
        return std::nullopt;
    return std::chrono::milliseconds {match.captured(1).toLongLong() * (match.captured(2) == u"s" ? 1000 : 1)};
}

Result<quint16> portOf(const QCommandLineParser &parser, const QString &option, quint16 usual)
{
    if (!parser.isSet(option))
        return usual;
    bool isNumber = false;
    const int port = parser.value(option).toInt(&isNumber);
    if (!isNumber || port < 1 || port > 65535)
        return values::failure(ErrorKind::BadInput, tr("--%1 takes a port from 1 to 65535.").arg(option));
    return quint16(port);
}

Result<settings::Profile> basis(const QCommandLineParser &parser)
{
    settings::Profile profile;
    if (parser.isSet(QStringLiteral("profile"))) {
        QSettings stored;
        const QString name = parser.value(QStringLiteral("profile"));
        const auto found = settings::ProfileStore {stored}.find(name);
        if (!found)
            return values::failure(ErrorKind::BadInput, tr("There is no profile “%1”.").arg(name));
        profile = *found;
    } else if (!parser.isSet(QStringLiteral("host"))) {
        return values::failure(ErrorKind::BadInput, tr("Name the controller with --host or --profile."));
    }
    if (parser.isSet(QStringLiteral("host")))
        profile.host = parser.value(QStringLiteral("host"));
    if (profile.name.isEmpty())
        profile.name = profile.host;
    return profile;
}

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

void addConnectionOptions(QCommandLineParser &parser)
{
    parser.addOptions({
        {QStringLiteral("host"), tr("Name or IPv4 address of the controller."), QStringLiteral("H")},
        {QStringLiteral("port"), tr("Robot port (10040)."), QStringLiteral("N")},
        {QStringLiteral("file-port"), tr("File port (10041)."), QStringLiteral("N")},
        {QStringLiteral("profile"), tr("A controller stored with Pendesk."), QStringLiteral("NAME")},
        {QStringLiteral("timeout"), tr("Wait for one try of a read: 300ms, 1s."), QStringLiteral("TIME")},
        {QStringLiteral("json"), tr("Print JSON.")},
    });
}

Result<settings::Profile> profileOf(const QCommandLineParser &parser)
{
    auto profile = basis(parser);
    if (!profile)
        return profile;
    const auto port = portOf(parser, QStringLiteral("port"), profile->port);
    const auto filePort = portOf(parser, QStringLiteral("file-port"), profile->filePort);
    if (!port || !filePort)
        return tl::unexpected(port ? filePort.error() : port.error());
    profile->port = *port;
    profile->filePort = *filePort;
    if (parser.isSet(QStringLiteral("timeout"))) {
        const auto timeout = duration(parser.value(QStringLiteral("timeout")));
        if (!timeout)
            return values::failure(ErrorKind::BadInput, tr("--timeout takes a time such as 300ms or 1s."));
        profile->readTimeout = *timeout;
    }
    if (const QString complaint = settings::complaint(*profile); !complaint.isEmpty())
        return values::failure(ErrorKind::BadInput, complaint);
    return profile;
}

std::optional<ExitCode> parse(QCommandLineParser &parser, const QStringList &arguments)
{
    const auto help = parser.addHelpOption();
    if (!parser.parse(arguments)) {
        complain(parser.errorText() + QLatin1Char(' ') + tr("See pendeskctl %1 --help.").arg(arguments.first()));
        return Usage;
    }
    if (parser.isSet(help)) {
        print(parser.helpText());
        return Done;
    }
    return std::nullopt;
}

void complain(const QString &sentence) { std::fprintf(stderr, "pendeskctl: %s\n", qUtf8Printable(sentence)); }

void print(const QString &line) { std::fprintf(stdout, "%s\n", qUtf8Printable(line)); }

} // namespace pendeskctl
