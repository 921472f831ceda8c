// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include <QObject>
#include <QPointer>
#include <QWidget>

class QKeyEvent;
class QMouseEvent;

namespace widgets {
class HoldButton;
}

namespace ui {

/// Sees to it that HOLD is heard, one object for the whole program. Pause and Ctrl+Shift+H press the HOLD of the window
/// in front, or of the one that was in front last when none of ours is, once for each press and never for a key that
/// repeats. A QShortcut would not do: it is silent in another window. The first click on HOLD counts even while a menu
/// or a list is open, which would take it for a click that closes them.
class HoldKey : public QObject
{
    Q_OBJECT

public:
    explicit HoldKey(QObject *parent = nullptr);

    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    [[nodiscard]] static bool isHold(const QKeyEvent &event);
    [[nodiscard]] widgets::HoldButton *inFront() const;
    bool onKey(QKeyEvent *event, bool isOverride);
    bool onClickBesidePopup(const QMouseEvent &event);

    QPointer<QWidget> m_lastWindow; ///< With a HOLD, in front last.
};

} // namespace ui
