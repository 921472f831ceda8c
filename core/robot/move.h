// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "motion/follower.h"
#include "robot/motionorders.h"
#include <QTimer>

namespace robot {

/// One move and what became of it: sent once, then followed by status and position until it rests. Deleting it ends the
/// watching, not the robot.
class Move : public QObject
{
    Q_OBJECT

public:
    using Outcome = motion::Follower::Outcome;

    /// `orders` must outlive it. `present` is what the plan was made from.
    Move(Orders &orders, const motion::Plan &plan, const motion::Present &present, QObject *parent = nullptr);

    void start();
    [[nodiscard]] const motion::Plan &plan() const { return m_plan; }
    [[nodiscard]] const motion::Present &present() const { return m_present; }
    /// UnderWay until start() and while it is followed.
    [[nodiscard]] Outcome outcome() const;
    [[nodiscard]] bool isFinished() const { return outcome() != Outcome::UnderWay; }
    /// Where it was seen last.
    [[nodiscard]] std::optional<values::Position> position() const;
    /// Why it was refused, or why nobody knows.
    [[nodiscard]] const std::optional<values::Error> &error() const { return m_error; }

Q_SIGNALS:
    void changed();

private:
    void onReply(const values::Result<void> &result);
    void onStateChanged(const TopicRange &range);
    void readPlace();
    void onPlace(const values::Result<values::Position> &position);
    void take(Outcome outcome);

    Orders &m_orders;
    motion::Plan m_plan;
    motion::Present m_present;
    std::optional<motion::Follower> m_follower;
    std::optional<values::Error> m_error;
    bool m_isReading = false;
    QTimer m_clock;
};

} // namespace robot
