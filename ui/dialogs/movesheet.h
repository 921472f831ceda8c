// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "robot/move.h"
#include "ui/widgets/dialogsheet.h"

class QLineEdit;
class QPushButton;

namespace widgets {
class Line;
class Rows;
} // namespace widgets

namespace dialogs {

/// The rehearsal of a move, in words: from where to where, how far, how long, inside which box, under which speed, and
/// which stored points are near. The button works after a second, and only a pointer presses it; a long move asks for
/// the controller's name first, and with the name typed F9 does the same. Afterwards it follows the move to its end.
/// Stop is HOLD, and HOLD stays on.
class MoveSheet : public widgets::DialogSheet
{
    Q_OBJECT

public:
    /// `orders` must outlive the sheet. `present` is what the plan was made from.
    MoveSheet(robot::Orders &orders, const motion::Plan &plan, const motion::Present &present,
        const motion::Limits &limits, QWidget *parent);

protected:
    void keyPressEvent(QKeyEvent *event) override;

private:
    void makeWidgets();
    void showPlan(const motion::Present &present, const motion::Limits &limits);
    void showNearest();
    void update();
    void move();
    void onPlace(const values::Result<values::Position> &position);
    void showOutcome();
    [[nodiscard]] bool isNamed() const;
    [[nodiscard]] bool hasMovedAway() const;
    [[nodiscard]] bool isWherePlanned(const values::Position &position) const;
    [[nodiscard]] QString wayText() const;
    [[nodiscard]] QString boxText() const;
    [[nodiscard]] QString capText(const motion::Limits &limits) const;
    [[nodiscard]] QString outcomeText() const;

    robot::Orders &m_orders;
    motion::Present m_present;
    robot::Move *m_move;
    robot::Poller::Interest m_points; ///< The stored points, while the sheet is open.
    widgets::Rows *m_rows;
    widgets::Line *m_reason;
    widgets::Line *m_outcome;
    QLineEdit *m_name;
    QPushButton *m_go;
    QPushButton *m_stop;
    QPushButton *m_close;
    QTimer m_guard; ///< The second for which nothing has changed.
    bool m_isPossible = false;
    bool m_isGuarded = true;
    bool m_isStarted = false;
};

} // namespace dialogs
