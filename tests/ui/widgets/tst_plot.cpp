// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/widgets/plot.h"

#include "trend/moment.h"
#include "ui/theme.h"
#include "ui/widgets/toolpathview.h"
#include <QApplication>
#include <QDir>
#include <QSignalSpy>
#include <QTest>
#include <QtCharts/QChart>
#include <QtCharts/QValueAxis>
#include <set>

using namespace std::chrono_literals;
using trend::Track;
using trend::Unit;
using widgets::Plot;
using widgets::ToolPathView;

namespace {

constexpr trend::Moment zero {1'800'000'000'000ms};
constexpr trend::Range minute {zero, zero + 60s};

Track track(const char *label, Unit unit, double (*value)(int), int gapFrom = -1, int gapTo = -1)
{
    Track result {{}, QLatin1String(label), unit, trend::Series {4000}};
    for (int i = 0; i <= 600; ++i) {
        if (i == gapFrom)
            result.series.breakOff(zero + i * 100ms);
        else if (i < gapFrom || i > gapTo)
            result.series.append(zero + i * 100ms, value(i));
    }
    return result;
}

double wave(int i) { return 500 * std::sin(i / 40.0) + 600; }
double ramp(int i) { return i / 3.0; }
double blink(int i) { return i / 75 % 2; }
double flat(int) { return 42; }

/// How many pixels of a column have this colour.
int inColumn(const QImage &image, int x, const QColor &color)
{
    int count = 0;
    for (int y = 0; y < image.height(); ++y)
        count += image.pixelColor(x, y) == color;
    return count;
}

void save(QWidget &widget, const QString &name)
{
    QVERIFY(QDir().mkpath(QStringLiteral(PENDESK_PICTURES)));
    for (const ui::Scheme scheme : {ui::Scheme::Light, ui::Scheme::Dark}) {
        ui::apply(*qApp, scheme);
        QCoreApplication::sendPostedEvents();
        QVERIFY(widget.grab().save(
            QStringLiteral("%1/%2-%3.png")
                .arg(QStringLiteral(PENDESK_PICTURES), name,
                    scheme == ui::Scheme::Light ? QStringLiteral("light") : QStringLiteral("dark"))));
    }
    ui::apply(*qApp, ui::Scheme::Light);
}

values::Position place(int x, int y, int z) { return {values::PositionType::Base, 0, 0, 0, 0, {x, y, z, 0, 0, 0}}; }

} // namespace

/// The plot, and the tool path.
class PlotTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void axesByUnit();
    void gapsStayGaps();
    void linesDiffer();
    void cursorByMouse();
    void cursorByKeyboard();
    void cursorFollowsTheStream();
    void tooManyTracks();
    void nothingToPlot();
    void pictures();
    void pathHasEqualAspect_data();
    void pathHasEqualAspect();
    void pathLooksStale();
    void pathPictures();
};

void PlotTest::axesByUnit()
{
    const Track x = track("R1 X", Unit::Millimetre, wave);
    const Track y = track("R1 Y", Unit::Millimetre, ramp);
    const Track servo = track("Servo on", Unit::Bit, blink);
    Plot plot;
    plot.resize(800, 400);
    plot.show();
    plot.show({&x, &y, &servo}, minute, zero + 60s);
    const auto vertical = plot.chart()->axes(Qt::Vertical);
    QCOMPARE(vertical.size(), 2);
    QCOMPARE(vertical[0]->titleText(), QStringLiteral("AB: mm"));
    QCOMPARE(vertical[1]->titleText(), QStringLiteral("C"));
    auto *millimetres = qobject_cast<QValueAxis *>(vertical[0]);
    QVERIFY(millimetres->min() <= 0 && millimetres->max() >= 1100);
    const auto *time = qobject_cast<QValueAxis *>(plot.chart()->axes(Qt::Horizontal).front());
    QCOMPARE(time->min(), -60.0);
    QCOMPARE(time->max(), 0.0);
    plot.show({&servo}, minute, zero + 60s);
    QCOMPARE(plot.chart()->axes(Qt::Vertical).size(), 1);
}

void PlotTest::gapsStayGaps()
{
    const Track given = track("R1 X", Unit::Millimetre, flat, 200, 400);
    Plot plot;
    plot.resize(800, 400);
    plot.show();
    plot.show({&given}, minute, zero);
    const QImage image = plot.grab().toImage();
    const auto xOf = [&](int i) { return int(plot.placeOf(given, {zero + i * 100ms, 42}).x()); };
    const QColor ink = Plot::pen(0, &plot).color();
    QVERIFY(inColumn(image, xOf(195), ink) > 0);
    for (int i = 202; i < 399; ++i)
        QCOMPARE(inColumn(image, xOf(i), ink), 0);
    QVERIFY(inColumn(image, xOf(405), ink) > 0);
}

void PlotTest::linesDiffer()
{
    Plot plot;
    std::set<std::pair<QRgb, int>> seen;
    for (int i = 0; i < Plot::mostTracks; ++i)
        seen.insert({Plot::pen(i, &plot).color().rgb(), int(Plot::pen(i, &plot).style())});
    QCOMPARE(int(seen.size()), Plot::mostTracks);
    QCOMPARE(Plot::letter(7), QChar(u'H'));
}

void PlotTest::cursorByMouse()
{
    const Track given = track("R1 X", Unit::Millimetre, wave);
    Plot plot;
    plot.resize(800, 400);
    plot.show();
    plot.show({&given}, minute, zero);
    QCoreApplication::processEvents(); // the axes find their places
    QSignalSpy moved(&plot, &Plot::cursorChanged);
    QVERIFY(!plot.cursor());
    const QPoint at = plot.placeOf(given, {zero + 30s, 600}).toPoint();
    QTest::mouseMove(plot.viewport(), at);
    QTRY_VERIFY(plot.cursor());
    QTRY_VERIFY(std::chrono::abs(*plot.cursor() - (zero + 30s)) < 200ms);
    QVERIFY(!moved.isEmpty());
    QEvent leave(QEvent::Leave);
    QCoreApplication::sendEvent(&plot, &leave);
    QVERIFY(!plot.cursor());
}

void PlotTest::cursorByKeyboard()
{
    const Track given = track("R1 X", Unit::Millimetre, wave);
    Plot plot;
    plot.show();
    plot.show({&given}, minute, zero);
    QTest::keyClick(&plot, Qt::Key_Home);
    QVERIFY(plot.cursor() == zero);
    QTest::keyClick(&plot, Qt::Key_Left);
    QVERIFY(plot.cursor() == zero);
    QTest::keyClick(&plot, Qt::Key_Right);
    QVERIFY(plot.cursor() == zero + 600ms);
    QTest::keyClick(&plot, Qt::Key_End);
    QVERIFY(plot.cursor() == zero + 60s);
    QTest::keyClick(&plot, Qt::Key_Escape);
    QVERIFY(!plot.cursor());
}

void PlotTest::cursorFollowsTheStream()
{
    const Track given = track("R1 X", Unit::Millimetre, wave);
    Plot plot;
    plot.show({&given}, minute, zero);
    plot.setCursor(widgets::PlotCursor {0.5});
    QVERIFY(plot.cursor() == zero + 30s);
    QSignalSpy moved(&plot, &Plot::cursorChanged);
    plot.show({&given}, {zero + 10s, zero + 70s}, zero);
    QVERIFY(plot.cursor() == zero + 40s);
    QCOMPARE(moved.size(), 1);
}

void PlotTest::tooManyTracks()
{
    const Track given = track("R1 X", Unit::Millimetre, wave);
    Plot plot;
    plot.show(std::vector<const Track *>(20, &given), minute, zero);
    QCOMPARE(plot.accessibleDescription().count(u'\n') + 1, Plot::mostTracks);
}

void PlotTest::nothingToPlot()
{
    Plot plot;
    plot.show();
    plot.show({}, minute, zero);
    QVERIFY(!plot.grab().isNull());
    QCOMPARE(plot.accessibleDescription(), QStringLiteral("Nothing is plotted."));
    const Track empty {{}, QStringLiteral("B005"), Unit::Plain, trend::Series {2}};
    plot.show({&empty}, {zero, zero}, zero);
    QVERIFY(!plot.grab().isNull());
}

void PlotTest::pictures()
{
    const Track tracks[] {track("R1 X", Unit::Millimetre, wave, 200, 260), track("R1 Y", Unit::Millimetre, ramp),
        track("Servo on", Unit::Bit, blink), track("R1 S torque", Unit::Plain, flat, 500, 900)};
    Plot plot;
    plot.resize(1000, 420);
    plot.show();
    plot.show({&tracks[0], &tracks[1], &tracks[2], &tracks[3]}, minute, zero + 60s);
    plot.setCursor(widgets::PlotCursor {0.6});
    save(plot, QStringLiteral("widget-plot"));
}

void PlotTest::pathHasEqualAspect_data()
{
    QTest::addColumn<int>("side");
    QTest::addColumn<int>("right"); // Axis
    QTest::addColumn<int>("up");
    QTest::newRow("top") << int(ToolPathView::Side::Top) << 0 << 1;
    QTest::newRow("front") << int(ToolPathView::Side::Front) << 1 << 2;
    QTest::newRow("side") << int(ToolPathView::Side::Side) << 0 << 2;
}

void PlotTest::pathHasEqualAspect()
{
    QFETCH(int, side);
    QFETCH(int, right);
    QFETCH(int, up);
    trend::ToolPath path;
    path.append(place(0, 0, 0));
    path.append(place(800000, 300000, -200000));
    ToolPathView view {ToolPathView::Side(side)};
    view.resize(400, 200);
    view.show();
    view.show(path);
    trend::PathPoint from;
    trend::PathPoint along;
    trend::PathPoint upwards;
    along.mm[std::size_t(right)] = 100;
    upwards.mm[std::size_t(up)] = 100;
    const QPointF origin = view.placeOf(from);
    const QPointF x = view.placeOf(along) - origin;
    const QPointF y = view.placeOf(upwards) - origin;
    QCOMPARE(x.x(), 100 * view.pixelsPerMillimetre());
    QCOMPARE(x.y(), 0.0);
    QCOMPARE(y.y(), -x.x());
    QCOMPARE(y.x(), 0.0);
    for (const trend::PathPoint &point : path.points())
        QVERIFY(QRectF(view.rect()).contains(view.placeOf(point)));
}

void PlotTest::pathLooksStale()
{
    trend::ToolPath path;
    ToolPathView view {ToolPathView::Side::Top};
    view.show(path);
    QCOMPARE(view.accessibleDescription(), QStringLiteral("No position in the base frame was read yet."));
    path.append(place(1024318, -311902, 0));
    view.show(path);
    QCOMPARE(view.accessibleDescription(), QStringLiteral("X 1,024.3 mm, Y -311.9 mm."));
    view.setStale(QStringLiteral("Last seen 12:03:04"));
    QCOMPARE(view.accessibleDescription(), QStringLiteral("X 1,024.3 mm, Y -311.9 mm. Last seen 12:03:04"));
}

void PlotTest::pathPictures()
{
    trend::ToolPath path;
    for (int i = 0; i < 700; ++i) {
        if (i == 400)
            path.breakOff();
        if (i < 400 || i > 430)
            path.append(
                place(900000 + int(200000 * std::cos(i / 50.0)), int(300000 * std::sin(i / 50.0)), 500000 + i * 300));
    }
    ToolPathView view {ToolPathView::Side::Top};
    view.resize(360, 300);
    view.show();
    view.show(path);
    save(view, QStringLiteral("widget-path"));
    view.setStale(QStringLiteral("Last seen 12:03:04"));
    save(view, QStringLiteral("widget-path-stale"));
}

int main(int argc, char *argv[])
{
    QApplication application {argc, argv};
    ui::apply(application, ui::Scheme::Light);
    PlotTest test;
    return QTest::qExec(&test, argc, argv);
}

#include "tst_plot.moc"
