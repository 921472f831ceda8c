// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/language.h"

#include <QCoreApplication>
#include <QLibraryInfo>
#include <QLocale>
#include <QTranslator>
#include <algorithm>

namespace ui {

namespace {

constexpr Language languageRows[] {
    {"en", "English"},
    {"de", "Deutsch"},
    {"ja", "日本語"},
    {"zh_CN", "简体中文"},
    {"ko", "한국어"},
    {"es", "Español"},
    {"fr", "Français"},
};

/// Replaces what was spoken before: translators are children of the application with this name.
void install(QCoreApplication &application, const QString &file, const QString &folder)
{
    auto *translator = new QTranslator(&application);
    translator->setObjectName(QStringLiteral("language"));
    if (translator->load(file, folder))
        QCoreApplication::installTranslator(translator);
    else
        delete translator;
}

} // namespace

std::span<const Language> languages() { return languageRows; }

QString desktopLanguage()
{
    for (const QString &wanted : QLocale::system().uiLanguages()) {
        for (const Language &row : languageRows) {
            const QLocale locale {QLatin1String(row.code)};
            if (QLocale(wanted).language() == locale.language() && QLocale(wanted).script() == locale.script())
                return QLatin1String(row.code);
        }
    }
    return QStringLiteral("en");
}

bool speak(QCoreApplication &application, const QString &code)
{
    if (std::ranges::none_of(languageRows, [&](const Language &row) { return code == QLatin1String(row.code); }))
        return false;
    qDeleteAll(application.findChildren<QTranslator *>(QStringLiteral("language")));
    QLocale::setDefault(QLocale(code));
    install(application, QStringLiteral("qtbase_") + code, QLibraryInfo::path(QLibraryInfo::TranslationsPath));
    install(application, QStringLiteral("pendesk_") + code, QStringLiteral(":/translations"));
    return true;
}

} // namespace ui
