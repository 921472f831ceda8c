// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "motion/jogstep.h"
#include <QPushButton>
#include <QTimer>

namespace widgets {

/// A button that counts as pressed only while the left mouse button or, if allowed, Ctrl and Space are held on it.
/// Space and Enter alone do nothing, nor does auto-repeat; leaving it lets go and coming back does not press again.
class JogButton : public QPushButton
{
    Q_OBJECT

public:
    explicit JogButton(const QString &text, QWidget *parent = nullptr);

    void allowKeys(bool isAllowed) { m_takesKeys = isAllowed; }
    /// Lets go, whatever the mouse and the keys do.
    void letGo();
    /// Lets go if the computer no longer says that the mouse button or Ctrl is down.
    void look();

Q_SIGNALS:
    void held();
    void letGone();

protected:
    bool event(QEvent *event) override;
    void mousePressEvent(QMouseEvent *event) override;
    void mouseMoveEvent(QMouseEvent *event) override;
    void mouseReleaseEvent(QMouseEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;
    void keyReleaseEvent(QKeyEvent *event) override;

private:
    enum class Held { No, ByMouse, ByKeys };
    void hold(Held how);

    bool m_takesKeys = false;
    Held m_held = Held::No;
};

/// A button for each axis in both directions. What the computer says of mouse and keys is looked at again every 50 ms,
/// so that a release that never arrives is noticed.
class JogPad : public QWidget
{
    Q_OBJECT

public:
    explicit JogPad(QWidget *parent = nullptr);

    /// The axes that there are, at most eight.
    void setAxes(const QStringList &names);
    void setKeysAllowed(bool isAllowed);
    /// Lets go of what is held.
    void letGo();

Q_SIGNALS:
    void pressed(motion::JogDirection direction);
    void released();

protected:
    void hideEvent(QHideEvent *event) override;
    void changeEvent(QEvent *event) override;

private:
    void addAxis(int axis);

    QList<JogButton *> m_buttons; ///< Backward and forward of each axis.
    QTimer m_look;
};

} // namespace widgets
