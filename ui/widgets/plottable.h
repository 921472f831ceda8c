// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "trend/signal.h"
#include <QObject>
#include <QPoint>

class QMenu;
class QWidget;

namespace trend {
class Recorder;
}

namespace widgets {

/// The role under which a model tells the key of the signal that a cell shows, as a QString; see trend::key().
constexpr int signalRole = Qt::UserRole + 70;

/// Says which signal a widget shows. nullopt: none.
void setSignal(QWidget *widget, const std::optional<trend::Signal> &signal);
/// The signal under a place of a widget: its own, or that of a cell of an item view.
[[nodiscard]] std::optional<trend::Signal> signalAt(const QWidget *widget, const QPoint &at);
/// "Add to trend" in a menu of one's own.
void addTrendAction(QMenu &menu, trend::Recorder &recorder, const trend::Signal &signal);

/// Lets every number under a widget be dragged into the trend, or be added to it by a context menu (also by the menu
/// key, where a cell has the focus). Widgets and views with a context menu of their own keep it.
class Plottables : public QObject
{
    Q_OBJECT

public:
    Plottables(trend::Recorder &recorder, QWidget *root);

    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    bool openMenu(QWidget *widget, const QPoint &at, const QPoint &global);
    void drag(QWidget *widget, const trend::Signal &signal);

    trend::Recorder &m_recorder;
    QWidget *m_root;
    QPoint m_pressedAt;
    std::optional<trend::Signal> m_pressed;
};

} // namespace widgets
