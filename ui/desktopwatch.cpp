// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/desktopwatch.h"

#include <QDBusConnection>

namespace ui {

DesktopWatch::DesktopWatch(QObject *parent) : QObject(parent)
{
    const QString manager = QStringLiteral("org.freedesktop.login1.Manager");
    const QString session = QStringLiteral("org.freedesktop.login1.Session");
    QDBusConnection system = QDBusConnection::systemBus();
    system.connect({}, {}, manager, QStringLiteral("PrepareForSleep"), this, SLOT(onPrepareForSleep(bool)));
    system.connect({}, {}, session, QStringLiteral("Lock"), this, SIGNAL(screenLocked()));
    QDBusConnection desktop = QDBusConnection::sessionBus();
    for (const char *name : {"org.freedesktop.ScreenSaver", "org.gnome.ScreenSaver"})
        desktop.connect(
            {}, {}, QLatin1String(name), QStringLiteral("ActiveChanged"), this, SLOT(onActiveChanged(bool)));
}

void DesktopWatch::onPrepareForSleep(bool isBeginning)
{
    if (isBeginning)
        Q_EMIT sleepBegun();
}

void DesktopWatch::onActiveChanged(bool isActive)
{
    if (isActive)
        Q_EMIT screenLocked();
}

} // namespace ui
