// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "robot/access.h"

using namespace std::chrono_literals;

namespace robot {

Access::Access(settings::AccessSettings settings, QObject *parent)
    : QObject {parent}, m_settings {std::move(settings)}, m_lastActivity {now()}
{
    connect(&m_clock, &QTimer::timeout, this, [this] { tick(now()); });
}

void Access::restrictToMonitor()
{
    m_isMonitorOnly = true;
    setLevel(Level::Monitor);
}

bool Access::needsPasscode(Level level) const { return level > m_level && m_settings.passcode.has_value(); }

Access::Answer Access::enter(Level level, const QString &passcode)
{
    if (m_isMonitorOnly && level != Level::Monitor)
        return Answer::MonitorOnly;
    if (needsPasscode(level) && !m_settings.passcode->matches(passcode))
        return Answer::WrongPasscode;
    noteActivity(now());
    setLevel(level);
    return Answer::Entered;
}

void Access::setSettings(const settings::AccessSettings &settings)
{
    m_settings = settings;
    Q_EMIT settingsChanged();
}

void Access::tick(Time now)
{
    if (now - m_lastActivity >= m_settings.idleTime)
        setLevel(Level::Monitor);
}

void Access::setLevel(Level level)
{
    if (std::exchange(m_level, level) == level)
        return;
    if (level == Level::Monitor)
        m_clock.stop();
    else
        m_clock.start(5s);
    Q_EMIT levelChanged();
}

} // namespace robot
