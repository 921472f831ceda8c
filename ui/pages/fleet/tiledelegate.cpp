// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/pages/fleet/tiledelegate.h"

#include <QFontMetrics>
#include <QPainter>

namespace pages {

using models::FleetRow;
using models::Trouble;
using ui::Role;
using ui::Type;

namespace {

constexpr QSize mediumTile {262, 190};
constexpr int tileGap = 10;
constexpr int tileInside = 14;

/// The frame says the same as the word.
Role frameOf(const FleetRow &row)
{
    switch (row.trouble) {
    case Trouble::Alarm: return Role::Alarm;
    case Trouble::NoLink:
    case Trouble::Held: return Role::Amber;
    case Trouble::None: break;
    }
    return row.isArmed ? Role::Fill : row.isSimulation ? Role::Magenta : Role::Border;
}

/// What stands at the upper right.
QString markOf(const FleetRow &row)
{
    if (row.isArmed)
        return TileDelegate::tr("ARMED");
    if (row.isSimulation)
        return TileDelegate::tr("SIMULATION");
    return row.isOpen ? row.mode : TileDelegate::tr("NOT CONNECTED");
}

/// Lines of text in a tile, one beneath the other; each has its height whether or not it says something.
class Lines
{
public:
    Lines(QPainter &painter, const QRect &room, ui::Scheme scheme)
        : m_painter {painter}, m_left {room}, m_scheme {scheme}
    {
    }

    void write(const QFont &font, Role role, const QString &text, const QString &right = {}, int indent = 0)
    {
        const QFontMetrics metrics {font};
        QRect line {m_left.left() + indent, m_left.top(), m_left.width() - indent, metrics.height()};
        m_painter.setFont(font);
        if (!right.isEmpty()) {
            m_painter.setPen(ui::color(Role::Text2, m_scheme));
            m_painter.drawText(line, Qt::AlignRight | Qt::AlignVCenter, right);
            line.setRight(line.right() - metrics.horizontalAdvance(right) - tileGap);
        }
        m_painter.setPen(ui::color(role, m_scheme));
        m_painter.drawText(
            line, Qt::AlignLeft | Qt::AlignVCenter, metrics.elidedText(text, Qt::ElideRight, line.width()));
        m_left.setTop(line.bottom() + 4);
    }
    [[nodiscard]] const QRect &left() const { return m_left; }

private:
    QPainter &m_painter;
    QRect m_left;
    ui::Scheme m_scheme;
};

QString sinceText(const FleetRow &row)
{
    return row.since.isValid() ? TileDelegate::tr("since %1").arg(row.since.toString(u"HH:mm:ss")) : QString();
}

} // namespace

qreal TileDelegate::scale() const { return m_size == Size::Small ? 0.8 : m_size == Size::Medium ? 1.0 : 1.7; }

QFont TileDelegate::font(Type type, bool isBold) const
{
    QFont result = ui::font(type);
    result.setPointSizeF(result.pointSizeF() * scale());
    if (isBold)
        result.setWeight(QFont::DemiBold);
    return result;
}

QSize TileDelegate::sizeHint(const QStyleOptionViewItem &, const QModelIndex &) const
{
    const int lines = QFontMetrics(font(Type::Body)).height() * 5 + QFontMetrics(font(Type::Hold)).height();
    const QSize size = mediumTile * scale();
    return {size.width(), std::max(size.height(), lines + 6 * 4 + 2 * tileInside + tileGap)};
}

void TileDelegate::paintGround(QPainter &painter, const QRect &tile, const FleetRow &row, ui::Scheme scheme) const
{
    const bool isTroubled = row.trouble != Trouble::None || row.isArmed;
    painter.setPen(QPen(ui::color(frameOf(row), scheme), isTroubled ? 2 : 1));
    painter.setBrush(ui::color(Role::Card, scheme));
    painter.drawRoundedRect(QRectF(tile).adjusted(1, 1, -1, -1), ui::space::radius, ui::space::radius);
    if (row.tag > 0)
        painter.fillRect(QRect(tile.left() + 2, tile.top() + 4, 6, tile.height() - 8), ui::tagColor(row.tag, scheme));
}

void TileDelegate::paint(QPainter *painter, const QStyleOptionViewItem &option, const QModelIndex &index) const
{
    const auto *row = static_cast<const FleetRow *>(index.data(models::FleetModel::RowRole).value<const void *>());
    if (!row)
        return;
    const ui::Scheme scheme = ui::schemeOf(option.palette);
    const QRect tile = option.rect.adjusted(0, 0, -tileGap, -tileGap);
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    paintGround(*painter, tile, *row, scheme);
    if (option.state.testFlag(QStyle::State_HasFocus) || option.state.testFlag(QStyle::State_Selected)) {
        painter->setPen(QPen(ui::color(Role::Accent, scheme), 2));
        painter->setBrush(Qt::NoBrush);
        painter->drawRoundedRect(QRectF(tile).adjusted(3, 3, -3, -3), ui::space::radius, ui::space::radius);
    }
    Lines lines {*painter, tile.adjusted(tileInside, tileInside, -tileInside, -tileInside), scheme};
    lines.write(font(Type::Body, true), Role::Text1, row->name, markOf(*row));
    const int big = QFontMetrics(font(Type::Hold)).height();
    const int lamp = big * 6 / 10;
    widgets::paintLamp(*painter, QRect(lines.left().left(), lines.left().top() + (big - lamp) / 2, lamp, lamp),
        row->state.lamp, scheme);
    const bool hasLamp = row->state.lamp != widgets::Lamp::None;
    lines.write(font(Type::Hold), hasLamp ? widgets::roleOf(row->state.lamp) : Role::Text2, row->state.text, {},
        hasLamp ? lamp + 8 : 0);
    const Role why = row->trouble == Trouble::Alarm ? Role::Alarm
        : row->trouble == Trouble::None             ? Role::Text2
                                                    : Role::Amber;
    lines.write(font(Type::Body), why, row->reason);
    lines.write(font(Type::Label), Role::Text2, sinceText(*row));
    lines.write(font(Type::Body, true), row->isStale ? Role::Text2 : Role::Text1, row->job);
    lines.write(font(Type::Label), Role::Text2, row->isStale ? tr("last seen: %1").arg(row->place) : row->place);
    lines.write(font(Type::Label), Role::Text2, tr("Servo %1").arg(row->servo), row->link);
    painter->restore();
}

} // namespace pages
