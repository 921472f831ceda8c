// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "robot/access.h"

#include <QPointer>

using namespace std::chrono_literals;

namespace robot {

AccessRules::AccessRules(settings::AccessSettings settings, QObject *parent)
    : QObject {parent}, m_settings {std::move(settings)}, m_lastActivity {now()}
{
}

void AccessRules::restrictToMonitor()
{
    m_isMonitorOnly = true;
    Q_EMIT restricted();
}

void AccessRules::setSettings(const settings::AccessSettings &settings)
{
    m_settings = settings;
    Q_EMIT settingsChanged();
}

void AccessRules::noteActivity(Time now)
{
    if (now - m_lastActivity >= m_settings.idleTime)
        Q_EMIT idleTimePassed();
    m_lastActivity = now;
}

Access::Access(AccessRules &rules, QObject *parent) : QObject {parent}, m_rules {rules}
{
    for (const auto signal : {&AccessRules::restricted, &AccessRules::idleTimePassed})
        connect(&rules, signal, this, [this] { setLevel(Level::Monitor); });
    connect(&m_clock, &QTimer::timeout, this, [this] { tick(now()); });
}

bool Access::needsPasscode(Level level) const { return level > m_level && m_rules.settings().passcode.has_value(); }

Access::Answer Access::enter(Level level)
{
    if (m_rules.isMonitorOnly() && level != Level::Monitor)
        return Answer::MonitorOnly;
    return needsPasscode(level) ? Answer::WrongPasscode : goTo(level);
}

void Access::enter(Level level, const QString &passcode, QObject *context, std::function<void(Answer)> handler)
{
    const settings::Passcode kept = m_rules.settings().passcode.value_or(settings::Passcode {});
    const QPointer<QObject> guard {context};
    m_checking.run(
        this, [kept, passcode] { return check(kept, passcode); },
        [this, level, kept, guard, handler = std::move(handler)](const Check &found) {
            if (guard)
                handler(onChecked(level, kept, found));
        });
}

Access::Check Access::check(const settings::Passcode &passcode, const QString &text)
{
    Check found {passcode.matches(text), std::nullopt};
    if (found.isRight && passcode.isOutdated())
        found.renewed = settings::Passcode::of(text);
    return found;
}

Access::Answer Access::onChecked(Level level, const settings::Passcode &kept, const Check &found)
{
    if (m_rules.isMonitorOnly() && level != Level::Monitor)
        return Answer::MonitorOnly;
    const bool isStill = m_rules.settings().passcode == kept; // nobody set another one meanwhile
    if (needsPasscode(level) && !(found.isRight && isStill))
        return Answer::WrongPasscode;
    if (found.renewed && isStill)
        m_rules.setSettings({m_rules.settings().idleTime, found.renewed});
    return goTo(level);
}

Access::Answer Access::goTo(Level level)
{
    m_rules.noteActivity(now());
    setLevel(level);
    return Answer::Entered;
}

void Access::tick(Time now)
{
    if (now - m_rules.lastActivity() >= m_rules.settings().idleTime)
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
