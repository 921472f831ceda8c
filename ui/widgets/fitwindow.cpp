// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/widgets/fitwindow.h"

#include <QEvent>
#include <QLayout>
#include <QWidget>

namespace widgets {

FitWindow::FitWindow(QWidget *window) : QObject(window), m_window {window} { window->installEventFilter(this); }

bool FitWindow::eventFilter(QObject *watched, QEvent *event)
{
    if (event->type() == QEvent::LayoutRequest || event->type() == QEvent::Show)
        fit();
    return QObject::eventFilter(watched, event);
}

void FitWindow::fit()
{
    const QLayout *layout = m_window->layout();
    if (!layout)
        return;
    const int width = std::max(m_window->width(), layout->totalMinimumSize().width());
    const int lines = layout->hasHeightForWidth() ? layout->totalHeightForWidth(width) : 0;
    m_window->resize(width, std::max(m_window->height(), lines));
}

} // namespace widgets
