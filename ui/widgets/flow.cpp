// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/widgets/flow.h"

#include <algorithm>

namespace widgets {

namespace {

constexpr int gap = 8;

int widthOf(const QLayoutItem *item) { return std::max(item->sizeHint().width(), item->minimumSize().width()); }

int heightOf(const QLayoutItem *item, int width)
{
    return item->hasHeightForWidth() ? item->heightForWidth(width) : item->sizeHint().height();
}

bool expands(const QLayoutItem *item) { return item->expandingDirections() & Qt::Horizontal; }

} // namespace

Flow::Flow(QWidget *parent) : QLayout(parent)
{
    setContentsMargins(0, 0, 0, 0);
    setSpacing(gap);
}

Flow::~Flow() { qDeleteAll(m_items); }

void Flow::insertWidget(int index, QWidget *widget)
{
    addChildWidget(widget);
    m_items.insert(index, new QWidgetItem(widget));
    invalidate();
}

void Flow::addLayout(QLayout *layout)
{
    addChildLayout(layout);
    addItem(layout);
}

void Flow::addStretch() { addItem(new QSpacerItem(0, 0, QSizePolicy::Expanding)); }

void Flow::addItem(QLayoutItem *item)
{
    m_items << item;
    invalidate();
}

QLayoutItem *Flow::takeAt(int index)
{
    if (index < 0 || index >= m_items.size())
        return nullptr;
    invalidate();
    return m_items.takeAt(index);
}

int Flow::widthOf(const Line &line) const
{
    int width = 0;
    for (const QLayoutItem *item : line)
        width += widgets::widthOf(item) + (item == line.first() ? 0 : spacing());
    return width;
}

QList<int> Flow::widths(const Line &line, int width) const
{
    const int spare = std::max(0, width - widthOf(line));
    const int expanding = int(std::ranges::count_if(line, expands));
    QList<int> result;
    for (const QLayoutItem *item : line)
        result << std::min(widgets::widthOf(item) + (expands(item) ? spare / expanding : 0), width);
    return result;
}

int Flow::heightOf(const Line &line, int width) const
{
    const QList<int> wide = widths(line, width);
    int height = 0;
    for (qsizetype i = 0; i < line.size(); ++i)
        height = std::max(height, widgets::heightOf(line[i], wide[i]));
    return height;
}

/// A stretch is no reason for another line, and none begins with it.
QList<Flow::Line> Flow::lines(int width) const
{
    QList<Line> result;
    for (QLayoutItem *item : m_items) {
        const bool isStretch = item->spacerItem();
        if ((item->isEmpty() && !isStretch) || (isStretch && result.isEmpty()))
            continue;
        if (result.isEmpty() || (!isStretch && widthOf(result.last() + Line {item}) > width))
            result << Line {};
        result.last() << item;
    }
    return result;
}

QSize Flow::sizeHint() const
{
    Line all;
    for (QLayoutItem *item : m_items) {
        if (!item->isEmpty())
            all << item;
    }
    const int width = widthOf(all);
    return QSize(width, heightOf(all, width)).grownBy(contentsMargins());
}

QSize Flow::minimumSize() const
{
    QSize size;
    for (const QLayoutItem *item : m_items) {
        if (!item->isEmpty())
            size = size.expandedTo(item->minimumSize());
    }
    return size.grownBy(contentsMargins());
}

int Flow::heightForWidth(int width) const
{
    const QMargins margins = contentsMargins();
    const int inner = width - margins.left() - margins.right();
    int height = 0;
    for (const Line &line : lines(inner))
        height += heightOf(line, inner) + (height > 0 ? spacing() : 0);
    return height + margins.top() + margins.bottom();
}

void Flow::setGeometry(const QRect &rect)
{
    QLayout::setGeometry(rect);
    QRect room = rect.marginsRemoved(contentsMargins());
    for (const Line &line : lines(room.width())) {
        const int height = heightOf(line, room.width());
        place(line, QRect(room.left(), room.top(), room.width(), height));
        room.setTop(room.top() + height + spacing());
    }
}

/// In the middle of the line, unless the item was given an alignment.
void Flow::place(const Line &line, const QRect &room) const
{
    const QList<int> wide = widths(line, room.width());
    const bool isRightToLeft = parentWidget() && parentWidget()->layoutDirection() == Qt::RightToLeft;
    int x = room.left();
    for (qsizetype i = 0; i < line.size(); ++i) {
        const int height = line[i]->alignment() ? room.height() : widgets::heightOf(line[i], wide[i]);
        const int left = isRightToLeft ? room.left() + room.right() + 1 - x - wide[i] : x;
        line[i]->setGeometry({left, room.top() + (room.height() - height) / 2, wide[i], height});
        x += wide[i] + spacing();
    }
}

} // namespace widgets
