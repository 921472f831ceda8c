// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/icons.h"

#include <QFile>
#include <QGuiApplication>
#include <QPainter>
#include <QPixmap>
#include <QSvgRenderer>

namespace ui {

namespace {

QByteArray drawing(const QString &name)
{
    QFile file(QStringLiteral(":/icons/%1.svg").arg(name));
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

QPixmap render(const QByteArray &svg, int size)
{
    QSvgRenderer renderer(svg);
    const qreal ratio = qGuiApp->devicePixelRatio();
    QPixmap pixmap(QSize(size, size) * ratio);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    renderer.render(&painter);
    painter.end();
    pixmap.setDevicePixelRatio(ratio);
    return pixmap;
}

QPixmap inked(QByteArray svg, const QColor &ink)
{
    return render(svg.replace("currentColor", ink.name().toLatin1()), space::icon);
}

} // namespace

QIcon icon(const QString &name, Scheme scheme)
{
    QIcon result;
    const QByteArray svg = drawing(name);
    if (svg.isEmpty())
        return result;
    result.addPixmap(inked(svg, color(Role::Text1, scheme)), QIcon::Normal, QIcon::Off);
    result.addPixmap(inked(svg, color(Role::Accent, scheme)), QIcon::Normal, QIcon::On);
    result.addPixmap(inked(svg, color(Role::Text3, scheme)), QIcon::Disabled);
    return result;
}

QIcon applicationIcon()
{
    QIcon result;
    const QByteArray svg = drawing(QStringLiteral("pendesk"));
    for (const int size : {32, 64})
        result.addPixmap(render(svg, size));
    return result;
}

} // namespace ui
