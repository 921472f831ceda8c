// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/widgets/noticestack.h"

#include "ui/theme.h"
#include <QEvent>
#include <QVBoxLayout>
#include <algorithm>

namespace widgets {

namespace {

constexpr int widest = 640;
constexpr int edge = 3; ///< Of the window, below the lowest message.

} // namespace

NoticeStack::NoticeStack(QWidget *host) : QWidget(host)
{
    setObjectName(QStringLiteral("notices"));
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(4);
    hide();
    host->installEventFilter(this);
}

MessageBar *NoticeStack::add(const QString &name)
{
    auto *bar = new MessageBar;
    bar->setObjectName(name);
    layout()->addWidget(bar);
    connect(bar, &MessageBar::changed, this, &NoticeStack::place);
    return bar;
}

void NoticeStack::layOver(QWidget *host)
{
    if (host == parentWidget())
        return;
    parentWidget()->removeEventFilter(this);
    setParent(host);
    host->installEventFilter(this);
    place();
}

bool NoticeStack::eventFilter(QObject *watched, QEvent *event)
{
    if (event->type() == QEvent::Resize)
        place();
    return QWidget::eventFilter(watched, event);
}

void NoticeStack::place()
{
    const auto bars = findChildren<MessageBar *>(QString(), Qt::FindDirectChildrenOnly);
    const bool isAny = std::ranges::any_of(bars, [](const MessageBar *bar) { return !bar->isHidden(); });
    setVisible(isAny);
    if (!isAny)
        return;
    const QSize room = parentWidget()->size();
    const int width = std::min(widest, room.width() - 2 * ui::space::page);
    const int height = layout()->heightForWidth(width);
    setGeometry(room.width() - ui::space::page - width, room.height() - edge - height, width, height);
    raise();
}

} // namespace widgets
