// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "robot/access.h"
#include "robot/arming.h"
#include <QPointer>
#include <QWindow>

namespace ui {

/// Tells access and arming what the person at this computer does: keys and mouse, and where they look. Another program
/// or another window of ours in front drops arming; dialogs of the window that was armed do not.
class Presence : public QObject
{
    Q_OBJECT

public:
    /// Both must outlive this.
    Presence(robot::AccessRules &rules, robot::Arming &arming, QObject *parent = nullptr);

    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    void onArmingChanged();
    void onFocusWindowChanged(QWindow *window);
    void onApplicationStateChanged(Qt::ApplicationState state);

    robot::AccessRules &m_rules;
    robot::Arming &m_arming;
    QPointer<QWindow> m_home; ///< In front when it was armed.
};

} // namespace ui
