// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/pages/page.h"

#include "ui/pages/startpanel.h"
#include "ui/widgets/plottable.h"
#include <QStackedLayout>

namespace pages {

Page::Page(const Context &context, QWidget *parent) : QWidget(parent), m_layers {new QStackedLayout(this)}
{
    auto *panel = new StartPanel(context);
    panel->setObjectName(QStringLiteral("notConnected"));
    m_layers->addWidget(panel);
    new widgets::Plottables(context.station.recorder, this);
}

void Page::setContent(QWidget *content) { m_layers->addWidget(content); }

void Page::showLink(const ui::LinkView &link)
{
    m_layers->setCurrentIndex(link.state == robot::LinkState::Disconnected && needsLink() ? 0 : 1);
}

void Page::showEvent(QShowEvent *event)
{
    QWidget::showEvent(event);
    Q_EMIT visibilityChanged();
}

void Page::hideEvent(QHideEvent *event)
{
    QWidget::hideEvent(event);
    Q_EMIT visibilityChanged();
}

} // namespace pages
