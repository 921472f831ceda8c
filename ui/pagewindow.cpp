// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/pagewindow.h"

#include "ui/pages/page.h"
#include "ui/robotstrip.h"
#include "ui/theme.h"
#include "ui/widgets/sheetlayer.h"
#include <QCloseEvent>
#include <QVBoxLayout>

namespace ui {

PageWindow::PageWindow(RobotStrip *strip, pages::Page *page, const QString &title, QWidget *parent)
    : QWidget(parent, Qt::Window), m_page {page}, m_sheets {new widgets::SheetLayer(this, space::strip)}
{
    setObjectName(page->objectName() + QStringLiteral("Window"));
    setWindowTitle(title);
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(strip);
    column->addWidget(page, 1);
    page->show();
    resize(1100, 760);
    m_sheets->raise();
}

void PageWindow::closeEvent(QCloseEvent *event)
{
    event->setAccepted(m_sheets->closeAll());
    if (event->isAccepted())
        Q_EMIT closed(this);
}

} // namespace ui
