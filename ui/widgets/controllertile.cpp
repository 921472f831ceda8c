// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/widgets/controllertile.h"

#include <QFontMetrics>
#include <QPainter>

namespace widgets {

namespace {

constexpr int tileMargin = 10;

QFont nameFont()
{
    QFont font = ui::font(ui::Type::Body);
    font.setWeight(QFont::DemiBold);
    return font;
}

} // namespace

ControllerTile::ControllerTile(QWidget *parent) : QAbstractButton(parent)
{
    setCheckable(true);
    setAutoExclusive(false);
    setFocusPolicy(Qt::TabFocus);
    const int line = QFontMetrics(ui::font(ui::Type::Label)).height();
    setFixedHeight(QFontMetrics(nameFont()).height() + 2 * line + 3 * tileMargin / 2 + 4);
}

void ControllerTile::showStation(const QUuid &id, const QString &name, int tag)
{
    m_id = id;
    if (name == m_name && tag == m_tag)
        return;
    m_name = name;
    m_tag = tag;
    tellNames();
    update();
}

void ControllerTile::showAlarms(int count)
{
    if (std::exchange(m_alarms, count) != count)
        update();
}

void ControllerTile::show(const Word &state)
{
    if (state == m_state)
        return;
    m_state = state;
    tellNames();
    update();
}

void ControllerTile::showBackup(const Word &age)
{
    if (age == m_backup)
        return;
    m_backup = age;
    tellNames();
    update();
}

void ControllerTile::tellNames()
{
    setAccessibleName(m_backup.text.isEmpty() ? tr("%1: %2").arg(m_name, m_state.text)
                                              : tr("%1: %2. %3").arg(m_name, m_state.text, m_backup.text));
    setToolTip(accessibleName());
}

void ControllerTile::paintEvent(QPaintEvent *)
{
    const ui::Scheme scheme = ui::schemeOf(palette());
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    if (isChecked() || hasFocus()) {
        painter.setPen(ui::color(hasFocus() ? ui::Role::Accent : ui::Role::Border, scheme));
        painter.setBrush(ui::color(isChecked() ? ui::Role::Raised : ui::Role::Window, scheme));
        painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), ui::space::radius, ui::space::radius);
    }
    if (m_tag > 0)
        painter.fillRect(QRect(2, tileMargin, 4, height() - 2 * tileMargin), ui::tagColor(m_tag, scheme));

    const QRect inner = rect().adjusted(tileMargin, tileMargin - 3, -tileMargin, -tileMargin + 3);
    const int side = QFontMetrics(nameFont()).capHeight();
    const QRect upper(inner.left(), inner.top(), inner.width() - side - 12, QFontMetrics(nameFont()).height());
    const int labelHeight = QFontMetrics(ui::font(ui::Type::Label)).height();
    const QRect lower(inner.left(), upper.bottom() + 3, inner.width(), labelHeight);
    QRect lowest = lower.translated(0, labelHeight);
    const auto write = [&](const QRect &line, const QFont &font, ui::Role role, const QString &words) {
        painter.setFont(font);
        painter.setPen(ui::color(role, scheme));
        painter.drawText(
            line, Qt::AlignLeft | Qt::AlignVCenter, QFontMetrics(font).elidedText(words, Qt::ElideRight, line.width()));
    };
    write(upper, nameFont(), ui::Role::Text1, m_name);
    if (m_alarms > 0) {
        const QRect count = upper.adjusted(0, 0, 4, 0);
        painter.setFont(ui::font(ui::Type::Label));
        painter.setPen(ui::color(ui::Role::Alarm, scheme));
        painter.drawText(count, Qt::AlignRight | Qt::AlignVCenter, QString::number(m_alarms));
    }
    write(lower, ui::font(ui::Type::Label), ui::Role::Text2, m_state.text);
    if (m_backup.lamp != Lamp::None) {
        paintLamp(painter, QRect(lowest.left(), lowest.center().y() - side / 2, side, side), m_backup.lamp, scheme);
        lowest.setLeft(lowest.left() + side + 5);
    }
    write(lowest, ui::font(ui::Type::Label), m_backup.lamp == Lamp::None ? ui::Role::Text2 : roleOf(m_backup.lamp),
        m_backup.text);
    paintLamp(painter, QRect(inner.right() - side, upper.center().y() - side / 2, side, side), m_state.lamp, scheme);
}

} // namespace widgets
