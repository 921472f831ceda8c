// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "values/clock.h"
#include <optional>

namespace motion {

using values::Time;

/// Decides when a jog step may be sent. It knows no socket, no clock and no button: everything that happens is told to
/// it with the time at which it is seen, and it answers what is to be done at once.
///
/// A step is sent only while the button is down, the window is active, the controller is armed, the step before is
/// finished, and a status younger than 300 ms allows motion. Whatever ends one of these takes the button for released:
/// it must be pressed anew. So after any loss there is at most the one step that was on its way, and it is held.
class StepEngine
{
public:
    static constexpr std::chrono::milliseconds statusLimit {300};
    /// Nothing was told for so long: the computer slept, or this program stood still. Nobody knows what the button did.
    static constexpr std::chrono::milliseconds pauseLimit {300};
    /// A step that was accepted runs within this time, or has been so short that nobody saw it.
    static constexpr std::chrono::milliseconds startLimit {250};
    /// A step that takes longer is in doubt. The slowest one, 10 mm at 1 mm/s, takes 10 s.
    static constexpr std::chrono::seconds stepLimit {15};

    /// What is to be done now.
    enum class Act {
        Nothing,
        Step, ///< Send one step for button(), once. The engine takes it for sent.
        Hold, ///< HOLD on.
    };
    /// How far the step is.
    enum class Progress {
        Idle, ///< None is on its way.
        Sent, ///< Not answered yet.
        Moving, ///< Accepted, or nobody knows; not finished yet.
    };
    enum class Reply { Accepted, Refused, Unknown };

    /// What a status says that was read now.
    struct Status {
        bool isRunning = false;
        bool allowsMotion = false; ///< REMOTE, PLAY, servo on, no hold, no alarm, no error. Apart from running.
    };

    /// A button went down. Without arming and an active window it counts as not pressed.
    [[nodiscard]] Act press(int button, Time now);
    [[nodiscard]] Act release(Time now);
    [[nodiscard]] Act setArmed(bool isArmed, Time now);
    [[nodiscard]] Act setWindowActive(bool isActive, Time now);
    [[nodiscard]] Act takeStatus(const Status &status, Time now);
    /// The answer to the step that was sent; one that nobody waits for is ignored.
    [[nodiscard]] Act takeReply(Reply reply, Time now);
    [[nodiscard]] Act loseLink(Time now);
    /// Call it at least every 100 ms while a button is down.
    [[nodiscard]] Act tick(Time now);

    /// The button that is down and counts; nullopt without one.
    [[nodiscard]] std::optional<int> button() const { return m_button; }
    [[nodiscard]] Progress progress() const { return m_progress; }

private:
    [[nodiscard]] Act look(Time now);
    [[nodiscard]] Act lose();
    [[nodiscard]] bool mayStep(Time now) const;
    void begin(Time now);
    void settle(Time now);

    std::optional<int> m_button;
    bool m_isArmed = false;
    bool m_isActive = false;
    std::optional<Time> m_statusAt; ///< When a status was read that still counts.
    Status m_status;
    Progress m_progress = Progress::Idle;
    Time m_sentAt {};
    bool m_hasRun = false; ///< The step was seen running.
    Time m_acceptedAt {};
    bool m_isHeld = false; ///< HOLD was ordered for the step; once is enough, it is carried through.
    std::optional<Time> m_now; ///< When something was told last.
};

} // namespace motion
