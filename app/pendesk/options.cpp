// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "options.h"

#include <QCommandLineParser>
#include <QCoreApplication>

namespace pendesk {

namespace {

struct Texts {
    Q_DECLARE_TR_FUNCTIONS(pendesk)
};

tl::unexpected<values::Error> mistake(const QString &sentence)
{
    return values::failure(values::ErrorKind::BadInput, sentence);
}

void describe(QCommandLineParser &parser)
{
    const auto add = [&](const char *name, const QString &what, const QString &value = {}) {
        parser.addOption({QLatin1String(name), what, value});
    };
    parser.setApplicationDescription(Texts::tr("A teach and monitor desk for Yaskawa robot controllers."));
    parser.addHelpOption();
    parser.addVersionOption();
    add("demo", Texts::tr("Connect to a simulated controller inside the program."));
    add("host", Texts::tr("Connect to the controller with this name or IPv4 address."), QStringLiteral("H"));
    add("port", Texts::tr("Its port for robot control, 10040 unless told otherwise."), QStringLiteral("N"));
    add("file-port", Texts::tr("Its port for file control, 10041 unless told otherwise."), QStringLiteral("N"));
    add("profile", Texts::tr("Connect to the controller that is stored under this name."), QStringLiteral("NAME"));
    add("theme", Texts::tr("light, dark, or auto for the desktop's choice."), QStringLiteral("T"));
    add("monitor-only", Texts::tr("Allow watching and HOLD alone. This release does nothing else."));
    add("pictures", Texts::tr("Write pictures of every page to this folder, print the status read, and end."),
        QStringLiteral("DIR"));
}

values::Result<void> readPort(const QCommandLineParser &parser, const QString &option, quint16 &port)
{
    if (!parser.isSet(option))
        return {};
    bool isNumber = false;
    const int value = parser.value(option).toInt(&isNumber);
    if (!isNumber || value < 1 || value > 65535)
        return mistake(Texts::tr("--%1 must be a whole number from 1 to 65535.").arg(option));
    port = quint16(value);
    return {};
}

values::Result<settings::Profile> base(const QCommandLineParser &parser, const settings::ProfileStore &store)
{
    if (!parser.isSet(QStringLiteral("profile")))
        return settings::Profile {};
    const QString name = parser.value(QStringLiteral("profile"));
    if (const auto profile = store.find(name))
        return *profile;
    return mistake(Texts::tr("There is no controller stored under the name “%1”.").arg(name));
}

values::Result<settings::Profile> target(const QCommandLineParser &parser, const settings::ProfileStore &store)
{
    auto profile = base(parser, store);
    if (!profile)
        return profile;
    if (parser.isSet(QStringLiteral("host"))) {
        profile->host = parser.value(QStringLiteral("host"));
        if (profile->name.isEmpty())
            profile->name = profile->host;
    }
    for (auto [option, port] : {std::pair {QStringLiteral("port"), &profile->port},
             std::pair {QStringLiteral("file-port"), &profile->filePort}}) {
        if (const auto read = readPort(parser, option, *port); !read)
            return tl::unexpected(read.error());
    }
    if (const QString complaint = settings::complaint(*profile); !complaint.isEmpty())
        return mistake(complaint);
    return profile;
}

/// Which controller, if any.
values::Result<void> readTarget(const QCommandLineParser &parser, const settings::ProfileStore &store, Options &options)
{
    const bool hasTarget = parser.isSet(QStringLiteral("host")) || parser.isSet(QStringLiteral("profile"));
    options.isDemo = parser.isSet(QStringLiteral("demo"));
    if (options.isDemo && hasTarget)
        return mistake(Texts::tr("--demo brings its own controller: leave out --host and --profile."));
    if (!hasTarget && (parser.isSet(QStringLiteral("port")) || parser.isSet(QStringLiteral("file-port"))))
        return mistake(Texts::tr("--port and --file-port need --host or --profile."));
    if (!hasTarget)
        return {};
    auto profile = target(parser, store);
    if (!profile)
        return tl::unexpected(profile.error());
    options.target = *profile;
    return {};
}

} // namespace

values::Result<Options> parse(
    const QStringList &arguments, const settings::ProfileStore &store, const QPalette &desktop)
{
    QCommandLineParser parser;
    describe(parser);
    if (!parser.parse(arguments))
        return mistake(parser.errorText());
    Options options;
    if (parser.isSet(QStringLiteral("help")))
        options.text = parser.helpText();
    else if (parser.isSet(QStringLiteral("version")))
        options.text = QStringLiteral("pendesk %1\n").arg(QCoreApplication::applicationVersion());
    if (!options.text.isEmpty())
        return options;
    if (!parser.positionalArguments().isEmpty())
        return mistake(Texts::tr("“%1” is not an option.").arg(parser.positionalArguments().constFirst()));
    const QString theme =
        parser.isSet(QStringLiteral("theme")) ? parser.value(QStringLiteral("theme")) : QStringLiteral("auto");
    const auto scheme = ui::schemeFromOption(theme, desktop);
    if (!scheme)
        return mistake(Texts::tr("--theme must be light, dark or auto."));
    options.scheme = *scheme;
    if (const auto read = readTarget(parser, store, options); !read)
        return tl::unexpected(read.error());
    options.pictures = parser.value(QStringLiteral("pictures"));
    if (parser.isSet(QStringLiteral("pictures")) && (options.pictures.isEmpty() || !(options.isDemo || options.target)))
        return mistake(Texts::tr("--pictures needs a folder, and --demo, --host or --profile."));
    return options;
}

} // namespace pendesk
