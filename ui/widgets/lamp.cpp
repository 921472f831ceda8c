// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/widgets/lamp.h"

#include <QPainter>
#include <QPainterPath>

namespace widgets {

namespace {

QPainterPath outline(const QRectF &square, Lamp lamp)
{
    QPainterPath path;
    if (lamp == Lamp::Warning)
        path.addPolygon(QPolygonF({square.bottomLeft(), {square.center().x(), square.top()}, square.bottomRight()}));
    else if (lamp == Lamp::Diamond)
        path.addPolygon(QPolygonF({{square.center().x(), square.top()}, {square.right(), square.center().y()},
            {square.center().x(), square.bottom()}, {square.left(), square.center().y()}}));
    else
        path.addRect(square);
    path.closeSubpath();
    return path;
}

ui::Role inkOf(Lamp lamp) { return lamp == Lamp::Hollow || lamp == Lamp::Filled ? ui::Role::Fill : roleOf(lamp); }

} // namespace

ui::Role roleOf(Lamp lamp)
{
    switch (lamp) {
    case Lamp::Alarm:
    case Lamp::Diamond: return ui::Role::Alarm;
    case Lamp::Warning: return ui::Role::Amber;
    case Lamp::None:
    case Lamp::Hollow:
    case Lamp::Filled: break;
    }
    return ui::Role::Text1;
}

void paintLamp(QPainter &painter, const QRectF &square, Lamp lamp, ui::Scheme scheme, qreal strength)
{
    if (lamp == Lamp::None)
        return;
    const QColor ink = ui::color(inkOf(lamp), scheme);
    painter.save();
    painter.setOpacity(strength);
    painter.setRenderHint(QPainter::Antialiasing, lamp == Lamp::Warning || lamp == Lamp::Diamond);
    if (lamp == Lamp::Hollow) {
        painter.setPen(QPen(ink, 2, Qt::SolidLine, Qt::SquareCap, Qt::MiterJoin));
        painter.drawRect(square.adjusted(1, 1, -1, -1));
    } else {
        painter.fillPath(outline(square, lamp), ink);
    }
    painter.restore();
}

} // namespace widgets
