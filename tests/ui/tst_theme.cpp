// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/icons.h"
#include "ui/theme.h"
#include <QPushButton>
#include <QTest>
#include <cmath>

using ui::Role;
using ui::Scheme;

namespace {

/// WCAG 2.1, relative luminance.
double luminance(const QColor &color)
{
    const auto linear = [](double c) { return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4); };
    return 0.2126 * linear(color.redF()) + 0.7152 * linear(color.greenF()) + 0.0722 * linear(color.blueF());
}

double contrast(const QColor &a, const QColor &b)
{
    const double la = luminance(a);
    const double lb = luminance(b);
    return (std::max(la, lb) + 0.05) / (std::min(la, lb) + 0.05);
}

} // namespace

class TestTheme : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void contrast_data();
    void contrast();
    void contrastOfAccentButtons();
    void schemes_data();
    void schemes();
    void schemeOfADesktop();
    void paletteKeepsItsScheme();
    void icons_data();
    void icons();
};

void TestTheme::contrast_data()
{
    QTest::addColumn<Role>("text");
    QTest::addColumn<Role>("ground");
    const auto add = [](const char *name, Role text, std::initializer_list<Role> grounds) {
        for (const Role ground : grounds)
            QTest::addRow("%s on %d", name, int(ground)) << text << ground;
    };
    const std::initializer_list<Role> all {Role::Window, Role::Strip, Role::Card, Role::Raised};
    add("text 1", Role::Text1, all);
    add("text 2", Role::Text2, all);
    add("accent", Role::Accent, all);
    add("alarm", Role::Alarm, all);
    add("amber", Role::Amber, all);
    add("magenta", Role::Magenta, all);
    add("accent", Role::Accent, {Role::AccentGround});
    add("alarm", Role::Alarm, {Role::AlarmGround});
    add("amber", Role::Amber, {Role::AmberGround});
    add("magenta", Role::Magenta, {Role::MagentaGround});
    add("fill", Role::Fill, all);
}

void TestTheme::contrast()
{
    QFETCH(Role, text);
    QFETCH(Role, ground);
    for (const Scheme scheme : {Scheme::Light, Scheme::Dark})
        QVERIFY(::contrast(ui::color(text, scheme), ui::color(ground, scheme)) >= 4.5);
}

void TestTheme::contrastOfAccentButtons()
{
    for (const Scheme scheme : {Scheme::Light, Scheme::Dark}) {
        const QPalette palette = ui::palette(scheme);
        QVERIFY(::contrast(palette.color(QPalette::HighlightedText), palette.color(QPalette::Highlight)) >= 4.5);
    }
}

void TestTheme::schemes_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<std::optional<Scheme>>("scheme");
    QTest::newRow("light") << QStringLiteral("light") << std::optional {Scheme::Light};
    QTest::newRow("dark") << QStringLiteral("dark") << std::optional {Scheme::Dark};
    QTest::newRow("empty") << QString {} << std::optional<Scheme> {};
    QTest::newRow("capital") << QStringLiteral("Light") << std::optional<Scheme> {};
    QTest::newRow("auto") << QStringLiteral("auto") << std::optional<Scheme> {};
}

void TestTheme::schemes()
{
    QFETCH(QString, name);
    QFETCH(std::optional<Scheme>, scheme);
    QVERIFY(ui::schemeFromName(name) == scheme);
}

void TestTheme::schemeOfADesktop()
{
    QPalette desktop;
    desktop.setColor(QPalette::Window, Qt::black);
    QVERIFY(ui::schemeOf(desktop) == Scheme::Dark);
    desktop.setColor(QPalette::Window, Qt::white);
    QVERIFY(ui::schemeOf(desktop) == Scheme::Light);
}

void TestTheme::paletteKeepsItsScheme()
{
    for (const Scheme scheme : {Scheme::Light, Scheme::Dark})
        QVERIFY(ui::schemeOf(ui::palette(scheme)) == scheme);
}

void TestTheme::icons_data()
{
    QTest::addColumn<QString>("name");
    for (const char *name :
        {"overview", "hold", "connect", "disconnect", "diagnose", "copy", "settings", "menu", "demo"})
        QTest::newRow(name) << QString::fromLatin1(name);
}

void TestTheme::icons()
{
    QFETCH(QString, name);
    const QImage image = ui::icon(name).pixmap(24, 24).toImage();
    int inked = 0;
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x)
            inked += qAlpha(image.pixel(x, y)) > 128;
    }
    QVERIFY(inked > 20);
}

QTEST_MAIN(TestTheme)
#include "tst_theme.moc"
