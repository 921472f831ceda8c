// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "contactsheet.h"

#include "ui/theme.h"
#include <QPainter>

namespace pendesk {

namespace {

constexpr QSize cell {576, 360}; // a window of 1440 × 900, and two fifths of it can still be read
constexpr int gap = 12;
constexpr int head = 36;

QPoint corner(int row, int column) { return {gap + column * (cell.width() + gap), head + row * (cell.height() + gap)}; }

} // namespace

ContactSheet::ContactSheet(int rows, const QStringList &headings)
    : m_image {corner(rows, int(headings.size())).x(), corner(rows, 0).y(), QImage::Format_RGB32}
{
    m_image.fill(ui::color(ui::Role::Fill, ui::Scheme::Light));
    QPainter painter {&m_image};
    painter.setFont(ui::font(ui::Type::State));
    painter.setPen(ui::color(ui::Role::Raised, ui::Scheme::Light));
    for (int column = 0; column < int(headings.size()); ++column)
        painter.drawText(QRect(corner(0, column).x(), 0, cell.width(), head), Qt::AlignVCenter, headings[column]);
}

void ContactSheet::add(int row, int column, const QImage &picture)
{
    QPainter painter {&m_image};
    painter.drawImage(corner(row, column), picture.scaled(cell, Qt::KeepAspectRatio, Qt::SmoothTransformation));
}

} // namespace pendesk
