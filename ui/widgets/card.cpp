// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/widgets/card.h"

#include "ui/widgets/flow.h"
#include "ui/widgets/text.h"
#include <QPainter>

namespace widgets {

Card::Card(const QString &title, QWidget *parent)
    : QWidget(parent),
      m_title {text(title, ui::Type::Heading, ui::Role::Text2)},
      m_note {text({}, ui::Type::Heading, ui::Role::Text2)},
      m_reason {new Line(ui::Role::Amber)},
      m_body {new QVBoxLayout}
{
    auto *header = new Flow;
    header->setSpacing(ui::space::gap);
    header->addWidget(m_title);
    header->addStretch();
    header->addWidget(m_note);
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(ui::space::inside, 10, ui::space::inside, ui::space::inside);
    column->setSpacing(0);
    column->addLayout(header);
    column->addWidget(m_reason);
    column->addLayout(m_body, 1);
    m_body->setSpacing(6);
    m_reason->setObjectName(QStringLiteral("reason"));
    m_title->setVisible(!title.isEmpty());
    m_note->hide();
    setAccessibleName(title);
}

void Card::setTitle(const QString &title)
{
    m_title->setText(title);
    m_title->setVisible(!title.isEmpty());
    setAccessibleName(title);
}

void Card::setNote(const QString &note)
{
    m_note->setText(note);
    m_note->setVisible(!note.isEmpty());
}

void Card::setReason(const QString &reason) { m_reason->setWords(reason); }

void Card::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(ui::color(ui::Role::Border, this));
    painter.setBrush(ui::color(ui::Role::Card, this));
    painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), ui::space::radius, ui::space::radius);
}

} // namespace widgets
