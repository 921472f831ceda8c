// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "settings/commandline.h"

#include <QCommandLineParser>
#include <QCoreApplication>
#include <QLoggingCategory>
#include <QRegularExpression>

using values::Result;

namespace settings {

namespace {

struct Texts {
    Q_DECLARE_TR_FUNCTIONS(settings::CommandLine)
};

/// "300ms", "2s" or plain milliseconds.
std::optional<std::chrono::milliseconds> duration(const QString &text)
{
    static const QRegularExpression form {QStringLiteral("^(\\d{1,6})(ms|s)?$")};
    const auto match = form.match(text);
    if (!match.hasMatch())
        return std::nullopt;
    return std::chrono::milliseconds {match.captured(1).toLongLong() * (match.captured(2) == u"s" ? 1000 : 1)};
}

Result<void> readPort(const QCommandLineParser &parser, const QString &option, quint16 &port)
{
    if (!parser.isSet(option))
        return {};
    bool isNumber = false;
    const int value = parser.value(option).toInt(&isNumber);
    if (!isNumber || value < 1 || value > 65535)
        return values::badInput(Texts::tr("--%1 must be a whole number from 1 to 65535.").arg(option));
    port = quint16(value);
    return {};
}

Result<void> readTimeout(const QCommandLineParser &parser, std::chrono::milliseconds &timeout)
{
    if (!parser.isSet(QStringLiteral("timeout")))
        return {};
    const auto value = duration(parser.value(QStringLiteral("timeout")));
    if (!value)
        return values::badInput(Texts::tr("--timeout takes a time such as 300ms or 1s."));
    timeout = *value;
    return {};
}

Result<void> readModel(const QCommandLineParser &parser, protocol::Model &model)
{
    if (!parser.isSet(QStringLiteral("model")))
        return {};
    const auto *dialect = protocol::findDialect(parser.value(QStringLiteral("model")));
    if (!dialect)
        return values::badInput(Texts::tr("--model must be dx100, dx200, fs100, yrc1000 or yrc1000micro."));
    model = dialect->model;
    return {};
}

Result<Profile> storedOrNew(const QCommandLineParser &parser, const ProfileStore &store)
{
    if (!parser.isSet(QStringLiteral("profile")))
        return Profile {};
    const QString name = parser.value(QStringLiteral("profile"));
    if (const auto profile = store.find(name))
        return *profile;
    return values::badInput(Texts::tr("There is no controller stored under the name “%1”.").arg(name));
}

} // namespace

void addConnectionOptions(QCommandLineParser &parser)
{
    const auto add = [&](const char *name, const QString &what, const char *value) {
        parser.addOption({QLatin1String(name), what, QLatin1String(value)});
    };
    add("host", Texts::tr("Connect to the controller with this name or IPv4 address."), "H");
    add("port", Texts::tr("Its port for robot control, 10040 unless told otherwise."), "N");
    add("file-port", Texts::tr("Its port for file control, 10041 unless told otherwise."), "N");
    add("profile", Texts::tr("Connect to the controller that is stored under this name."), "NAME");
    add("model", Texts::tr("Its model: dx100, dx200, fs100, yrc1000 or yrc1000micro."), "M");
    add("timeout", Texts::tr("How long to wait for one try of a read: 300ms, 1s."), "TIME");
}

void addLogOption(QCommandLineParser &parser)
{
    parser.addOption({QStringLiteral("log"),
        Texts::tr("What to log, as \"pendesk.session=true;pendesk.journal.debug=false\"."), QStringLiteral("RULES")});
}

void applyLogOption(const QCommandLineParser &parser)
{
    if (parser.isSet(QStringLiteral("log")))
        QLoggingCategory::setFilterRules(parser.value(QStringLiteral("log")).replace(u';', u'\n'));
}

Result<std::optional<Profile>> namedController(const QCommandLineParser &parser, const ProfileStore &store)
{
    const bool isNamed = parser.isSet(QStringLiteral("host")) || parser.isSet(QStringLiteral("profile"));
    if (!isNamed) {
        for (const char *option : {"port", "file-port", "model", "timeout"}) {
            if (parser.isSet(QLatin1String(option)))
                return values::badInput(Texts::tr("--%1 needs --host or --profile.").arg(QLatin1String(option)));
        }
        return std::nullopt;
    }
    auto profile = storedOrNew(parser, store);
    if (!profile)
        return tl::unexpected(profile.error());
    const Profile stored = *profile;
    if (parser.isSet(QStringLiteral("host")))
        profile->host = parser.value(QStringLiteral("host"));
    if (profile->name.isEmpty())
        profile->name = profile->host;
    const auto read = readPort(parser, QStringLiteral("port"), profile->port)
                          .and_then([&] { return readPort(parser, QStringLiteral("file-port"), profile->filePort); })
                          .and_then([&] { return readModel(parser, profile->model); })
                          .and_then([&] { return readTimeout(parser, profile->readTimeout); });
    if (!read)
        return tl::unexpected(read.error());
    if (profile->host != stored.host || profile->port != stored.port)
        profile->numberingVerified = {}; // perhaps another controller
    if (const QString wrong = complaint(*profile); !wrong.isEmpty())
        return values::badInput(wrong);
    return *profile;
}

} // namespace settings
