// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/pages/start/recenttile.h"

#include "ui/linkview.h"
#include <QApplication>
#include <QLocale>
#include <QPainter>
#include <QStyleOptionButton>
#include <QStylePainter>

namespace pages::start {

namespace {

constexpr int sideMargin = 14;
constexpr int verticalMargin = 7;
constexpr int between = 16;

QFont nameFont()
{
    QFont font = ui::font(ui::Type::Body);
    font.setWeight(QFont::DemiBold);
    return font;
}

QFont smallFont() { return ui::font(ui::Type::Label); }

} // namespace

QString connectedText(const QDateTime &at, const QDateTime &now)
{
    if (!at.isValid())
        return RecentTile::tr("no connection noted yet");
    const QDateTime local = at.toLocalTime();
    const QString time = QLocale().toString(local.time(), QLocale::ShortFormat);
    const qint64 days = local.date().daysTo(now.toLocalTime().date());
    if (days == 0)
        return RecentTile::tr("connected today %1", "the time").arg(time);
    if (days == 1)
        return RecentTile::tr("connected yesterday %1", "the time").arg(time);
    return RecentTile::tr("connected %1 %2", "the date, the time")
        .arg(QLocale().toString(local.date(), QLocale::ShortFormat), time);
}

RecentTile::RecentTile(const settings::RecentProfile &recent, const QDateTime &now, bool isFilled, QWidget *parent)
    : QPushButton(parent),
      m_isFilled {isFilled},
      m_name {isFilled ? tr("Connect to %1").arg(recent.profile.name) : recent.profile.name},
      m_address {ui::addressText(recent.profile)},
      m_connected {recent.profile.isSimulation ? tr("simulation") : connectedText(recent.connected, now)}
{
    setProperty("primary", isFilled);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    tellNames();
}

void RecentTile::showBackup(const widgets::Word &age)
{
    if (age == m_backup)
        return;
    m_backup = age;
    tellNames();
    update();
}

void RecentTile::tellNames()
{
    QStringList words {m_name, m_address, m_connected};
    if (!m_backup.text.isEmpty())
        words << m_backup.text;
    setAccessibleName(words.join(QStringLiteral(", ")));
    setToolTip(words.join(u'\n'));
}

QSize RecentTile::sizeHint() const
{
    const int height = QFontMetrics(nameFont()).height() + QFontMetrics(smallFont()).height();
    return {420, height + 2 * verticalMargin + 2};
}

QSize RecentTile::minimumSizeHint() const { return {240, sizeHint().height()}; }

/// On the ground of the accent colour everything has one colour.
ui::Role RecentTile::role(ui::Role usual) const
{
    const bool isDark = ui::schemeOf(QApplication::palette()) == ui::Scheme::Dark; // its own one has that ground
    return !m_isFilled ? usual : isDark ? ui::Role::Window : ui::Role::Raised;
}

void RecentTile::paintEvent(QPaintEvent *)
{
    QStylePainter painter(this);
    QStyleOptionButton option;
    initStyleOption(&option);
    option.text.clear();
    painter.drawControl(QStyle::CE_PushButtonBevel, option);
    const QRect inner = rect().adjusted(sideMargin, verticalMargin, -sideMargin, -verticalMargin);
    const int upperHeight = QFontMetrics(nameFont()).height();
    const auto write = [&](QRect room, bool isUpper, Qt::Alignment side, const QFont &font, ui::Role ink,
                           const QString &words) {
        room.setTop(isUpper ? inner.top() : inner.top() + upperHeight + 2);
        room.setHeight(isUpper ? upperHeight : QFontMetrics(font).height());
        painter.setFont(font);
        painter.setPen(ui::color(role(ink), ui::schemeOf(QApplication::palette())));
        painter.drawText(
            room, side | Qt::AlignVCenter, QFontMetrics(font).elidedText(words, Qt::ElideRight, room.width()));
    };
    const int rightWidth = std::min(inner.width() / 2,
        std::max(QFontMetrics(smallFont()).horizontalAdvance(m_connected),
            QFontMetrics(smallFont()).horizontalAdvance(m_backup.text) + upperHeight));
    QRect left = inner;
    left.setRight(inner.right() - rightWidth - between);
    QRect right = inner;
    right.setLeft(inner.right() - rightWidth);
    write(left, true, Qt::AlignLeft, nameFont(), ui::Role::Text1, m_name);
    write(left, false, Qt::AlignLeft, smallFont(), ui::Role::Text2, m_address);
    write(right, true, Qt::AlignRight, smallFont(), ui::Role::Text2, m_connected);
    write(right, false, Qt::AlignRight, smallFont(),
        m_backup.lamp == widgets::Lamp::None ? ui::Role::Text2 : widgets::roleOf(m_backup.lamp), m_backup.text);
    if (m_backup.lamp == widgets::Lamp::None || m_isFilled) // the word says it; amber on the accent would not be seen
        return;
    const int side = QFontMetrics(smallFont()).capHeight();
    const int x = inner.right() - QFontMetrics(smallFont()).horizontalAdvance(m_backup.text) - side - 6;
    const int middle = inner.top() + upperHeight + 2 + QFontMetrics(smallFont()).height() / 2;
    widgets::paintLamp(
        painter, QRectF(x, middle - side / 2.0, side, side), m_backup.lamp, ui::schemeOf(QApplication::palette()));
}

} // namespace pages::start
