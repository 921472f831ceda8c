// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "robot/level.h"
#include "robot/reading.h"
#include "settings/accesssettings.h"
#include <QObject>
#include <QTimer>

namespace robot {

/// The access level, one object for the whole program. It starts at Monitor and falls back to it when nobody has used
/// key or mouse for some minutes. The passcode guards against mistakes, not against attackers.
class Access : public QObject
{
    Q_OBJECT

public:
    enum class Answer { Entered, WrongPasscode, MonitorOnly };

    explicit Access(settings::AccessSettings settings = {}, QObject *parent = nullptr);

    [[nodiscard]] Level level() const { return m_level; }
    /// Takes the other levels away for as long as the program runs.
    void restrictToMonitor();
    [[nodiscard]] bool isMonitorOnly() const { return m_isMonitorOnly; }
    /// A passcode is set, and `level` is higher than the present one.
    [[nodiscard]] bool needsPasscode(Level level) const;
    /// Going down is always possible and asks for nothing.
    Answer enter(Level level, const QString &passcode = {});

    [[nodiscard]] const settings::AccessSettings &settings() const { return m_settings; }
    /// Another passcode or idle time from now on; the owner keeps them.
    void setSettings(const settings::AccessSettings &settings);

    /// Somebody used key or mouse.
    void noteActivity(Time now) { m_lastActivity = now; }
    /// Looks at the clock. It calls itself every few seconds.
    void tick(Time now);

Q_SIGNALS:
    void levelChanged();
    void settingsChanged();

private:
    void setLevel(Level level);

    settings::AccessSettings m_settings;
    Level m_level = Level::Monitor;
    bool m_isMonitorOnly = false;
    Time m_lastActivity;
    QTimer m_clock;
};

} // namespace robot
