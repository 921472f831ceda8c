// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "robot/jog.h"
#include "ui/pages/page.h"

class QComboBox;

namespace pages {

class CartesianCard;
class JogCard;
class MoveCard;

/// Moving the arm from a desk: jog steps while a button is held, and moves to a position. What must be so before it
/// moves stands beside the buttons, and the statement that nobody is protected here cannot be taken away.
class MotionPage : public Page
{
    Q_OBJECT

public:
    explicit MotionPage(const Context &context, QWidget *parent = nullptr);

    ~MotionPage() override;

    [[nodiscard]] QList<robot::TopicRange> topics() const override;
    bool event(QEvent *event) override;
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    [[nodiscard]] QWidget *statement();
    [[nodiscard]] QWidget *readiness(const Context &context);
    void showGroups();
    void openGroup();
    void followWindow();

    const robot::RobotState &m_state;
    const settings::Profile &m_profile;
    robot::Jog &m_jog;
    QComboBox *m_group;
    CartesianCard *m_cartesian;
    JogCard *m_jogCard;
    MoveCard *m_move;
    QList<values::ControlGroup> m_groups; ///< Those that answer.
};

} // namespace pages
