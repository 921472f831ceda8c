// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/presence.h"

#include "ui/desktopwatch.h"
#include <QEvent>
#include <QGuiApplication>

namespace ui {

using robot::Arming;

namespace {

bool isActivity(QEvent::Type type)
{
    return type == QEvent::KeyPress || type == QEvent::MouseButtonPress || type == QEvent::Wheel
        || type == QEvent::TouchBegin || type == QEvent::TabletPress;
}

/// The window that a dialog or a menu belongs to; a page in a window of its own is at home there.
QWindow *homeOf(QWindow *window)
{
    while (window && window->type() != Qt::Window && window->transientParent())
        window = window->transientParent();
    return window;
}

} // namespace

Presence::Presence(robot::AccessRules &rules, Arming &arming, QObject *parent)
    : QObject(parent), m_rules {rules}, m_arming {arming}
{
    qApp->installEventFilter(this);
    connect(&arming, &Arming::changed, this, &Presence::onArmingChanged);
    const auto *desktop = new DesktopWatch(this);
    connect(desktop, &DesktopWatch::screenLocked, this, [this] { m_arming.drop(Arming::Drop::ScreenLocked); });
    connect(desktop, &DesktopWatch::sleepBegun, this, [this] { m_arming.drop(Arming::Drop::Sleep); });
    connect(qApp, &QGuiApplication::focusWindowChanged, this, &Presence::onFocusWindowChanged);
    connect(qApp, &QGuiApplication::applicationStateChanged, this, &Presence::onApplicationStateChanged);
}

bool Presence::eventFilter(QObject *watched, QEvent *event)
{
    if (event->spontaneous() && isActivity(event->type())) {
        const auto now = values::now();
        m_rules.noteActivity(now);
        m_arming.noteActivity(now);
    }
    return QObject::eventFilter(watched, event);
}

void Presence::onArmingChanged()
{
    if (m_arming.isArmed())
        m_home = homeOf(QGuiApplication::focusWindow());
}

void Presence::onFocusWindowChanged(QWindow *window)
{
    if (window && m_home && window->type() != Qt::Popup && homeOf(window) != m_home)
        m_arming.drop(Arming::Drop::SecondWindow);
}

void Presence::onApplicationStateChanged(Qt::ApplicationState state)
{
    if (state != Qt::ApplicationActive)
        m_arming.drop(Arming::Drop::FocusLost);
}

} // namespace ui
