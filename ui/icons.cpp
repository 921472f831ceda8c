// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/icons.h"

#include "ui/theme.h"
#include <QFile>
#include <QGuiApplication>
#include <QIconEngine>
#include <QPainter>
#include <QPixmapCache>
#include <QSvgRenderer>

/// A static library's resources must be asked for, outside every namespace.
static void initializeResources() { Q_INIT_RESOURCE(resources); }

namespace ui {

namespace {

QByteArray drawing(const QString &name)
{
    initializeResources();
    QFile file(QStringLiteral(":/icons/%1.svg").arg(name));
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

QPixmap render(const QByteArray &svg, const QSize &size)
{
    QSvgRenderer renderer(svg);
    QPixmap pixmap(size);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    renderer.render(&painter);
    return pixmap;
}

QColor inkOf(QIcon::Mode mode, QIcon::State state)
{
    const Scheme scheme = schemeOf(QGuiApplication::palette());
    if (mode == QIcon::Disabled)
        return color(Role::Text3, scheme);
    return color(state == QIcon::On ? Role::Accent : Role::Text1, scheme);
}

/// Draws one drawing in the ink that fits the moment; each ink and size once.
class InkEngine : public QIconEngine
{
public:
    explicit InkEngine(const QString &name) : m_name {name} { }

    QPixmap pixmap(const QSize &size, QIcon::Mode mode, QIcon::State state) override
    {
        const QString ink = inkOf(mode, state).name();
        const QString key = QStringLiteral("pendesk-%1-%2-%3").arg(m_name, ink).arg(size.width());
        QPixmap result;
        if (!QPixmapCache::find(key, &result)) {
            result = render(drawing(m_name).replace("currentColor", ink.toLatin1()), size);
            QPixmapCache::insert(key, result);
        }
        return result;
    }

    void paint(QPainter *painter, const QRect &rect, QIcon::Mode mode, QIcon::State state) override
    {
        const qreal ratio = painter->device()->devicePixelRatio();
        painter->drawPixmap(rect, pixmap(rect.size() * ratio, mode, state));
    }

    [[nodiscard]] QIconEngine *clone() const override { return new InkEngine(*this); }

private:
    QString m_name;
};

} // namespace

QIcon icon(const QString &name) { return name.isEmpty() ? QIcon() : QIcon(new InkEngine(name)); }

QIcon applicationIcon()
{
    QIcon result;
    const QByteArray svg = drawing(QStringLiteral("pendesk"));
    for (const int size : {32, 64})
        result.addPixmap(render(svg, {size, size}));
    return result;
}

} // namespace ui
