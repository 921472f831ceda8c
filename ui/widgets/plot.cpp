// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/widgets/plot.h"

#include "ui/theme.h"
#include "ui/widgets/curvesitem.h"
#include <QEvent>
#include <QKeyEvent>
#include <QtCharts/QChart>
#include <QtCharts/QValueAxis>
#include <algorithm>

namespace widgets {

using trend::Track;
using trend::Unit;

namespace {

constexpr qreal cursorStep = 0.01; ///< Of the width, for the arrow keys.

constexpr trend::Scale bitScale {-0.1, 1.1, 1}; ///< 0 and 1 stand clear of the edges.

struct Line {
    ui::Role role;
    Qt::PenStyle style;
};

/// A kind of line for each place; no two are the same without colour, since the letters differ too.
constexpr Line trackLines[] {
    {ui::Role::Accent, Qt::SolidLine},
    {ui::Role::Text1, Qt::SolidLine},
    {ui::Role::Accent, Qt::DashLine},
    {ui::Role::Text1, Qt::DashLine},
    {ui::Role::Accent, Qt::DotLine},
    {ui::Role::Text1, Qt::DotLine},
    {ui::Role::Accent, Qt::DashDotLine},
    {ui::Role::Text1, Qt::DashDotLine},
};
static_assert(std::size(trackLines) == Plot::mostTracks);

double seconds(trend::Moment at, trend::Moment zero) { return double((at - zero).count()) / 1000; }

} // namespace

Plot::Plot(QWidget *parent) : QChartView(parent), m_timeAxis {new QValueAxis}, m_curves {new CurvesItem(chart())}
{
    setFrameShape(QFrame::NoFrame);
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setMinimumSize(320, 180);
    setViewportUpdateMode(QGraphicsView::FullViewportUpdate);
    chart()->legend()->hide();
    chart()->setMargins({0, 0, 0, 0});
    chart()->setBackgroundRoundness(0);
    chart()->setLocalizeNumbers(true);
    chart()->addAxis(m_timeAxis, Qt::AlignBottom);
    m_timeAxis->setTitleText(tr("seconds"));
    m_timeAxis->setTickType(QValueAxis::TicksDynamic);
    m_timeAxis->setLabelFormat(QStringLiteral("%.0f"));
    m_curves->setZValue(100);
    connect(chart(), &QChart::plotAreaChanged, this, [this](const QRectF &area) {
        m_curves->setArea(area);
        redraw();
    });
    dress();
    describe();
}

Plot::~Plot() = default;

QPen Plot::pen(int index, const QWidget *widget)
{
    const Line &line = trackLines[index % mostTracks];
    QPen pen(ui::color(line.role, widget), 1, line.style);
    pen.setCosmetic(true);
    return pen;
}

void Plot::show(const std::vector<const Track *> &tracks, const trend::Range &range, trend::Moment zero)
{
    m_tracks.assign(tracks.begin(), tracks.begin() + std::min<std::ptrdiff_t>(std::ssize(tracks), mostTracks));
    const bool isMoved = range != m_range;
    m_range = range;
    m_zero = zero;
    placeAxes();
    redraw();
    describe();
    if (isMoved && m_cursor)
        Q_EMIT cursorChanged();
}

/// An axis for each unit that is shown, and none for the others. The first one stands at the left.
void Plot::placeAxes()
{
    const auto isUsed = [this](Unit unit) {
        return std::ranges::any_of(m_tracks, [&](const Track *t) { return t->unit == unit; });
    };
    std::erase_if(m_axes, [&](const auto &entry) {
        if (isUsed(entry.first))
            return false;
        chart()->removeAxis(entry.second.axis);
        delete entry.second.axis;
        return true;
    });
    for (const Track *track : m_tracks) {
        Axis &axis = m_axes[track->unit];
        if (!axis.axis) {
            axis.axis = new QValueAxis;
            axis.axis->setTickType(QValueAxis::TicksDynamic);
            chart()->addAxis(axis.axis, m_axes.size() == 1 ? Qt::AlignLeft : Qt::AlignRight);
            axis.axis->setGridLineVisible(m_axes.size() == 1);
            dress();
        }
        const QString unit = trend::toString(track->unit);
        const QString letters = lettersOf(track->unit);
        axis.axis->setTitleText(unit.isEmpty() ? letters : tr("%1: %2").arg(letters, unit));
    }
    const double from = seconds(m_range.from, m_zero);
    const double to = seconds(m_range.to, m_zero);
    if (m_timeAxis->min() == from && m_timeAxis->max() == to)
        return;
    m_timeAxis->setRange(from, to);
    m_timeAxis->setTickInterval(trend::roundLength((to - from) / 5));
}

QString Plot::lettersOf(Unit unit) const
{
    QString letters;
    for (int i = 0; i < int(m_tracks.size()); ++i) {
        if (m_tracks[std::size_t(i)]->unit == unit)
            letters += letter(i);
    }
    return letters;
}

void Plot::redraw()
{
    std::vector<Curve> curves;
    for (int i = 0; i < int(m_tracks.size()); ++i) {
        const Track &track = *m_tracks[std::size_t(i)];
        curves.push_back({trend::decimate(track.series, m_range, int(m_curves->area().width())), 0, 1,
            track.unit == Unit::Bit, pen(i, this), letter(i)});
    }
    for (auto &[unit, axis] : m_axes)
        scale(axis, unit, extentOf(unit, curves));
    for (std::size_t i = 0; i < curves.size(); ++i) {
        const trend::Scale &scale = m_axes[m_tracks[i]->unit].scale;
        curves[i].lowest = scale.lowest;
        curves[i].highest = scale.highest;
    }
    m_curves->show(std::move(curves), m_range);
}

trend::Extent Plot::extentOf(Unit unit, const std::vector<Curve> &curves) const
{
    trend::Extent extent;
    for (std::size_t i = 0; i < curves.size(); ++i) {
        if (m_tracks[i]->unit != unit)
            continue;
        for (const trend::Sample &sample : curves[i].samples)
            extent.include(sample.value);
    }
    return extent;
}

void Plot::scale(Axis &axis, Unit unit, const trend::Extent &extent)
{
    const trend::Scale scale = unit == Unit::Bit ? bitScale : trend::kept(axis.scale, extent);
    if (scale == axis.scale && axis.axis->tickInterval() == scale.step)
        return;
    axis.scale = scale;
    axis.axis->setRange(scale.lowest, scale.highest);
    axis.axis->setTickInterval(scale.step);
    const int decimals = std::max(0, int(std::ceil(-std::log10(scale.step))));
    axis.axis->setLabelFormat(QStringLiteral("%.%1f").arg(decimals));
}

std::optional<trend::Moment> Plot::cursor() const
{
    if (!m_cursor)
        return std::nullopt;
    const auto width = m_range.to - m_range.from;
    return m_range.from + std::chrono::milliseconds {std::llround(double(width.count()) * m_cursor->share)};
}

void Plot::setCursor(std::optional<PlotCursor> cursor)
{
    if (cursor)
        cursor->share = std::clamp<qreal>(cursor->share, 0, 1);
    if (cursor == m_cursor)
        return;
    m_cursor = cursor;
    m_curves->setCursor(cursor ? std::optional(cursor->share) : std::nullopt);
    Q_EMIT cursorChanged();
}

QPointF Plot::placeOf(const Track &track, const trend::Sample &sample) const
{
    const auto found = m_axes.find(track.unit);
    const trend::Scale scale = found == m_axes.end() ? trend::Scale {} : found->second.scale;
    return mapFromScene(m_curves->placeOf({{}, scale.lowest, scale.highest, false, {}, {}}, sample));
}

void Plot::mouseMoveEvent(QMouseEvent *event)
{
    const QRectF area = m_curves->area();
    const QPointF at = mapToScene(event->position().toPoint());
    if (area.contains(at))
        setCursor(PlotCursor {(at.x() - area.left()) / area.width()});
    QChartView::mouseMoveEvent(event);
}

void Plot::leaveEvent(QEvent *event)
{
    setCursor(std::nullopt);
    QChartView::leaveEvent(event);
}

void Plot::keyPressEvent(QKeyEvent *event)
{
    const qreal share = m_cursor ? m_cursor->share : 1;
    switch (event->key()) {
    case Qt::Key_Left: return setCursor(PlotCursor {share - cursorStep});
    case Qt::Key_Right: return setCursor(PlotCursor {share + cursorStep});
    case Qt::Key_Home: return setCursor(PlotCursor {0});
    case Qt::Key_End: return setCursor(PlotCursor {1});
    case Qt::Key_Escape:
        if (m_cursor)
            return setCursor(std::nullopt);
        break;
    default: break;
    }
    QChartView::keyPressEvent(event);
}

void Plot::changeEvent(QEvent *event)
{
    QChartView::changeEvent(event);
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::StyleChange) {
        dress();
        redraw();
    }
}

void Plot::resizeEvent(QResizeEvent *event)
{
    QChartView::resizeEvent(event);
    redraw();
}

void Plot::dress()
{
    const auto color = [this](ui::Role role) { return ui::color(role, this); };
    setBackgroundBrush(color(ui::Role::Card));
    chart()->setBackgroundBrush(color(ui::Role::Card));
    chart()->setBackgroundPen(Qt::NoPen);
    m_curves->setColors(color(ui::Role::Card), color(ui::Role::Fill));
    for (QAbstractAxis *axis : chart()->axes()) {
        axis->setLabelsFont(ui::font(ui::Type::Label));
        axis->setTitleFont(ui::font(ui::Type::Label));
        axis->setLabelsColor(color(ui::Role::Text2));
        axis->setTitleBrush(color(ui::Role::Text2));
        axis->setLinePenColor(color(ui::Role::Border));
        axis->setGridLineColor(color(ui::Role::Hairline));
    }
}

void Plot::describe()
{
    QStringList labels;
    for (int i = 0; i < int(m_tracks.size()); ++i)
        labels << tr("%1: %2").arg(letter(i)).arg(m_tracks[std::size_t(i)]->label);
    setAccessibleName(tr("Plot"));
    setAccessibleDescription(labels.isEmpty() ? tr("Nothing is plotted.") : labels.join(u'\n'));
}

} // namespace widgets
