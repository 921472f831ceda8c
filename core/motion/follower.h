// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "motion/stepengine.h"
#include "values/position.h"

namespace motion {

/// The two are the same place: 0.05 mm, 0.02 degrees, 20 pulses. Positions of different types never are.
[[nodiscard]] bool isSamePlace(const values::Position &a, const values::Position &b);

/// What became of a move that was sent once: nobody but the robot knows, so it is watched until it rests. Pure, like
/// the step engine.
class Follower
{
public:
    enum class Outcome {
        UnderWay,
        Refused,
        Arrived, ///< It rests where it should.
        Stopped, ///< It rests elsewhere: position() says where.
        Rested, ///< It rests at position(), and where it should was not known here.
        Unknown, ///< Not answered, communication lost, or it does not come to rest: look at the robot.
    };

    /// `target` is of the type of the positions that will be read; nullopt where it cannot be foretold. `expected` is
    /// how long it should take.
    Follower(const std::optional<values::Position> &target, Time sentAt, std::chrono::milliseconds expected);

    /// What was found out first holds; later news change nothing. A reply that is not known ends it as Unknown at once.
    Outcome takeReply(StepEngine::Reply reply, Time now);
    Outcome takeStatus(bool isRunning, Time now);
    /// A position that was asked for after the last status arrived.
    Outcome takePosition(const values::Position &position, Time now);
    Outcome loseLink();
    Outcome tick(Time now);

    [[nodiscard]] Outcome outcome() const { return m_outcome; }
    /// Where it was last.
    [[nodiscard]] const std::optional<values::Position> &position() const { return m_position; }

private:
    Outcome end(Outcome outcome);

    std::optional<values::Position> m_target;
    Time m_deadline;
    std::optional<Time> m_acceptedAt;
    bool m_hasRun = false;
    bool m_isResting = false; ///< By the last status, after it must have begun.
    std::optional<values::Position> m_position;
    std::optional<values::Position> m_restedAt; ///< The first position while resting.
    Outcome m_outcome = Outcome::UnderWay;
};

} // namespace motion
