// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/holdkey.h"

#include "ui/widgets/holdbutton.h"
#include <QApplication>
#include <QKeyEvent>

namespace ui {

using widgets::HoldButton;

namespace {

/// The HOLD of the strip of this window itself, never HOLD ALL; its page windows are its children and have their own.
HoldButton *holdOf(const QWidget *window)
{
    for (HoldButton *button : window->findChildren<HoldButton *>(QStringLiteral("holdButton"))) {
        if (button->window() == window && button->isVisible())
            return button;
    }
    return nullptr;
}

HoldButton *holdAt(QPoint place)
{
    for (const QWidget *window : QApplication::topLevelWidgets()) {
        HoldButton *button = holdOf(window);
        if (button && button->rect().contains(button->mapFromGlobal(place)))
            return button;
    }
    return nullptr;
}

} // namespace

HoldKey::HoldKey(QObject *parent) : QObject(parent) { qApp->installEventFilter(this); }

bool HoldKey::isHold(const QKeyEvent &event)
{
    return event.key() == Qt::Key_Pause
        || event.keyCombination() == QKeyCombination(Qt::ControlModifier | Qt::ShiftModifier, Qt::Key_H);
}

HoldButton *HoldKey::inFront() const
{
    for (const QWidget *window = QApplication::activeWindow(); window; window = window->parentWidget()) {
        if (HoldButton *button = holdOf(window))
            return button;
    }
    if (m_lastWindow) {
        if (HoldButton *button = holdOf(m_lastWindow))
            return button;
    }
    for (const QWidget *window : QApplication::topLevelWidgets()) {
        if (HoldButton *button = holdOf(window))
            return button;
    }
    return nullptr;
}

bool HoldKey::eventFilter(QObject *watched, QEvent *event)
{
    switch (event->type()) {
    case QEvent::ShortcutOverride: return onKey(static_cast<QKeyEvent *>(event), true);
    case QEvent::KeyPress: return onKey(static_cast<QKeyEvent *>(event), false);
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonDblClick: return onClickBesidePopup(*static_cast<QMouseEvent *>(event));
    case QEvent::WindowActivate:
        if (auto *widget = qobject_cast<QWidget *>(watched); widget && widget->isWindow() && holdOf(widget))
            m_lastWindow = widget;
        return false;
    default: return false;
    }
}

bool HoldKey::onKey(QKeyEvent *event, bool isOverride)
{
    if (!isHold(*event))
        return false;
    event->accept(); // an accepted override comes back as a key press, past every shortcut
    HoldButton *button = inFront();
    if (button && !isOverride && !event->isAutoRepeat())
        Q_EMIT button->holdRequested();
    return true;
}

bool HoldKey::onClickBesidePopup(const QMouseEvent &event)
{
    const QWidget *popup = QApplication::activePopupWidget();
    const QPoint place = event.globalPosition().toPoint();
    if (!popup || event.button() != Qt::LeftButton || popup->geometry().contains(place))
        return false;
    HoldButton *button = holdAt(place);
    if (!button)
        return false;
    Q_EMIT button->holdRequested();
    while (QWidget *open = QApplication::activePopupWidget())
        open->close();
    return true;
}

} // namespace ui
