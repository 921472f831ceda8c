// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/widgets/messagebar.h"

#include "ui/widgets/text.h"
#include <QAccessible>
#include <QHBoxLayout>
#include <QPainter>
#include <QPushButton>

namespace widgets {

namespace {

struct Look {
    ui::Role ink;
    ui::Role ground;
    Lamp lamp;
};

Look look(Severity severity)
{
    switch (severity) {
    case Severity::Alarm: return {ui::Role::Alarm, ui::Role::AlarmGround, Lamp::Diamond};
    case Severity::Warning: return {ui::Role::Amber, ui::Role::AmberGround, Lamp::Warning};
    case Severity::Notice: break;
    }
    return {ui::Role::Text1, ui::Role::Raised, Lamp::Filled};
}

constexpr int lampSide = 10;
constexpr int barMargin = 12;

} // namespace

MessageBar::MessageBar(QWidget *parent)
    : QWidget(parent),
      m_text {sentence({}, ui::Role::Text1)},
      m_link {new QPushButton},
      m_close {new QPushButton(QStringLiteral("✕"))}
{
    auto *row = new QHBoxLayout(this);
    row->setContentsMargins(barMargin + lampSide + 8, 7, barMargin, 7);
    row->setSpacing(ui::space::gap);
    row->addWidget(m_text, 1);
    row->addWidget(m_link);
    row->addWidget(m_close);
    m_text->setObjectName(QStringLiteral("messageText"));
    m_link->setObjectName(QStringLiteral("messageLink"));
    m_link->setProperty("link", true);
    m_link->setCursor(Qt::PointingHandCursor);
    m_close->setObjectName(QStringLiteral("messageClose"));
    m_close->setAccessibleName(tr("Close this message"));
    m_close->setProperty("link", true);
    m_close->hide();
    connect(m_link, &QPushButton::clicked, this, &MessageBar::linkActivated);
    connect(m_close, &QPushButton::clicked, this, [this] {
        hide();
        Q_EMIT changed();
    });
    setVisible(false);
}

void MessageBar::setClosable(bool closable) { m_close->setVisible(closable); }

void MessageBar::show(const Message &message)
{
    if (message == m_message)
        return;
    m_message = message;
    const ui::Role ink = look(message.severity).ink;
    setTextRole(m_text, ink);
    setTextRole(m_link, ink);
    m_text->setText(message.text);
    m_link->setText(message.link);
    m_link->setVisible(!message.link.isEmpty());
    setAccessibleName(message.text);
    setVisible(!message.text.isEmpty());
    update();
    Q_EMIT changed();
    if (isVisible()) {
        QAccessibleEvent event(this, QAccessible::Alert);
        QAccessible::updateAccessibility(&event);
        Q_EMIT announced(message.text);
    }
}

void MessageBar::paintEvent(QPaintEvent *)
{
    const Look now = look(m_message.severity);
    const ui::Scheme scheme = ui::schemeOf(palette());
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(ui::color(m_message.severity == Severity::Notice ? ui::Role::Border : now.ink, scheme));
    painter.setBrush(ui::color(now.ground, scheme));
    const QRectF lampSquare(
        contentsRect().left() + barMargin, contentsRect().center().y() + 0.5 - lampSide / 2.0, lampSide, lampSide);
    painter.drawRoundedRect(
        QRectF(contentsRect()).adjusted(0.5, 0.5, -0.5, -0.5), ui::space::radius, ui::space::radius);
    paintLamp(painter, lampSquare, now.lamp, scheme);
}

} // namespace widgets
