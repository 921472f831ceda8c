// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/widgets/badge.h"

#include <QPainter>

namespace widgets {

Badge::Badge(const QString &word, ui::Role ink, ui::Role ground, QWidget *parent)
    : QLabel(word, parent), m_ink {ink}, m_ground {ground}
{
    QFont small = ui::font(ui::Type::Label);
    small.setWeight(QFont::DemiBold);
    setFont(small);
    setAlignment(Qt::AlignCenter);
    setContentsMargins(8, 2, 8, 2);
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
}

void Badge::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF frame = QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5);
    painter.setPen(ui::color(m_ink, this));
    painter.setBrush(ui::color(m_ground, this));
    painter.drawRoundedRect(frame, frame.height() / 2, frame.height() / 2);
    painter.drawText(rect(), Qt::AlignCenter, text());
}

} // namespace widgets
