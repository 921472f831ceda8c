// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/widgets/jogpad.h"

#include "values/position.h"
#include <QGridLayout>
#include <QGuiApplication>
#include <QKeyEvent>
#include <utility>

using namespace std::chrono_literals;

namespace widgets {

namespace {

constexpr int columns = 6;
constexpr int padSide = 52; ///< Pixels: wide enough for a finger.

} // namespace

JogButton::JogButton(const QString &text, QWidget *parent) : QPushButton(text, parent)
{
    setAutoDefault(false);
    setAutoRepeat(false);
    setProperty("jog", true);
    setMinimumSize(padSide, padSide);
    setFocusPolicy(Qt::StrongFocus);
}

void JogButton::hold(Held how)
{
    m_held = how;
    setDown(true);
    Q_EMIT held();
}

void JogButton::letGo()
{
    setDown(false);
    if (std::exchange(m_held, Held::No) != Held::No)
        Q_EMIT letGone();
}

void JogButton::look()
{
    const bool isMouseDown = QGuiApplication::mouseButtons() == Qt::LeftButton;
    const bool isKeyDown = QGuiApplication::queryKeyboardModifiers() == Qt::ControlModifier;
    if ((m_held == Held::ByMouse && !isMouseDown) || (m_held == Held::ByKeys && !isKeyDown))
        letGo();
}

bool JogButton::event(QEvent *event)
{
    const auto type = event->type();
    if (type == QEvent::FocusOut || type == QEvent::Hide || type == QEvent::UngrabMouse || type == QEvent::TouchCancel
        || type == QEvent::WindowDeactivate || (type == QEvent::EnabledChange && !isEnabled()))
        letGo();
    return QPushButton::event(event);
}

void JogButton::mousePressEvent(QMouseEvent *event)
{
    if (event->button() == Qt::LeftButton && event->buttons() == Qt::LeftButton && m_held == Held::No)
        hold(Held::ByMouse);
    else
        letGo(); // two buttons: none of them is meant
}

void JogButton::mouseMoveEvent(QMouseEvent *event)
{
    if (!rect().contains(event->position().toPoint()))
        letGo();
}

void JogButton::mouseReleaseEvent(QMouseEvent *) { letGo(); }

void JogButton::keyPressEvent(QKeyEvent *event)
{
    const bool isJog = m_takesKeys && event->key() == Qt::Key_Space && event->modifiers() == Qt::ControlModifier;
    if (isJog && !event->isAutoRepeat() && m_held == Held::No)
        hold(Held::ByKeys);
    else if (!event->isAutoRepeat())
        letGo();
    if (event->key() != Qt::Key_Space && event->key() != Qt::Key_Return && event->key() != Qt::Key_Enter)
        event->ignore();
}

void JogButton::keyReleaseEvent(QKeyEvent *event)
{
    if (!event->isAutoRepeat())
        letGo();
    event->ignore();
}

JogPad::JogPad(QWidget *parent) : QWidget(parent)
{
    auto *grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setSpacing(6);
    for (int axis = 0; axis < values::maxAxes; ++axis)
        addAxis(axis);
    m_look.setInterval(50ms);
    connect(&m_look, &QTimer::timeout, this, [this] {
        for (JogButton *button : m_buttons)
            button->look();
    });
}

void JogPad::addAxis(int axis)
{
    for (const bool isForward : {false, true}) {
        auto *button = new JogButton({});
        button->setObjectName(QStringLiteral("jog%1%2").arg(isForward ? u"Plus" : u"Minus").arg(axis + 1));
        const auto place = int(m_buttons.size());
        static_cast<QGridLayout *>(layout())->addWidget(button, place / columns, place % columns);
        connect(button, &JogButton::held, this, [this, axis, isForward] {
            m_look.start();
            Q_EMIT pressed({axis, isForward});
        });
        connect(button, &JogButton::letGone, this, [this] {
            m_look.stop();
            Q_EMIT released();
        });
        m_buttons << button;
    }
}

void JogPad::setAxes(const QStringList &names)
{
    for (int place = 0; place < int(m_buttons.size()); ++place) {
        JogButton *button = m_buttons[place];
        const int axis = place / 2;
        button->setVisible(axis < names.size());
        if (axis >= names.size())
            continue;
        const bool isForward = place % 2 == 1;
        button->setText((isForward ? u'+' : QChar(0x2212)) + names[axis]);
        button->setAccessibleName(
            isForward ? tr("Jog %1 forward").arg(names[axis]) : tr("Jog %1 back").arg(names[axis]));
    }
}

void JogPad::setKeysAllowed(bool isAllowed)
{
    letGo();
    for (JogButton *button : m_buttons)
        button->allowKeys(isAllowed);
}

void JogPad::letGo()
{
    for (JogButton *button : m_buttons)
        button->letGo();
}

void JogPad::hideEvent(QHideEvent *event)
{
    letGo();
    QWidget::hideEvent(event);
}

void JogPad::changeEvent(QEvent *event)
{
    if (event->type() == QEvent::EnabledChange && !isEnabled())
        letGo();
    QWidget::changeEvent(event);
}

} // namespace widgets
