// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/holdkey.h"

#include <QCoreApplication>
#include <QKeyEvent>

namespace ui {

HoldKey::HoldKey(QObject *parent) : QObject(parent) { qApp->installEventFilter(this); }

bool HoldKey::isHold(const QKeyEvent &event)
{
    return event.key() == Qt::Key_Pause
        || event.keyCombination() == QKeyCombination(Qt::ControlModifier | Qt::ShiftModifier, Qt::Key_H);
}

bool HoldKey::eventFilter(QObject *watched, QEvent *event)
{
    const bool isOverride = event->type() == QEvent::ShortcutOverride;
    if (!isOverride && event->type() != QEvent::KeyPress)
        return QObject::eventFilter(watched, event);
    const auto *key = static_cast<QKeyEvent *>(event);
    if (!isHold(*key))
        return QObject::eventFilter(watched, event);
    event->accept(); // an accepted override comes back as a key press, past every shortcut
    if (!isOverride && !key->isAutoRepeat())
        Q_EMIT pressed();
    return true;
}

} // namespace ui
