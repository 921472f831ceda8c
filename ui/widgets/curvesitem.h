// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "trend/decimate.h"
#include <QGraphicsItem>
#include <QPen>
#include <optional>

namespace widgets {

/// One line of a plot, thinned and scaled.
struct Curve {
    std::vector<trend::Sample> samples;
    double lowest = 0; ///< Of its axis.
    double highest = 1;
    bool isStepped = false; ///< A bit holds its value until the next sample.
    QPen pen;
    QChar letter;
};

/// The lines inside the axes of a plot, painted by hand: Qt Charts joins what lies on both sides of a gap.
class CurvesItem : public QGraphicsItem
{
public:
    using QGraphicsItem::QGraphicsItem;

    void show(std::vector<Curve> curves, const trend::Range &range);
    void setArea(const QRectF &area);
    void setCursor(std::optional<qreal> share);
    void setColors(const QColor &ground, const QColor &cursor);

    [[nodiscard]] const QRectF &area() const { return m_area; }
    [[nodiscard]] QPointF placeOf(const Curve &curve, const trend::Sample &sample) const;
    [[nodiscard]] const std::vector<Curve> &curves() const { return m_curves; }

    [[nodiscard]] QRectF boundingRect() const override { return m_area; }
    void paint(QPainter *painter, const QStyleOptionGraphicsItem *, QWidget *) override;

private:
    void paintLine(QPainter &painter, const Curve &curve) const;
    void paintLetters(QPainter &painter, const Curve &curve, int index) const;

    std::vector<Curve> m_curves;
    trend::Range m_range {};
    QRectF m_area;
    std::optional<qreal> m_cursor;
    QColor m_ground;
    QColor m_cursorColor;
};

} // namespace widgets
