// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "robot/access.h"
#include "ui/widgets/dialogsheet.h"

class QLabel;
class QLineEdit;
class QSpinBox;

namespace dialogs {

/// Asks for the passcode on the way to a higher level.
class PasscodeDialog : public widgets::DialogSheet
{
    Q_OBJECT

public:
    /// `access` must outlive the dialog.
    PasscodeDialog(robot::Access &access, robot::Level level, QWidget *parent);

private:
    void tryEnter();
    void onAnswered(robot::Access::Answer answer);

    robot::Access &m_access;
    robot::Level m_level;
    QLineEdit *m_passcode;
    QLabel *m_complaint;
};

/// Sets or removes the passcode, and the time after which the level falls back.
class AccessSettingsDialog : public widgets::DialogSheet
{
    Q_OBJECT

public:
    /// `rules` must outlive the dialog.
    AccessSettingsDialog(robot::AccessRules &rules, QWidget *parent);

private:
    void save();
    void keep(const std::optional<settings::Passcode> &passcode);

    robot::AccessRules &m_rules;
    QSpinBox *m_minutes;
    QLineEdit *m_passcode;
    QLineEdit *m_again;
    QLabel *m_complaint;
    disk::Worker m_making; ///< Of a passcode, which takes its time.
};

} // namespace dialogs
