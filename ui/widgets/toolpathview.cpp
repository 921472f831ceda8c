// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/widgets/toolpathview.h"

#include "trend/scale.h"
#include "ui/theme.h"
#include <QLocale>
#include <QPainter>
#include <algorithm>

namespace widgets {

using trend::PathPoint;

namespace {

constexpr qreal leastSpan = 10; ///< Millimetres in the shorter direction, so that a standing robot is no microscope.
constexpr qreal pathMargin = 9;

struct Axes {
    std::size_t right;
    std::size_t up;
};
constexpr Axes axesOf(ToolPathView::Side side)
{
    switch (side) {
    case ToolPathView::Side::Top: return {0, 1};
    case ToolPathView::Side::Front: return {1, 2};
    case ToolPathView::Side::Side: break;
    }
    return {0, 2};
}

QString title(ToolPathView::Side side)
{
    switch (side) {
    case ToolPathView::Side::Top: return ToolPathView::tr("Top");
    case ToolPathView::Side::Front: return ToolPathView::tr("Front");
    case ToolPathView::Side::Side: break;
    }
    return ToolPathView::tr("Side");
}

QString axisName(std::size_t axis) { return QString(QChar(u'X' + int(axis))); }

} // namespace

ToolPathView::ToolPathView(Side side, QWidget *parent) : QWidget(parent), m_side {side}
{
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    describe();
}

void ToolPathView::show(const trend::ToolPath &path)
{
    m_path = &path;
    fit();
    describe();
    update();
}

void ToolPathView::setStale(const QString &note)
{
    if (note == m_staleNote)
        return;
    m_staleNote = note;
    describe();
    update();
}

void ToolPathView::describe()
{
    const auto number = [](double value) { return QLocale().toString(value, 'f', 1); };
    const auto [right, up] = axesOf(m_side);
    setAccessibleName(tr("Tool path, %1 view").arg(title(m_side)));
    if (!m_path || m_path->isEmpty()) {
        setAccessibleDescription(tr("No position in the base frame was read yet."));
        return;
    }
    const PathPoint &now = m_path->points().back();
    setAccessibleDescription(
        tr("%1 %2 mm, %3 %4 mm. %5")
            .arg(axisName(right), number(now.mm[right]), axisName(up), number(now.mm[up]), m_staleNote)
            .trimmed());
}

QRectF ToolPathView::plot() const { return QRectF(rect()).adjusted(pathMargin, 22, -pathMargin, -24); }

QPointF ToolPathView::millimetres(const PathPoint &point) const
{
    const auto [right, up] = axesOf(m_side);
    return {point.mm[right], point.mm[up]};
}

void ToolPathView::fit()
{
    if (!m_path || m_path->isEmpty())
        return;
    QRectF bounds(millimetres(m_path->points().front()), QSizeF(0, 0));
    for (const PathPoint &point : m_path->points()) {
        const QPointF at = millimetres(point);
        bounds.setCoords(std::min(bounds.left(), at.x()), std::min(bounds.top(), at.y()),
            std::max(bounds.right(), at.x()), std::max(bounds.bottom(), at.y()));
    }
    m_centre = bounds.center();
    m_scale = std::max(0.001,
        std::min({plot().width() / bounds.width(), plot().height() / bounds.height(),
            std::min(plot().width(), plot().height()) / leastSpan}));
}

QPointF ToolPathView::placeOf(const PathPoint &point) const
{
    const QPointF away = (millimetres(point) - m_centre) * m_scale;
    return plot().center() + QPointF(away.x(), -away.y());
}

void ToolPathView::resizeEvent(QResizeEvent *event)
{
    QWidget::resizeEvent(event);
    fit();
}

void ToolPathView::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    paintFrame(painter);
    if (!m_path || m_path->isEmpty()) {
        painter.setPen(ui::color(ui::Role::Text3, this));
        painter.drawText(plot(), Qt::AlignCenter | Qt::TextWordWrap, QStringLiteral("—"));
        return;
    }
    painter.setRenderHint(QPainter::Antialiasing);
    paintPath(painter);
    paintMarks(painter);
    painter.setRenderHint(QPainter::Antialiasing, false);
    paintScale(painter);
}

void ToolPathView::paintFrame(QPainter &painter) const
{
    const auto [right, up] = axesOf(m_side);
    if (!m_staleNote.isEmpty())
        painter.fillRect(rect(), QBrush(ui::color(ui::Role::Hairline, this), Qt::BDiagPattern));
    painter.setPen(ui::color(ui::Role::Hairline, this));
    painter.drawRect(rect().adjusted(0, 0, -1, -1));
    painter.setFont(ui::font(ui::Type::Label));
    painter.setPen(ui::color(ui::Role::Text2, this));
    const QRect line(8, 4, width() - 16, 18);
    painter.drawText(line, Qt::AlignLeft | Qt::AlignVCenter,
        tr("%1  ·  %2 →  %3 ↑").arg(title(m_side), axisName(right), axisName(up)));
    painter.drawText(line, Qt::AlignRight | Qt::AlignVCenter, m_staleNote);
}

void ToolPathView::paintPath(QPainter &painter) const
{
    const ui::Role ink = m_staleNote.isEmpty() ? ui::Role::Accent : ui::Role::Text3;
    painter.setPen(QPen(ui::color(ink, this), 1.2));
    QPolygonF run;
    const auto flush = [&] {
        painter.drawPolyline(run);
        run.clear();
    };
    for (const PathPoint &point : m_path->points()) {
        if (point.isApart)
            flush();
        const QPointF place = placeOf(point);
        const bool isNews = run.isEmpty() || (place - run.back()).manhattanLength() >= 1;
        if (isNews || &point == &m_path->points().back())
            run << place;
    }
    flush();
}

/// A hollow square where the way began, a filled circle in a ring where the tool point is.
void ToolPathView::paintMarks(QPainter &painter) const
{
    const QColor ink = ui::color(m_staleNote.isEmpty() ? ui::Role::Fill : ui::Role::Text3, this);
    painter.setPen(QPen(ink, 1.5));
    painter.setBrush(ui::color(ui::Role::Card, this));
    const QPointF start = placeOf(m_path->points().front());
    painter.drawRect(QRectF(start.x() - pathMargin / 2, start.y() - pathMargin / 2, pathMargin, pathMargin));
    const QPointF now = placeOf(m_path->points().back());
    painter.drawEllipse(now, pathMargin / 2 + 1.5, pathMargin / 2 + 1.5);
    painter.setBrush(ink);
    painter.drawEllipse(now, pathMargin / 4, pathMargin / 4);
}

/// A bar of a round length at the lower left.
void ToolPathView::paintScale(QPainter &painter) const
{
    const double length = trend::roundLength(plot().width() / 3 / m_scale);
    const QPointF left(plot().left(), height() - 8);
    const QPointF right = left + QPointF(length * m_scale, 0);
    painter.setPen(ui::color(ui::Role::Text2, this));
    painter.drawLine(left, right);
    for (const QPointF &end : {left, right})
        painter.drawLine(end - QPointF(0, 3), end + QPointF(0, 3));
    painter.drawText(QRectF(right.x() + 6, left.y() - 9, width() - right.x() - 12, 18),
        Qt::AlignLeft | Qt::AlignVCenter, tr("%1 mm").arg(QLocale().toString(length, 'g', 6)));
}

} // namespace widgets
