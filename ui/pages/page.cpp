// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/pages/page.h"

#include "ui/pages/startpanel.h"
#include "ui/widgets/pageline.h"
#include "ui/widgets/plottable.h"
#include <QStackedLayout>
#include <QVBoxLayout>

namespace pages {

namespace {

/// The state of the link, and since when where that matters.
widgets::Shown subjectOf(const ui::LinkView &link, bool needsLink)
{
    using robot::Freshness;
    if (!needsLink)
        return {{Page::tr("kept on this computer")}, Freshness::Live, {}};
    if (link.state != robot::LinkState::Lost)
        return {{ui::linkWord(link.state)}, Freshness::Live, {}};
    return {{Page::tr("the last values read before %1").arg(link.since.toString(u"HH:mm:ss")), widgets::Lamp::Warning},
        Freshness::Live, {}};
}

} // namespace

Page::Page(const Context &context, QWidget *parent)
    : QWidget(parent), m_line {new widgets::PageLine}, m_layers {new QStackedLayout}
{
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(m_line);
    column->addLayout(m_layers, 1);
    auto *panel = new StartPanel(context);
    panel->setObjectName(QStringLiteral("notConnected"));
    m_layers->addWidget(panel);
    new widgets::Plottables(context.station.recorder, this);
}

void Page::setContent(QWidget *content) { m_layers->addWidget(content); }

void Page::setName(const QString &name) { m_line->setName(name); }

void Page::showLink(const ui::LinkView &link)
{
    m_line->setSubject(subjectOf(link, needsLink()));
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
