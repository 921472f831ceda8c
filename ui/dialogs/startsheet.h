// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "robot/jobstart.h"
#include "ui/widgets/dialogsheet.h"

class QLabel;
class QLineEdit;
class QPushButton;

namespace widgets {
class Rows;
}

namespace dialogs {

/// What stands between a person and a moving robot: controller, job, line, cycle and override as they are read now. The
/// button works after they have stood still for one second, and only a pointer presses it; with the keyboard the
/// words of startWords() must be typed. Afterwards it tells what became of the start.
class StartSheet : public widgets::DialogSheet
{
    Q_OBJECT

public:
    /// `orders` must outlive the sheet.
    StartSheet(robot::Orders &orders, QWidget *parent);

    /// "START WELD_A12": typed, and followed by F9, it starts.
    [[nodiscard]] QString startWords() const;

protected:
    void keyPressEvent(QKeyEvent *event) override;

private:
    /// What the person agrees to.
    struct Subject {
        values::ExecutingJob job;
        values::Status::Data1 cycle;

        bool operator==(const Subject &) const = default;
    };

    [[nodiscard]] std::optional<Subject> subject() const;
    void makeWidgets();
    void update();
    void showSubject();
    void onGuardPassed();
    void start();
    void showPhase();
    [[nodiscard]] QString phaseText() const;
    [[nodiscard]] QString jobText() const;

    robot::Orders &m_orders;
    widgets::Rows *m_rows;
    QLabel *m_reason;
    QLabel *m_phase;
    QLineEdit *m_words;
    QPushButton *m_start;
    QPushButton *m_close;
    std::optional<Subject> m_shown; ///< For which the second runs or has passed.
    QTimer m_guard;
    robot::JobStart *m_attempt = nullptr;
};

} // namespace dialogs
