// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/widgets/lampdelegate.h"

#include <QPainter>

namespace widgets {

using robot::Freshness;

namespace {

constexpr int lampRoom = 18;
constexpr int lampMargin = 8;

ui::Role nameRole(const models::Lamp &lamp)
{
    return lamp.freshness == Freshness::Live ? ui::Role::Text1 : ui::Role::Text3;
}

} // namespace

void paintSignal(QPainter &painter, const QRect &square, const models::Lamp &lamp, ui::Scheme scheme)
{
    const bool isKnown = lamp.freshness == Freshness::Live || lamp.freshness == Freshness::Stale;
    const QColor fill = ui::color(isKnown ? ui::Role::Fill : ui::Role::Text3, scheme);
    const bool isFilled = isKnown && lamp.isOn;
    if (lamp.isRecent) {
        painter.setPen(QPen(ui::color(ui::Role::Accent, scheme), 2));
        painter.setBrush(Qt::NoBrush);
        painter.drawRect(square.adjusted(-4, -4, 3, 3));
    }
    painter.save();
    painter.setOpacity(lamp.freshness == Freshness::Stale ? 1.0 / 3 : 1);
    painter.setPen(QPen(fill, isKnown ? 2 : 1, isKnown ? Qt::SolidLine : Qt::DotLine, Qt::SquareCap, Qt::MiterJoin));
    painter.setBrush(isFilled ? QBrush(fill) : Qt::NoBrush);
    painter.drawRect(square.adjusted(1, 1, -2, -2));
    painter.restore();
    painter.setPen(ui::color(isFilled ? ui::Role::Card : nameRole(lamp), scheme));
    const QString digit = !isKnown ? QStringLiteral("–") : lamp.isOn ? QStringLiteral("1") : QStringLiteral("0");
    painter.drawText(square, Qt::AlignCenter | Qt::TextSingleLine, digit);
}

void LampDelegate::paint(QPainter *painter, const QStyleOptionViewItem &option, const QModelIndex &index) const
{
    const auto *model = qobject_cast<const models::IoModel *>(index.model());
    if (!model)
        return;
    const models::Lamp lamp = model->lamp(index);
    const ui::Scheme scheme = ui::schemeOf(option.palette);
    painter->save();
    paintGround(painter, option, index);
    const QRect square(option.rect.left() + lampMargin, option.rect.center().y() - lampRoom / 2, lampRoom, lampRoom);
    painter->setFont(ui::font(ui::Type::Label));
    paintSignal(*painter, square, lamp, scheme);
    const QRect words = option.rect.adjusted(lampMargin + lampRoom + lampMargin, 2, -4, -3);
    const QFontMetrics metrics = painter->fontMetrics();
    const auto line = [&](const QRect &room, const QString &text, ui::Role role) {
        painter->setPen(ui::color(role, scheme));
        painter->drawText(
            room, Qt::AlignVCenter | Qt::TextSingleLine, metrics.elidedText(text, Qt::ElideRight, room.width()));
    };
    const QString name = lamp.name.isLocal ? u'*' + lamp.name.text : lamp.name.text;
    if (name.isEmpty()) {
        line(words, lamp.address, ui::Role::Text2);
    } else {
        const int half = words.height() / 2;
        line({words.left(), words.top(), words.width(), half}, lamp.address, ui::Role::Text2);
        line({words.left(), words.top() + half, words.width(), half}, name, nameRole(lamp));
    }
    painter->restore();
}

} // namespace widgets
