// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/widgets/plottable.h"

#include "trend/recorder.h"
#include <QAbstractItemView>
#include <QApplication>
#include <QContextMenuEvent>
#include <QDrag>
#include <QMenu>
#include <QMimeData>
#include <QMouseEvent>

namespace widgets {

namespace {

constexpr char signalProperty[] = "trendSignal";

const QAbstractItemView *viewOf(const QWidget *widget)
{
    const auto *view = qobject_cast<const QAbstractItemView *>(widget->parentWidget());
    return view && view->viewport() == widget ? view : qobject_cast<const QAbstractItemView *>(widget);
}

} // namespace

void setSignal(QWidget *widget, const std::optional<trend::Signal> &signal)
{
    widget->setProperty(signalProperty, signal ? QVariant(trend::key(*signal)) : QVariant());
}

std::optional<trend::Signal> signalAt(const QWidget *widget, const QPoint &at)
{
    if (const QAbstractItemView *view = viewOf(widget)) {
        const QModelIndex index = view->indexAt(at);
        return trend::fromKey((index.isValid() ? index : view->currentIndex()).data(signalRole).toString());
    }
    return trend::fromKey(widget->property(signalProperty).toString());
}

void addTrendAction(QMenu &menu, trend::Recorder &recorder, const trend::Signal &signal)
{
    QAction *action = menu.addAction(Plottables::tr("Add to trend: %1").arg(trend::label(recorder.state(), signal)));
    action->setObjectName(QStringLiteral("addToTrend"));
    QObject::connect(action, &QAction::triggered, &recorder, [&recorder, signal] { recorder.add(signal); });
}

Plottables::Plottables(trend::Recorder &recorder, QWidget *root) : QObject {root}, m_recorder {recorder}, m_root {root}
{
    qApp->installEventFilter(this);
}

bool Plottables::eventFilter(QObject *watched, QEvent *event)
{
    const auto type = event->type();
    if (type != QEvent::ContextMenu && type != QEvent::MouseButtonPress && type != QEvent::MouseMove)
        return false;
    auto *widget = qobject_cast<QWidget *>(watched);
    if (!widget || !m_root->isAncestorOf(widget))
        return false;
    if (type == QEvent::ContextMenu) {
        const auto *menu = static_cast<QContextMenuEvent *>(event);
        return openMenu(widget, menu->pos(), menu->globalPos());
    }
    const auto *mouse = static_cast<QMouseEvent *>(event);
    const QPoint at = mouse->position().toPoint();
    if (type == QEvent::MouseButtonPress) {
        m_pressedAt = at;
        m_pressed = mouse->button() == Qt::LeftButton ? signalAt(widget, at) : std::nullopt;
    } else if (m_pressed && (mouse->buttons() & Qt::LeftButton)
        && (at - m_pressedAt).manhattanLength() >= QApplication::startDragDistance()) {
        drag(widget, *std::exchange(m_pressed, std::nullopt));
        return true;
    }
    return false;
}

bool Plottables::openMenu(QWidget *widget, const QPoint &at, const QPoint &global)
{
    const auto signal = signalAt(widget, at);
    const QAbstractItemView *view = viewOf(widget);
    const auto policy = view ? view->contextMenuPolicy() : widget->contextMenuPolicy();
    if (!signal || policy != Qt::DefaultContextMenu)
        return false;
    auto *menu = new QMenu(widget);
    menu->setObjectName(QStringLiteral("trendMenu"));
    menu->setAttribute(Qt::WA_DeleteOnClose);
    addTrendAction(*menu, m_recorder, *signal);
    menu->popup(global);
    return true;
}

/// The drag outlives this call: it runs an event loop of the platform's own, which may delete everything here.
void Plottables::drag(QWidget *widget, const trend::Signal &signal)
{
    auto *mime = new QMimeData;
    mime->setData(QLatin1String(trend::mimeType), trend::toMime({signal}));
    mime->setText(trend::label(m_recorder.state(), signal));
    auto *drag = new QDrag(widget);
    drag->setMimeData(mime);
    drag->exec(Qt::CopyAction);
}

} // namespace widgets
