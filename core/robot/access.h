// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "disk/worker.h"
#include "robot/level.h"
#include "robot/reading.h"
#include "settings/accesssettings.h"
#include <QObject>
#include <QTimer>

namespace robot {

/// What this program allows at most, and how one gets there: one object for all controllers. The passcode guards
/// against mistakes, not against attackers.
class AccessRules : public QObject
{
    Q_OBJECT

public:
    explicit AccessRules(settings::AccessSettings settings = {}, QObject *parent = nullptr);

    /// Takes the other levels away for as long as the program runs.
    void restrictToMonitor();
    [[nodiscard]] bool isMonitorOnly() const { return m_isMonitorOnly; }
    [[nodiscard]] const settings::AccessSettings &settings() const { return m_settings; }
    /// Another passcode or idle time from now on; the owner keeps them.
    void setSettings(const settings::AccessSettings &settings);

    /// Somebody used key or mouse; too late for levels that have fallen back for want of them.
    void noteActivity(Time now);
    [[nodiscard]] Time lastActivity() const { return m_lastActivity; }

Q_SIGNALS:
    void settingsChanged();
    /// From now on there is Monitor alone.
    void restricted();
    /// Somebody was there again after the idle time had passed.
    void idleTimePassed();

private:
    settings::AccessSettings m_settings;
    bool m_isMonitorOnly = false;
    Time m_lastActivity;
};

/// The access level at one controller. It starts at Monitor and falls back to it when nobody has used key or mouse for
/// some minutes.
class Access : public QObject
{
    Q_OBJECT

public:
    enum class Answer { Entered, WrongPasscode, MonitorOnly };

    /// `rules` must outlive it.
    explicit Access(AccessRules &rules, QObject *parent = nullptr);

    [[nodiscard]] AccessRules &rules() const { return m_rules; }
    [[nodiscard]] Level level() const { return m_level; }
    /// A passcode is set, and `level` is higher than the present one.
    [[nodiscard]] bool needsPasscode(Level level) const;
    /// Without a passcode. Going down is always possible and asks for nothing.
    Answer enter(Level level);
    /// With one, which takes its time to check: `handler` runs from the event loop, unless `context` is gone by then. A
    /// passcode that was kept with fewer iterations than are enough today is kept anew.
    void enter(Level level, const QString &passcode, QObject *context, std::function<void(Answer)> handler);

    /// Falls back if nobody has used key or mouse for the idle time. It calls itself every few seconds.
    void tick(Time now);

Q_SIGNALS:
    void levelChanged();

private:
    struct Check {
        bool isRight = false;
        std::optional<settings::Passcode> renewed;
    };
    [[nodiscard]] static Check check(const settings::Passcode &passcode, const QString &text);
    Answer onChecked(Level level, const settings::Passcode &kept, const Check &found);
    Answer goTo(Level level);
    void setLevel(Level level);

    AccessRules &m_rules;
    Level m_level = Level::Monitor;
    QTimer m_clock;
    disk::Worker m_checking;
};

} // namespace robot
