// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/appearance.h"

#include "ui/language.h"
#include "ui/theme.h"
#include <QApplication>

namespace ui {

void wear(QApplication &application, const settings::Appearance &wanted)
{
    const Scheme scheme = schemeFromName(wanted.scheme).value_or(desktopScheme());
    if (application.styleSheet().isEmpty() || scheme != schemeOf(QApplication::palette()))
        apply(application, scheme);
    if (!speak(application, wanted.language))
        speak(application, desktopLanguage());
}

} // namespace ui
