// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "robot/robotstate.h"
#include "ui/widgets/card.h"

class QGridLayout;

namespace widgets {
class ValueLabel;
}

namespace pages {

/// Where R1 stands: in the base frame, and in pulses beside it. As many rows as the arm has axes.
class PositionCard : public widgets::Card
{
    Q_OBJECT

public:
    explicit PositionCard(const robot::RobotState &state, QWidget *parent = nullptr);

protected:
    void paintEvent(QPaintEvent *event) override;

private:
    /// One axis of one of the two columns.
    struct Cell {
        QLabel *name = nullptr;
        widgets::ValueLabel *value = nullptr;
        QLabel *unit = nullptr; ///< None for pulses.

        void setVisible(bool visible) const;
    };
    using Column = std::array<Cell, values::maxAxes>;

    void addRow(QGridLayout *grid, int axis);
    void onChanged(const robot::TopicRange &range);
    void showBase();
    void showPulses();
    void showNames(const Column &column, const robot::Reading<values::AxisNames> &names);
    void showRows();
    void showReason();

    const robot::RobotState &m_state;
    Column m_base;
    Column m_pulse;
};

} // namespace pages
