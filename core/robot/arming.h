// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "robot/conditions.h"
#include "robot/reading.h"
#include "session/permit.h"
#include <QObject>
#include <QTimer>

namespace robot {

/// The only source of a session::Permit, and one object for the whole program, so that only one controller is armed at
/// a time. It is armed by hand and dropped by many things; it never survives a lost link.
class Arming : public QObject
{
    Q_OBJECT

public:
    enum class Drop {
        ByHand,
        Idle, ///< Nobody touched key or mouse for 60 s.
        FocusLost,
        ScreenLocked,
        CommunicationLost,
        ModeChanged, ///< TEACH, PLAY or REMOTE.
        Alarm,
        AccessDropped,
        Disconnected, ///< The connection was closed, or opened anew with other settings.
        LanguageChanged, ///< The window was made anew.
        SecondWindow,
        StationLeft, ///< The window shows another controller.
        OtherController, ///< Another one was armed.
        Sleep, ///< The computer went to sleep.
        Standstill, ///< This program stood still, or a clock of this computer jumped.
    };
    static constexpr Milliseconds idleLimit {60'000};

    /// A standstill of this program longer than `stillness` disarms.
    explicit Arming(Milliseconds stillness = Milliseconds {250}, QObject *parent = nullptr);

    /// Arms `robot`, which stands for one controller, if every condition of Act::Arm is met; what was armed before is
    /// dropped. Returns whether it is armed.
    bool arm(const QObject &robot, const Situation &situation, Time now);
    /// Does nothing while nothing is armed.
    void drop(Drop reason);

    [[nodiscard]] bool isArmed() const { return m_robot; }
    [[nodiscard]] bool isArmed(const QObject &robot) const { return m_robot == &robot; }
    /// What is known of `robot` now; drops if that does not allow staying armed.
    void follow(const QObject &robot, const Situation &situation);
    /// Somebody used key or mouse; too late if it dropped for want of them.
    void noteActivity(Time now);
    /// Looks at the clock: nobody used key or mouse.
    void tick(Time now);
    /// Looks at all clocks: this program stood still, or a clock jumped, since the last look. It calls itself ten times
    /// a second while something is armed; Orders calls it before each order.
    void tick(const values::Clocks &clocks);
    /// Until it drops for want of key and mouse; 0 while nothing is armed.
    [[nodiscard]] Milliseconds remaining(Time now) const;

    /// Calls `function` with a permit, within this call and never later, if `robot` is armed. Returns whether it was.
    template <typename Function> bool withPermit(const QObject &robot, Function &&function) const
    {
        if (!isArmed(robot))
            return false;
        const session::Permit permit;
        function(permit);
        return true;
    }

Q_SIGNALS:
    void changed();
    /// `robot` is armed no longer. Comes before changed().
    void dropped(const QObject *robot, robot::Arming::Drop reason);

private:
    const QObject *m_robot = nullptr; ///< Compared, never looked into.
    values::Status::Data1 m_mode; ///< TEACH, PLAY and REMOTE when it was armed.
    Time m_lastActivity {};
    Milliseconds m_stillness;
    values::Clocks m_lastTick;
    QTimer m_clock;
};

} // namespace robot
