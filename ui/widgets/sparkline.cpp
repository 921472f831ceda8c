// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/widgets/sparkline.h"

#include "ui/widgets/lamp.h"
#include <QLocale>
#include <QPainter>
#include <algorithm>

namespace widgets {

namespace {

constexpr int secondsShown = 60;
constexpr qreal lossMark = 7; ///< Side of the triangle of a lost try.
constexpr std::chrono::microseconds leastScale {1000}; ///< A line of 0.2 ms does not fill the height.

} // namespace

Sparkline::Sparkline(QWidget *parent) : QWidget(parent) { describe(); }

void Sparkline::show(const std::vector<session::LinkSecond> &seconds)
{
    m_seconds = seconds;
    describe();
    update();
}

void Sparkline::describe()
{
    const auto missed = std::count_if(m_seconds.begin(), m_seconds.end(), [](const auto &s) { return s.missed > 0; });
    const double milliseconds = double(longest().count()) / 1000;
    setAccessibleName(m_seconds.empty()
            ? tr("Round trips of the last 60 seconds: none yet.")
            : tr("Round trips of the last 60 seconds: longest %1 ms, lost tries in %2 s.")
                  .arg(QLocale().toString(milliseconds, 'f', 1), QLocale().toString(int(missed))));
    setToolTip(accessibleName());
}

std::chrono::microseconds Sparkline::longest() const
{
    std::chrono::microseconds result {0};
    for (const auto &second : m_seconds)
        result = std::max(result, second.roundTrip.value_or(std::chrono::microseconds {0}));
    return result;
}

QRectF Sparkline::plot() const { return QRectF(rect()).adjusted(lossMark, 4, -lossMark, -lossMark - 4); }

qreal Sparkline::xOf(std::size_t index) const
{
    const qreal fromRight = qreal(m_seconds.size() - 1 - index);
    return plot().right() - fromRight * plot().width() / (secondsShown - 1);
}

void Sparkline::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    painter.setPen(ui::color(ui::Role::Hairline, this));
    painter.drawLine(plot().bottomLeft(), plot().bottomRight());
    painter.setRenderHint(QPainter::Antialiasing);
    paintLine(painter);
    paintMissed(painter);
}

void Sparkline::paintLine(QPainter &painter) const
{
    painter.setPen(QPen(ui::color(ui::Role::Accent, this), 1.5));
    const qreal scale = plot().height() / double(std::max(longest(), leastScale).count());
    QPolygonF run;
    const auto flush = [&] {
        if (run.size() == 1)
            painter.drawEllipse(run.front(), 0.7, 0.7);
        painter.drawPolyline(run);
        run.clear();
    };
    for (std::size_t i = 0; i < m_seconds.size(); ++i) {
        if (const auto &trip = m_seconds[i].roundTrip)
            run << QPointF(xOf(i), plot().bottom() - double(trip->count()) * scale);
        else
            flush();
    }
    flush();
}

void Sparkline::paintMissed(QPainter &painter) const
{
    const ui::Scheme scheme = ui::schemeOf(palette());
    for (std::size_t i = 0; i < m_seconds.size(); ++i) {
        if (m_seconds[i].missed > 0)
            paintLamp(
                painter, QRectF(xOf(i) - lossMark / 2, plot().bottom() + 3, lossMark, lossMark), Lamp::Warning, scheme);
    }
}

} // namespace widgets
