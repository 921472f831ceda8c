// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/widgets/valuelabel.h"

#include <QPainter>
#include <algorithm>

namespace widgets {

using robot::Freshness;

ValueLabel::ValueLabel(ui::Type type, QWidget *parent) : QLabel(parent), m_shown {unknown()}
{
    setTextFormat(Qt::PlainText);
    setFont(ui::font(type));
    setText(m_shown.word.text);
    setToolTip(m_shown.note);
}

void ValueLabel::show(const Shown &shown)
{
    if (shown == m_shown)
        return;
    const bool isSameSize =
        shown.word.text == m_shown.word.text && (shown.word.lamp == Lamp::None) == (m_shown.word.lamp == Lamp::None);
    m_shown = shown;
    if (!isSameSize)
        setText(shown.word.text);
    describe();
    update();
}

void ValueLabel::setTitle(const QString &title)
{
    m_title = title;
    describe();
}

void ValueLabel::setRole(ui::Role role)
{
    m_role = role;
    update();
}

void ValueLabel::setReserve(const QString &text)
{
    m_reserve = text;
    updateGeometry();
}

void ValueLabel::describe()
{
    const QString note = m_shown.note;
    setToolTip(note.isEmpty() && m_isElided ? m_shown.word.text : note);
    const QString words = m_title.isEmpty() ? m_shown.word.text : tr("%1: %2").arg(m_title, m_shown.word.text);
    setAccessibleName(note.isEmpty() ? words : tr("%1. %2").arg(words, note));
}

qreal ValueLabel::lampSide() const { return std::round(fontMetrics().capHeight() * 0.95); }

int ValueLabel::lampSpace() const { return m_shown.word.lamp == Lamp::None ? 0 : qRound(lampSide() * 1.6); }

qreal ValueLabel::advance(QChar character) const
{
    const QFontMetricsF metrics(font());
    if (!m_isTabular || !character.isDigit())
        return metrics.horizontalAdvance(character);
    return metrics.horizontalAdvance(u'0');
}

qreal ValueLabel::textWidth(const QString &text) const
{
    if (!m_isTabular)
        return QFontMetricsF(font()).horizontalAdvance(text);
    qreal width = 0;
    for (const QChar character : text)
        width += advance(character);
    return width;
}

QSize ValueLabel::sizeHint() const
{
    const qreal width = std::max(textWidth(m_shown.word.text), textWidth(m_reserve));
    return {lampSpace() + int(std::ceil(width)) + 2, fontMetrics().height() + 4};
}

QSize ValueLabel::minimumSizeHint() const
{
    if (!m_isElided)
        return sizeHint();
    const int least = lampSpace() + fontMetrics().horizontalAdvance(QStringLiteral("WWW…"));
    return {std::min(least, sizeHint().width()), sizeHint().height()};
}

ui::Role ValueLabel::inkRole() const
{
    if (m_shown.freshness != Freshness::Live)
        return ui::Role::Text3;
    const ui::Role lampRole = roleOf(m_shown.word.lamp);
    return lampRole == ui::Role::Text1 ? m_role : lampRole;
}

void ValueLabel::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    const ui::Scheme scheme = ui::schemeOf(palette());
    const bool isStale = m_shown.freshness == Freshness::Stale;
    if (isStale)
        painter.fillRect(rect(), QBrush(ui::color(ui::Role::Border, scheme), Qt::BDiagPattern));
    const qreal side = lampSide();
    const QRectF square(0, std::round((height() - side) / 2), side, side);
    paintLamp(painter, square, m_shown.word.lamp, scheme, isStale ? 1.0 / 3 : 1);
    painter.setPen(ui::color(inkRole(), scheme));
    drawText(painter, QRectF(rect()).adjusted(lampSpace(), 0, 0, 0));
}

void ValueLabel::drawText(QPainter &painter, const QRectF &room) const
{
    const QString words = m_isElided
        ? fontMetrics().elidedText(m_shown.word.text, Qt::ElideRight, int(room.width()) + 1)
        : m_shown.word.text;
    if (!m_isTabular) {
        painter.drawText(room, int(alignment() | Qt::TextSingleLine), words);
        return;
    }
    const QFontMetricsF metrics(font());
    qreal x = alignment() & Qt::AlignRight ? room.right() - textWidth(words) : room.left();
    const qreal baseline = room.center().y() + (metrics.ascent() - metrics.descent()) / 2;
    for (const QChar character : words) {
        const qreal inset = (advance(character) - metrics.horizontalAdvance(character)) / 2;
        painter.drawText(QPointF(x + inset, baseline), character);
        x += advance(character);
    }
}

} // namespace widgets
