// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/widgets/sheetlayer.h"

#include "ui/widgets/dialogsheet.h"
#include "ui/widgets/sheetframe.h"
#include <QApplication>
#include <QPainter>
#include <QWheelEvent>

namespace widgets {

SheetLayer::SheetLayer(QWidget *window, int top) : QWidget(window), m_top {top}
{
    setObjectName(QStringLiteral("sheetLayer"));
    hide();
    m_shield.setSingleShot(true);
    connect(&m_shield, &QTimer::timeout, this, [this] { setVisible(isOpen()); });
    connect(qApp, &QApplication::focusChanged, this, [this](QWidget *, QWidget *now) { onFocusChanged(now); });
    window->installEventFilter(this);
    qApp->installEventFilter(this);
    cover();
}

SheetLayer::~SheetLayer()
{
    disconnect(qApp, nullptr, this, nullptr);
    qDeleteAll(findChildren<SheetFrame *>(QString(), Qt::FindDirectChildrenOnly)); // they look at the layer
}

SheetLayer *SheetLayer::of(QWidget *window)
{
    auto *layer = window->findChild<SheetLayer *>(QString(), Qt::FindDirectChildrenOnly);
    return layer ? layer : new SheetLayer(window, 0);
}

void SheetLayer::take(DialogSheet *sheet) { new SheetFrame(sheet, this); }

QList<DialogSheet *> SheetLayer::sheets() const
{
    QList<DialogSheet *> result;
    for (const SheetFrame *frame : m_frames)
        result << frame->sheet();
    return result;
}

SheetFrame *SheetLayer::front() const { return m_frames.isEmpty() ? nullptr : m_frames.last(); }

bool SheetLayer::closeAll()
{
    const auto open = sheets();
    for (auto sheet = open.rbegin(); sheet != open.rend(); ++sheet) {
        if (sheets().contains(*sheet))
            (*sheet)->reject();
    }
    return !isOpen();
}

void SheetLayer::clear()
{
    closeAll();
    for (DialogSheet *sheet : sheets())
        delete sheet;
}

void SheetLayer::cover()
{
    const QSize window = parentWidget()->size();
    setGeometry(0, m_top, window.width(), window.height() - m_top);
    for (SheetFrame *frame : std::as_const(m_frames))
        frame->place();
}

void SheetLayer::onShown(SheetFrame *frame)
{
    if (m_frames.isEmpty())
        m_focusBefore = parentWidget()->focusWidget();
    m_frames.removeOne(frame);
    for (SheetFrame *under : std::as_const(m_frames))
        under->sheet()->setEnabled(false);
    m_frames << frame;
    m_shield.stop();
    cover();
    frame->show();
    frame->raise();
    show();
    raise();
    frame->takeFocus();
}

/// Of the sheet that is left the newest has the keys, or what had them before the first sheet.
void SheetLayer::onHidden(SheetFrame *frame)
{
    if (!m_frames.removeOne(frame))
        return;
    frame->hide();
    if (SheetFrame *next = front()) {
        next->sheet()->setEnabled(true);
        next->takeFocus();
        return;
    }
    update();
    m_shield.start(QApplication::doubleClickInterval());
    if (m_focusBefore && m_focusBefore->isVisible() && m_focusBefore->isEnabled())
        m_focusBefore->setFocus(Qt::OtherFocusReason);
}

bool SheetLayer::covers(const QWidget *widget) const
{
    return widget->window() == window() && widget != window() && !isAncestorOf(widget)
        && QRect(widget->mapTo(window(), QPoint()), widget->size()).intersects(geometry());
}

void SheetLayer::onFocusChanged(QWidget *now)
{
    SheetFrame *frame = front();
    if (!frame || !now || !frame->sheet())
        return;
    if (frame->isAncestorOf(now))
        frame->scrollTo(now);
    else if (covers(now) || isAncestorOf(now))
        frame->takeFocus();
}

/// An override that is accepted comes back as a key press, past every shortcut of the window.
bool SheetLayer::eventFilter(QObject *watched, QEvent *event)
{
    if (watched == parentWidget() && event->type() == QEvent::Resize)
        cover();
    if (event->type() == QEvent::ShortcutOverride && !m_frames.isEmpty()) {
        const auto *widget = qobject_cast<QWidget *>(watched);
        if (widget && widget->window() == window())
            event->accept();
    }
    return QWidget::eventFilter(watched, event);
}

void SheetLayer::paintEvent(QPaintEvent *)
{
    if (!isOpen())
        return;
    QPainter painter(this);
    painter.fillRect(rect(), QColor(0, 0, 0, 70));
}

void SheetLayer::mousePressEvent(QMouseEvent *event) { event->accept(); }

void SheetLayer::wheelEvent(QWheelEvent *event) { event->accept(); }

} // namespace widgets
