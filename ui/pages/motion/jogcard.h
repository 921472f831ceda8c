// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "robot/jog.h"
#include "ui/pages/page.h"
#include "ui/widgets/card.h"

class QCheckBox;

namespace widgets {
class JogPad;
class OrderButton;
class Segments;
} // namespace widgets

namespace pages {

/// Step, speed, frame, and the buttons that are held down.
class JogCard : public widgets::Card
{
    Q_OBJECT

public:
    /// `jog` must outlive the card.
    JogCard(const Context &context, robot::Jog &jog, QWidget *parent = nullptr);

    /// A robot, base or station by its pulse instance.
    void setGroup(values::ControlGroup group);

private:
    void addRow(const QString &title, QWidget *widget);
    void showChoices();
    void choose();
    void showAxes();
    void showState();
    [[nodiscard]] motion::JogFrame frame() const;
    [[nodiscard]] std::optional<robot::Condition> obstacle() const;
    [[nodiscard]] QString worstCase() const;
    [[nodiscard]] QString stateText() const;

    robot::Jog &m_jog;
    robot::Orders &m_orders;
    const robot::RobotState &m_state;
    values::ControlGroup m_group = values::ControlGroup::robotPulse(1);
    widgets::Segments *m_step;
    widgets::Segments *m_speed;
    widgets::Segments *m_frame;
    widgets::JogPad *m_pad;
    QCheckBox *m_keys;
    QLabel *m_worst;
    widgets::Line *m_result;
};

} // namespace pages
