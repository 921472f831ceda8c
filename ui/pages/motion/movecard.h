// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "motion/plan.h"
#include "robot/orders.h"
#include "ui/pages/page.h"
#include "ui/widgets/card.h"

class QComboBox;
class QDoubleSpinBox;
class QGridLayout;
class QLineEdit;
class QSpinBox;

namespace widgets {
class OrderButton;
}

namespace pages {

class PointsBar;

/// A move to a position: where it stands, where it shall be, and the way between, axis by axis. The move itself is
/// ordered from the sheet that rehearses it.
class MoveCard : public widgets::Card
{
    Q_OBJECT

public:
    MoveCard(const Context &context, const values::Result<motion::Limits> &limits, QWidget *parent = nullptr);

    /// A robot, base or station by its pulse instance.
    void setGroup(values::ControlGroup group);

private:
    struct Row {
        QLabel *name;
        QLabel *now;
        QLineEdit *target;
        QLabel *change;
        QLabel *unit;
    };

    [[nodiscard]] QWidget *choices();
    [[nodiscard]] QWidget *axes();
    [[nodiscard]] QWidget *speeds();
    [[nodiscard]] QDoubleSpinBox *speed(const char *name, const QString &title, double most, double usual);
    void addRow(QGridLayout *grid, int axis);

    void onKindChanged();
    void fillWithPresent();
    void fill(const values::Position &position);

    void showRows();
    void judge();
    void rehearse();

    [[nodiscard]] values::PositionType frame() const;
    [[nodiscard]] motion::Wish::How how() const;
    [[nodiscard]] std::optional<values::Position> here() const;
    [[nodiscard]] int axisCount() const;
    [[nodiscard]] values::Result<values::AxisWords> typed() const;
    [[nodiscard]] values::Result<std::array<qint32, 3>> typedTrack() const;
    [[nodiscard]] values::Result<motion::Plan> plan() const;

    robot::Orders &m_orders;
    const robot::RobotState &m_state;
    const settings::Profile &m_profile;
    values::Result<motion::Limits> m_limits;
    values::ControlGroup m_group = values::ControlGroup::robotPulse(1);
    QComboBox *m_how;
    QComboBox *m_frame;
    QSpinBox *m_tool;
    QSpinBox *m_userFrame;
    QLineEdit *m_track; ///< Where the base axes shall be, in mm.
    QLabel *m_form;
    QList<Row> m_rows;
    QDoubleSpinBox *m_toolSpeed = nullptr;
    QDoubleSpinBox *m_rotationSpeed = nullptr;
    QDoubleSpinBox *m_jointSpeed = nullptr;
    PointsBar *m_points;
    widgets::OrderButton *m_move;
    values::Position m_taken; ///< The form that goes with the target.
};

} // namespace pages
