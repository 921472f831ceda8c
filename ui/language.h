// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include <QString>
#include <span>

class QCoreApplication;

namespace ui {

/// A language of the window: one row for each file in translations/. That of English has the plurals alone.
struct Language {
    const char *code; ///< ISO 639, with the script where there are two: "zh_CN".
    const char *name; ///< In itself, UTF-8: "Deutsch".
};

[[nodiscard]] std::span<const Language> languages();

/// The code of the language that fits the desktop best; English if none does.
[[nodiscard]] QString desktopLanguage();

/// Speaks the language from now on, and writes numbers and dates its way. A MainWindow that exists makes its words
/// anew. False, and nothing changes, if there is no such language.
bool speak(QCoreApplication &application, const QString &code);

} // namespace ui
