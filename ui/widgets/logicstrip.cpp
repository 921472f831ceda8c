// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/widgets/logicstrip.h"

#include "ui/theme.h"
#include <QPainter>

namespace widgets {

using namespace std::chrono_literals;
using robot::Time;

namespace {

constexpr int trackHeight = 30;
constexpr int scaleHeight = 20;
constexpr int labelWidth = 200;

} // namespace

LogicStrip::LogicStrip(const robot::SignalWatch &watch, const robot::NameBook &book, QWidget *parent)
    : QWidget(parent), m_watch {watch}, m_book {book}
{
    setAccessibleName(tr("The watched signals over the last minute"));
    m_pace.setInterval(100ms);
    connect(&m_pace, &QTimer::timeout, this, qOverload<>(&QWidget::update));
    connect(&watch, &robot::SignalWatch::listChanged, this, [this] {
        updateGeometry();
        update();
    });
}

QSize LogicStrip::sizeHint() const { return {600, int(m_watch.traces().size()) * trackHeight + scaleHeight}; }

void LogicStrip::showEvent(QShowEvent *) { m_pace.start(); }

void LogicStrip::hideEvent(QHideEvent *) { m_pace.stop(); }

void LogicStrip::paintTrack(QPainter &painter, const robot::SignalTrace &trace, const QRect &track, Time now) const
{
    const auto xOf = [&](Time at) {
        const std::chrono::duration<double> age = now - at;
        const double share = 1 - age / std::chrono::duration<double>(window);
        return track.left() + int(std::max(share, 0.0) * track.width());
    };
    const int high = track.top() + 6;
    const int low = track.bottom() - 6;
    for (std::size_t i = 0; i < trace.spans.size(); ++i) {
        const auto &span = trace.spans[i];
        const int from = xOf(span.from);
        const int to = i + 1 < trace.spans.size() ? xOf(trace.spans[i + 1].from) : track.right();
        if (!span.isOn) {
            painter.fillRect(
                from, high, to - from, low - high, QBrush(ui::color(ui::Role::Border, this), Qt::BDiagPattern));
            continue;
        }
        const int level = *span.isOn ? high : low;
        if (*span.isOn)
            painter.fillRect(from, high, to - from, low - high, ui::color(ui::Role::AccentGround, this));
        if (i > 0 && trace.spans[i - 1].isOn == !*span.isOn)
            painter.drawLine(from, high, from, low);
        painter.drawLine(from, level, to, level);
    }
}

void LogicStrip::paintScale(QPainter &painter, const QRect &room) const
{
    painter.setPen(ui::color(ui::Role::Text2, this));
    for (int seconds = 60; seconds >= 0; seconds -= 15) {
        const int x = room.right() - room.width() * seconds / int(window.count());
        const QString words = seconds == 0 ? tr("now") : tr("−%1 s").arg(seconds);
        const QRect label(x - 30, room.top(), seconds == 0 ? 30 : 60, room.height());
        painter.drawText(label, (seconds == 0 ? Qt::AlignRight : Qt::AlignHCenter) | Qt::AlignVCenter, words);
    }
}

void LogicStrip::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    painter.setFont(ui::font(ui::Type::Label));
    const Time now = values::now();
    QRect track(labelWidth, 0, width() - labelWidth - 8, trackHeight);
    for (const auto &trace : m_watch.traces()) {
        const QString name = m_book.names().of(trace.signal).text;
        const QString words = (toString(trace.signal) + u' ' + name).trimmed();
        painter.setPen(ui::color(ui::Role::Text1, this));
        painter.drawText(QRect(8, track.top(), labelWidth - 16, trackHeight), Qt::AlignVCenter,
            painter.fontMetrics().elidedText(words, Qt::ElideRight, labelWidth - 16));
        painter.setPen(QPen(ui::color(ui::Role::Text1, this), 1));
        paintTrack(painter, trace, track, now);
        painter.setPen(ui::color(ui::Role::Hairline, this));
        painter.drawLine(8, track.bottom(), width() - 8, track.bottom());
        track.translate(0, trackHeight);
    }
    paintScale(painter, QRect(track.left(), track.top(), track.width(), scaleHeight));
}

} // namespace widgets
