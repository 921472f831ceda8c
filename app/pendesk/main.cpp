// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "demo.h"
#include "options.h"
#include "pictures.h"
#include "settings/settingsfile.h"
#include "timings.h"
#include "ui/appearance.h"
#include "ui/mainwindow.h"
#include "ui/presence.h"
#include <QApplication>
#include <QStatusBar>
#include <cstdio>

using namespace pendesk;

namespace {

void name(const char *program)
{
    QCoreApplication::setApplicationName(QLatin1String(program));
    QCoreApplication::setOrganizationName(QLatin1String(program));
    QCoreApplication::setApplicationVersion(QStringLiteral(PENDESK_VERSION));
}

QtMessageHandler otherMessages = nullptr;

/// The offscreen plugin complains of every window that has a least size; nobody can help it.
void dropNoise(QtMsgType type, const QMessageLogContext &context, const QString &text)
{
    if (text != u"This plugin does not support propagateSizeHints()")
        otherMessages(type, context, text);
}

int complain(const QString &sentence, ExitCode code)
{
    std::fprintf(stderr, "pendesk: %s\n", qUtf8Printable(sentence));
    return code;
}

/// What the options say, else what the person chose the last time.
settings::Appearance wantedLook(const Options &options, const settings::ProfileStore &store)
{
    settings::Appearance look = store.appearance();
    if (!options.language.isEmpty())
        look.language = options.language;
    if (!options.scheme.isEmpty())
        look.scheme = options.scheme;
    return look;
}

/// The controller that the options ask for; the demo is started for it.
values::Result<std::optional<settings::Profile>> wanted(const Options &options, Demo &demo)
{
    if (!options.isDemo)
        return options.target;
    return demo.start().map([](const settings::Profile &profile) { return std::optional(profile); });
}

/// Reads the options without a screen: help and mistakes need none.
values::Result<Options> readOptions(int argc, char *argv[])
{
    const QCoreApplication application {argc, argv};
    settings::SettingsFile file;
    return parse(QCoreApplication::arguments(), settings::ProfileStore {file});
}

int run(const Options &options, QApplication &application)
{
    settings::SettingsFile file;
    settings::ProfileStore store {file};
    ui::wear(application, wantedLook(options, store));
    Demo demo;
    const auto target = wanted(options, demo);
    if (!target)
        return complain(target.error().detail, NoAnswer);
    robot::AccessRules rules {settings::readAccess(file)};
    robot::Arming arming;
    if (options.isMonitorOnly)
        rules.restrictToMonitor();
    const ui::Presence presence {rules, arming};
    QObject::connect(
        &rules, &robot::AccessRules::settingsChanged, &rules, [&] { settings::writeAccess(file, rules.settings()); });
    journal::Store journal;
    station::Fleet fleet {{store, rules, arming, journal}};
    ui::MainWindow window {fleet, [&demo] { return demo.start(); }};
    window.offer(target->value_or(store.find(store.lastUsed()).value_or(settings::Profile {})));
    std::optional<Timings> timings;
    if (options.wantsTimings)
        timings.emplace(window);
    QStatusBar *status = window.statusBar();
    const auto say = [status](const QString &sentence) { status->showMessage(sentence); };
    QObject::connect(&file, &settings::SettingsFile::failed, status, say);
    QObject::connect(&file, &settings::SettingsFile::noticed, status, say);
    QObject::connect(&file, &settings::SettingsFile::recovered, status, &QStatusBar::clearMessage);
    if (!file.notice().isEmpty())
        say(file.notice());
    window.show();
    Pictures pictures {window};
    if (!options.pictures.isEmpty())
        pictures.writeFiles(options.pictures);
    else if (!options.contactSheet.isEmpty())
        pictures.writeSheet(options.contactSheet, {QStringLiteral("en"), QStringLiteral("de"), QStringLiteral("ja")});
    else if (*target)
        window.connectTo(**target);
    return QApplication::exec();
}

} // namespace

int main(int argc, char *argv[])
{
    name("pendesk");
    const auto options = readOptions(argc, argv);
    if (!options)
        return complain(options.error().detail + QStringLiteral(" See pendesk --help."), Usage);
    if (!options->text.isEmpty())
        return std::fputs(qUtf8Printable(options->text), stdout) < 0 ? LocalFile : Done;
    QGuiApplication::setDesktopFileName(QStringLiteral(PENDESK_ID));
    otherMessages = qInstallMessageHandler(dropNoise);
    QApplication application {argc, argv};
    return run(*options, application);
}
