// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "motion/jogstep.h"
#include "robot/motionorders.h"
#include <QTimer>

namespace robot {

/// Jogging one group of one controller: one bounded step after another while a button is held down. The step engine
/// decides; this tells it what happens and carries out what it says. While a button is down or a step runs, the status
/// is read twenty times a second, and the position after each status at rest, so that a step begins where the one
/// before has ended.
class Jog : public QObject
{
    Q_OBJECT

public:
    /// `orders` must outlive it. Without limits nothing moves: see complaint().
    Jog(Orders &orders, const values::Result<motion::Limits> &limits, QObject *parent = nullptr);

    /// Counts from the next press on.
    void setChoice(const motion::JogChoice &choice);
    [[nodiscard]] const motion::JogChoice &choice() const { return m_choice; }
    [[nodiscard]] const values::Result<motion::Limits> &limits() const { return m_limits; }

    /// A button went down, or up. Release what is pressed before another is pressed: two at once stop both.
    void press(motion::JogDirection direction);
    void release();
    /// The window with the buttons came to the front, or left it.
    void setWindowActive(bool isActive);

    /// The direction whose button counts as pressed.
    [[nodiscard]] std::optional<motion::JogDirection> pressed() const;
    [[nodiscard]] motion::StepEngine::Progress progress() const { return m_engine.progress(); }
    /// Steps that were sent since the button went down.
    [[nodiscard]] int stepsSent() const { return m_stepsSent; }
    /// Why the last press or step came to nothing; empty otherwise.
    [[nodiscard]] const QString &complaint() const { return m_complaint; }
    /// How the last order ended.
    [[nodiscard]] const std::optional<values::Result<void>> &lastReply() const { return m_lastReply; }

Q_SIGNALS:
    /// Anything of the above.
    void changed();

private:
    void obey(motion::StepEngine::Act act);
    void look();
    void onStatus(const values::Result<values::Status> &status);
    [[nodiscard]] QList<values::ControlGroup> places() const;
    void readPlaces(const QList<values::ControlGroup> &groups, const values::Status &status, Time statusAt);
    void feed(const values::Status &status, Time at);
    void sendStep();
    void onReply(const values::Result<void> &result);
    [[nodiscard]] bool isAwake() const;

    Orders &m_orders;
    values::Result<motion::Limits> m_limits;
    motion::StepEngine m_engine;
    motion::JogChoice m_choice;
    motion::JogDirection m_direction;
    motion::Present m_present; ///< As read after the last status at rest.
    bool m_isReading = false;
    int m_stepsSent = 0;
    QString m_complaint;
    std::optional<values::Result<void>> m_lastReply;
    QTimer m_clock;
};

} // namespace robot
