// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/widgets/curvesitem.h"

#include "ui/theme.h"
#include <QPainter>
#include <algorithm>
#include <cmath>

namespace widgets {

namespace {

constexpr qreal letterDistance = 176; ///< Pixels between the letters on a line.
constexpr qreal letterSide = 15;

/// A run of points between two gaps.
void paintRun(QPainter &painter, QPolygonF &run)
{
    if (run.size() == 1)
        painter.drawEllipse(run.front(), 1, 1);
    painter.drawPolyline(run);
    run.clear();
}

} // namespace

void CurvesItem::show(std::vector<Curve> curves, const trend::Range &range)
{
    m_curves = std::move(curves);
    m_range = range;
    update();
}

void CurvesItem::setArea(const QRectF &area)
{
    prepareGeometryChange();
    m_area = area;
}

void CurvesItem::setCursor(std::optional<qreal> share)
{
    m_cursor = share;
    update();
}

void CurvesItem::setColors(const QColor &ground, const QColor &cursor)
{
    m_ground = ground;
    m_cursorColor = cursor;
}

QPointF CurvesItem::placeOf(const Curve &curve, const trend::Sample &sample) const
{
    const double x =
        double((sample.at - m_range.from).count()) / double(std::max<qint64>((m_range.to - m_range.from).count(), 1));
    const double y = (sample.value - curve.lowest) / (curve.highest - curve.lowest);
    return {m_area.left() + x * m_area.width(), m_area.bottom() - y * m_area.height()};
}

void CurvesItem::paint(QPainter *painter, const QStyleOptionGraphicsItem *, QWidget *)
{
    painter->save();
    painter->setClipRect(m_area.adjusted(-1, -1, 1, 1));
    for (const Curve &curve : m_curves)
        paintLine(*painter, curve);
    painter->setFont(ui::font(ui::Type::Label));
    for (std::size_t i = 0; i < m_curves.size(); ++i)
        paintLetters(*painter, m_curves[i], int(i));
    if (m_cursor) {
        const qreal x = std::round(m_area.left() + *m_cursor * m_area.width()) + 0.5;
        painter->setPen(m_cursorColor);
        painter->drawLine(QPointF(x, m_area.top()), QPointF(x, m_area.bottom()));
    }
    painter->restore();
}

void CurvesItem::paintLine(QPainter &painter, const Curve &curve) const
{
    painter.setPen(curve.pen);
    QPolygonF run;
    for (const trend::Sample &sample : curve.samples) {
        if (sample.isGap()) {
            paintRun(painter, run);
            continue;
        }
        const QPointF place = placeOf(curve, sample);
        if (curve.isStepped && !run.isEmpty())
            run << QPointF(place.x(), run.back().y());
        run << place;
    }
    paintRun(painter, run);
}

/// Letters stand at fixed places of the picture, each line's beside the others', so that they do not travel with it.
void CurvesItem::paintLetters(QPainter &painter, const Curve &curve, int index) const
{
    painter.setBrush(m_ground);
    painter.setPen(QPen(curve.pen.color(), 1));
    auto next = curve.samples.begin();
    const qreal first = m_area.left() + 14 + index * (letterSide + 5);
    const int count = int(std::ceil((m_area.right() - first) / letterDistance));
    for (int letter = 0; letter < count; ++letter) {
        const qreal x = first + letter * letterDistance;
        next = std::find_if(next, curve.samples.end(),
            [&](const trend::Sample &sample) { return !sample.isGap() && placeOf(curve, sample).x() >= x; });
        if (next == curve.samples.end())
            return;
        const QPointF place = placeOf(curve, *next);
        if (place.x() > x + letterDistance / 2)
            continue;
        QRectF box(0, 0, letterSide, letterSide);
        box.moveCenter(
            {place.x(), std::clamp(place.y(), m_area.top() + letterSide / 2, m_area.bottom() - letterSide / 2)});
        painter.drawRect(box);
        painter.drawText(box, Qt::AlignCenter, curve.letter);
    }
}

} // namespace widgets
