// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/widgets/valuelabel.h"

#include <QApplication>
#include <QPainter>
#include <QTest>

using robot::Freshness;
using widgets::Lamp;
using widgets::Shown;
using widgets::ValueLabel;

namespace {

Shown looking(Freshness freshness)
{
    robot::Reading<int> reading;
    if (freshness == Freshness::Refused)
        reading.refuse({values::ErrorKind::Refused, 0x1F, 0x2010, {}});
    if (freshness == Freshness::Live || freshness == Freshness::Stale) {
        reading.take(1, {});
        reading.clock = QDateTime(QDate(2026, 11, 10), QTime(12, 3, 4));
    }
    return widgets::shown(reading, freshness, [](int) { return widgets::Word {QStringLiteral("ON"), Lamp::Filled}; });
}

/// How many pixels have exactly this colour.
int count(const QImage &image, const QColor &color)
{
    int result = 0;
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x)
            result += image.pixelColor(x, y) == color;
    }
    return result;
}

QImage picture(ValueLabel &label, const Shown &shown)
{
    label.show(shown);
    label.resize(200, 30);
    QImage image(label.size(), QImage::Format_RGB32);
    image.fill(ui::color(ui::Role::Card, &label));
    QPainter painter(&image);
    label.render(&painter, {}, {}, QWidget::DrawChildren);
    return image;
}

} // namespace

class TestValueLabel : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void words_data();
    void words();
    void looks();
    void lampsHaveTheirOwnShapes();
    void tabularDigitsStandStill();
    void elidedTextIsInTheToolTip();
};

void TestValueLabel::words_data()
{
    QTest::addColumn<Freshness>("freshness");
    QTest::addColumn<QString>("text");
    QTest::addColumn<QString>("accessible");
    const auto row = [](const char *name, Freshness freshness, const char *text, const char *accessible) {
        QTest::newRow(name) << freshness << QString::fromUtf8(text) << QString::fromUtf8(accessible);
    };
    row("unknown", Freshness::Unknown, "—", "Servo: —. Not read yet.");
    row("live", Freshness::Live, "ON", "Servo: ON");
    row("stale", Freshness::Stale, "ON", "Servo: ON. Last seen 12:03:04");
    row("refused", Freshness::Refused, "—", "Servo: —. Refused: 0x2010");
}

void TestValueLabel::words()
{
    QFETCH(Freshness, freshness);
    QFETCH(QString, text);
    QFETCH(QString, accessible);
    ValueLabel label(ui::Type::State);
    label.setTitle(QStringLiteral("Servo"));
    label.show(looking(freshness));
    QCOMPARE(label.text(), text);
    QVERIFY2(label.accessibleName().startsWith(accessible), qPrintable(label.accessibleName()));
    QCOMPARE(label.toolTip(), looking(freshness).note);
}

/// Live is sharp; stale has a hatch and no sharp ink at all; unknown and refused have no lamp.
void TestValueLabel::looks()
{
    for (const ui::Scheme scheme : {ui::Scheme::Light, ui::Scheme::Dark}) {
        ui::apply(*qApp, scheme);
        ValueLabel label(ui::Type::State);
        const QColor fill = ui::color(ui::Role::Fill, scheme);
        const QColor hatch = ui::color(ui::Role::Border, scheme);
        const QColor text = ui::color(ui::Role::Text1, scheme);
        const QImage live = picture(label, looking(Freshness::Live));
        QVERIFY(count(live, fill) > 50);
        QVERIFY(count(live, text) > 10);
        QCOMPARE(count(live, hatch), 0);
        const QImage stale = picture(label, looking(Freshness::Stale));
        QCOMPARE(count(stale, fill), 0);
        QCOMPARE(count(stale, text), 0);
        QVERIFY(count(stale, hatch) > 200);
        for (const Freshness freshness : {Freshness::Unknown, Freshness::Refused}) {
            const QImage none = picture(label, looking(freshness));
            QCOMPARE(count(none, fill), 0);
            QCOMPARE(count(none, hatch), 0);
            QVERIFY(count(none, ui::color(ui::Role::Text3, scheme)) > 5);
        }
    }
    ui::apply(*qApp, ui::Scheme::Light);
}

/// In grey, as a person sees it who sees no colours.
void TestValueLabel::lampsHaveTheirOwnShapes()
{
    QList<QImage> shapes;
    for (const Lamp lamp : {Lamp::None, Lamp::Hollow, Lamp::Filled, Lamp::Warning, Lamp::Diamond}) {
        QImage image(12, 12, QImage::Format_Mono);
        image.fill(1);
        QPainter painter(&image);
        widgets::paintLamp(painter, QRectF(1, 1, 10, 10), lamp, ui::Scheme::Light);
        painter.end();
        QVERIFY(!shapes.contains(image));
        shapes << image;
    }
}

void TestValueLabel::tabularDigitsStandStill()
{
    ValueLabel label(ui::Type::Position);
    label.setTabular(true);
    const auto width = [&](const char *text) {
        label.show({{QString::fromLatin1(text), Lamp::None}, Freshness::Live, {}});
        return label.sizeHint().width();
    };
    QCOMPARE(width("1111.111"), width("8888.888"));
}

void TestValueLabel::elidedTextIsInTheToolTip()
{
    ValueLabel label(ui::Type::State);
    label.setElided(true);
    label.show({{QStringLiteral("A_VERY_LONG_JOB_NAME_INDEED"), Lamp::None}, Freshness::Live, {}});
    QVERIFY(label.minimumSizeHint().width() < label.sizeHint().width());
    QCOMPARE(label.toolTip(), QStringLiteral("A_VERY_LONG_JOB_NAME_INDEED"));
}

QTEST_MAIN(TestValueLabel)
#include "tst_valuelabel.moc"
