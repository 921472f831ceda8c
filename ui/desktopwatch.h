// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include <QObject>

namespace ui {

/// Hears from the desktop, over D-Bus, that its screen is locked or that the computer goes to sleep: from logind and
/// from the screen saver. Where there is no bus it says nothing.
class DesktopWatch : public QObject
{
    Q_OBJECT

public:
    explicit DesktopWatch(QObject *parent = nullptr);

Q_SIGNALS:
    void screenLocked();
    void sleepBegun();

private Q_SLOTS:
    void onPrepareForSleep(bool isBeginning);
    void onActiveChanged(bool isActive);
};

} // namespace ui
