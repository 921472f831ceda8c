// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/widgets/holdbutton.h"

#include "ui/theme.h"
#include <QPainter>
#include <algorithm>

namespace widgets {

namespace {

constexpr int leastWidth = 150;
constexpr int tallness = 52;

} // namespace

HoldButton::HoldButton(QWidget *parent) : QAbstractButton(parent)
{
    setText(tr("HOLD"));
    setFont(ui::font(ui::Type::Hold));
    setAccessibleName(tr("HOLD (software)"));
    setFocusPolicy(Qt::TabFocus);
    setCaption(tr("software hold · Pause key"));
    connect(this, &QAbstractButton::pressed, this, &HoldButton::holdRequested);
}

void HoldButton::setCaption(const QString &caption)
{
    if (caption == m_caption)
        return;
    m_caption = caption;
    setAccessibleDescription(caption);
    setToolTip(caption);
    makeRoomFor({caption});
    update();
}

void HoldButton::makeRoomFor(const QStringList &captions)
{
    const QFontMetrics metrics(ui::font(ui::Type::Label));
    for (const QString &caption : captions)
        m_captionRoom = std::max(m_captionRoom, metrics.horizontalAdvance(caption));
    updateGeometry();
}

QSize HoldButton::sizeHint() const
{
    const int caption = m_captionRoom + 22;
    const int word = fontMetrics().horizontalAdvance(text()) + 70;
    return {std::max({leastWidth, caption, word}), tallness};
}

void HoldButton::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(ui::color(hasFocus() ? ui::Role::Accent : ui::Role::Fill, this), hasFocus() ? 3 : 2));
    painter.setBrush(ui::color(isDown() ? ui::Role::Border : ui::Role::Raised, this));
    painter.drawRoundedRect(QRectF(rect()).adjusted(2, 2, -2, -2), ui::space::radius, ui::space::radius);
    const qreal middle = tallness * 0.58;
    paintWord(painter, QRectF(0, 4, width(), middle - 4));
    painter.setFont(ui::font(ui::Type::Label));
    painter.setPen(ui::color(ui::Role::Text2, this));
    const QString words = painter.fontMetrics().elidedText(m_caption, Qt::ElideRight, width() - 12);
    painter.drawText(QRectF(0, middle, width(), tallness - middle - 6), Qt::AlignCenter, words);
}

void HoldButton::paintWord(QPainter &painter, const QRectF &line) const
{
    const QFontMetricsF metrics(font());
    const qreal tall = metrics.capHeight();
    const qreal bar = tall * 0.36;
    const qreal bars = bar * 2.6;
    const qreal gap = tall * 0.6;
    const qreal left = line.center().x() - (bars + gap + metrics.horizontalAdvance(text())) / 2;
    const qreal top = line.center().y() - tall / 2;
    const QColor ink = ui::color(ui::Role::Fill, this);
    painter.fillRect(QRectF(left, top, bar, tall), ink);
    painter.fillRect(QRectF(left + bars - bar, top, bar, tall), ink);
    painter.setPen(ink);
    painter.drawText(QPointF(left + bars + gap, top + tall), text());
}

} // namespace widgets
