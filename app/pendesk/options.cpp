// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "options.h"

#include "settings/commandline.h"
#include "ui/language.h"
#include <QCommandLineParser>
#include <QCoreApplication>

namespace pendesk {

namespace {

struct Texts {
    Q_DECLARE_TR_FUNCTIONS(pendesk)
};

void describe(QCommandLineParser &parser)
{
    const auto add = [&](const char *name, const QString &what, const QString &value = {}) {
        parser.addOption({QLatin1String(name), what, value});
    };
    parser.setApplicationDescription(Texts::tr("A teach and monitor desk for Yaskawa robot controllers."));
    parser.addHelpOption();
    parser.addVersionOption();
    add("demo", Texts::tr("Connect to a simulated controller inside the program."));
    settings::addConnectionOptions(parser);
    add("theme", Texts::tr("light, dark, or auto for the desktop's choice."), QStringLiteral("T"));
    add("language", Texts::tr("Language of the window, as a code such as de; the desktop's unless told otherwise."),
        QStringLiteral("CODE"));
    add("monitor-only", Texts::tr("Allow watching, HOLD and servo off alone, whatever the person at the desk tries."));
    add("pictures", Texts::tr("Write pictures of every page to this folder, print the status read, and end."),
        QStringLiteral("DIR"));
    add("contact-sheet",
        Texts::tr("Write one picture of all pages, light and dark, in English, German and Japanese, and end."),
        QStringLiteral("FILE"));
    settings::addLogOption(parser);
    add("timings", Texts::tr("Print when the window was painted and when the first status was live."));
}

/// Which controller, if any.
values::Result<void> readTarget(const QCommandLineParser &parser, const settings::ProfileStore &store, Options &options)
{
    options.isDemo = parser.isSet(QStringLiteral("demo"));
    const auto target = settings::namedController(parser, store);
    if (!target)
        return tl::unexpected(target.error());
    if (options.isDemo && *target)
        return values::badInput(Texts::tr("--demo brings its own controller: leave out --host and --profile."));
    options.target = *target;
    return {};
}

values::Result<void> readTheme(const QCommandLineParser &parser, Options &options)
{
    const QString theme = parser.value(QStringLiteral("theme"));
    if (!parser.isSet(QStringLiteral("theme")) || theme == u"auto")
        return {};
    options.scheme = theme;
    if (!ui::schemeFromName(theme))
        return values::badInput(Texts::tr("--theme must be light, dark or auto."));
    return {};
}

values::Result<void> readLanguage(const QCommandLineParser &parser, Options &options)
{
    if (!parser.isSet(QStringLiteral("language")))
        return {};
    options.language = parser.value(QStringLiteral("language"));
    QStringList known;
    for (const ui::Language &language : ui::languages())
        known << QLatin1String(language.code);
    if (!known.contains(options.language))
        return values::badInput(Texts::tr("--language must be one of: %1.").arg(known.join(u", ")));
    return {};
}

} // namespace

values::Result<Options> parse(const QStringList &arguments, const settings::ProfileStore &store)
{
    QCommandLineParser parser;
    describe(parser);
    if (!parser.parse(arguments))
        return values::badInput(parser.errorText());
    settings::applyLogOption(parser);
    Options options;
    if (parser.isSet(QStringLiteral("help")))
        options.text = parser.helpText();
    else if (parser.isSet(QStringLiteral("version")))
        options.text = QStringLiteral("pendesk %1\n").arg(QCoreApplication::applicationVersion());
    if (!options.text.isEmpty())
        return options;
    if (!parser.positionalArguments().isEmpty())
        return values::badInput(Texts::tr("“%1” is not an option.").arg(parser.positionalArguments().constFirst()));
    if (const auto theme = readTheme(parser, options); !theme)
        return tl::unexpected(theme.error());
    if (const auto language = readLanguage(parser, options); !language)
        return tl::unexpected(language.error());
    if (const auto read = readTarget(parser, store, options); !read)
        return tl::unexpected(read.error());
    options.isMonitorOnly = parser.isSet(QStringLiteral("monitor-only"));
    options.wantsTimings = parser.isSet(QStringLiteral("timings"));
    options.pictures = parser.value(QStringLiteral("pictures"));
    options.contactSheet = parser.value(QStringLiteral("contact-sheet"));
    const bool hasController = options.isDemo || options.target;
    if (parser.isSet(QStringLiteral("pictures")) && (options.pictures.isEmpty() || !hasController))
        return values::badInput(Texts::tr("--pictures needs a folder, and --demo, --host or --profile."));
    if (parser.isSet(QStringLiteral("contact-sheet")) && (options.contactSheet.isEmpty() || !hasController))
        return values::badInput(Texts::tr("--contact-sheet needs a file, and --demo, --host or --profile."));
    return options;
}

} // namespace pendesk
