// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/pages/trendpage.h"

#include "trend/catalogue.h"
#include "trend/moment.h"
#include "ui/harness.h"
#include "ui/models/incidentmodel.h"
#include "ui/models/signallistmodel.h"
#include "ui/models/trackmodel.h"
#include "ui/pagecatalog.h"
#include "ui/widgets/plot.h"
#include "virtualcontroller/alarms.h"
#include <QAbstractItemModelTester>
#include <QComboBox>
#include <QDir>
#include <QDropEvent>
#include <QLineEdit>
#include <QListView>
#include <QMimeData>
#include <QPushButton>
#include <QTableView>

using namespace std::chrono_literals;
using models::TrackModel;
using pages::TrendPage;
using robot::Kind;

namespace {

constexpr trend::Signal torque {{Kind::Torque, 1}, 0};
constexpr trend::Signal servo {{Kind::Status, 1}, 14};

int rowOf(const char *id)
{
    for (int row = 0; row < int(ui::pageCatalog().size()); ++row) {
        if (QLatin1String(ui::pageCatalog()[row].id) == QLatin1String(id))
            return row;
    }
    return -1;
}

/// The trend page in view, connected to the demo controller.
struct Desk : Harness {
    bool open()
    {
        if (!connectLive())
            return false;
        window.view().openPage(rowOf("trend"));
        return true;
    }
    template <typename Widget> [[nodiscard]] Widget *find(const char *name) const
    {
        return window.findChild<Widget *>(QLatin1String(name));
    }
    [[nodiscard]] TrendPage *page() const { return find<TrendPage>("trendPage"); }
    [[nodiscard]] trend::Recorder &recorder() const { return window.view().recorder(); }
    [[nodiscard]] QAbstractItemModel *tracks() const { return find<QTableView>("trackTable")->model(); }
    [[nodiscard]] QString cell(int row, int column) const { return tracks()->index(row, column).data().toString(); }
    void click(const char *name) const { QTest::mouseClick(find<QPushButton>(name), Qt::LeftButton); }
    void drop(const QList<trend::Signal> &list) const
    {
        QMimeData mime;
        mime.setData(QLatin1String(trend::mimeType), trend::toMime(list));
        QDragEnterEvent enter(QPoint(9, 9), Qt::CopyAction, &mime, Qt::LeftButton, Qt::NoModifier);
        QCoreApplication::sendEvent(page(), &enter);
        QVERIFY(enter.isAccepted());
        QDropEvent event(QPointF(9, 9), Qt::CopyAction, &mime, Qt::LeftButton, Qt::NoModifier);
        QCoreApplication::sendEvent(page(), &event);
    }
    /// Raises an alarm and lets the recorder believe that twenty seconds have passed.
    bool keepIncident()
    {
        virtualcontroller::raiseAlarm(server->memory(), 4315, "COLLISION DETECTED");
        const bool isSeen = QTest::qWaitFor([&] {
            const auto &alarm = state().reading<Kind::Alarm>(1).value;
            return state().status().value->hasAlarm() && alarm && alarm->alarm.code == 4315;
        });
        recorder().tick(trend::now() + 20s);
        return isSeen && QTest::qWaitFor([&] { return !recorder().archive().incidents().isEmpty(); });
    }
};

} // namespace

/// The trend page over real sockets, and its models.
class TrendPageTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void beginsWithAHint();
    void plotsWhatIsDropped();
    void refusesOtherDrops();
    void picksBySearch();
    void removes();
    void choosesWhatIsShown();
    void pauseFreezesTheView();
    void gapsStayGaps();
    void saysWhatIsRefused();
    void exports();
    void remembersSignals();
    void keepsIncidentsWhileHidden();
    void opensIncidents();
    void saysWhichIncidentIsDamaged();
    void hiddenReadsNothing();
    void signalsOfADialect();
    void modelsBehave();
    void pictures_data();
    void pictures();
};

void TrendPageTest::beginsWithAHint()
{
    Desk desk;
    QVERIFY(desk.open());
    QVERIFY(desk.find<QLabel>("trendHint")->isVisible());
    QVERIFY(desk.find<QLabel>("noIncidents")->isVisible());
    desk.drop({servo});
    QVERIFY(!desk.find<QLabel>("trendHint")->isVisible());
}

void TrendPageTest::plotsWhatIsDropped()
{
    Desk desk;
    QVERIFY(desk.open());
    desk.drop({torque, servo});
    QCOMPARE(desk.tracks()->rowCount(), 2);
    QTRY_COMPARE(desk.cell(0, TrackModel::Label), QStringLiteral("R1 S torque"));
    QCOMPARE(desk.cell(0, TrackModel::Letter), QStringLiteral("A"));
    QCOMPARE(desk.cell(1, TrackModel::Label), QStringLiteral("Servo on"));
    QTRY_COMPARE(desk.cell(1, TrackModel::Value), QStringLiteral("1"));
    QTRY_VERIFY(desk.recorder().tracks()[0]->series.count() > 5);
    QTRY_VERIFY(desk.cell(0, TrackModel::Value) != widgets::dash());
    desk.drop({torque}); // again
    QCOMPARE(desk.tracks()->rowCount(), 2);
}

void TrendPageTest::refusesOtherDrops()
{
    Desk desk;
    QVERIFY(desk.open());
    QMimeData mime;
    mime.setText(QStringLiteral("torque.1.0"));
    QDragEnterEvent enter(QPoint(9, 9), Qt::CopyAction, &mime, Qt::LeftButton, Qt::NoModifier);
    enter.ignore();
    QCoreApplication::sendEvent(desk.page(), &enter);
    QVERIFY(!enter.isAccepted());
    desk.drop({});
    QCOMPARE(desk.tracks()->rowCount(), 0);
}

void TrendPageTest::picksBySearch()
{
    Desk desk;
    QVERIFY(desk.open());
    desk.click("addSignal");
    auto *search = desk.find<QLineEdit>("signalSearch");
    QVERIFY(search);
    QTest::keyClicks(search, QStringLiteral("torque r1 s"));
    const auto *list = desk.find<QListView>("signalList");
    QCOMPARE(list->model()->rowCount(), 1);
    QTest::keyClick(search, Qt::Key_Return);
    QCOMPARE(desk.tracks()->rowCount(), 1);
    search->clear();
    QTest::keyClicks(search, QStringLiteral("B005"));
    QTest::keyClick(search, Qt::Key_Return);
    QTRY_COMPARE(desk.tracks()->rowCount(), 2);
    search->clear();
    QTest::keyClicks(search, QStringLiteral("no such thing"));
    QTest::keyClick(search, Qt::Key_Return);
    QCOMPARE(desk.tracks()->rowCount(), 2);
}

void TrendPageTest::removes()
{
    Desk desk;
    QVERIFY(desk.open());
    desk.drop({torque, servo});
    auto *table = desk.find<QTableView>("trackTable");
    desk.window.activateWindow();
    QTRY_VERIFY(desk.window.isActiveWindow()); // else the key is nobody's shortcut
    table->setFocus();
    table->selectRow(0);
    QTest::keyClick(table, Qt::Key_Delete);
    QTRY_COMPARE(desk.tracks()->rowCount(), 1);
    QCOMPARE(desk.cell(0, TrackModel::Label), QStringLiteral("Servo on"));
    table->selectRow(0);
    desk.click("removeSignal");
    QCOMPARE(desk.tracks()->rowCount(), 0);
}

void TrendPageTest::choosesWhatIsShown()
{
    Desk desk;
    QVERIFY(desk.open());
    QList<trend::Signal> list;
    for (quint16 register_ = 0; register_ < 10; ++register_)
        list << trend::Signal {{Kind::Register, register_}, 0};
    desk.drop(list);
    const auto checked = [&](int row) {
        return desk.tracks()->index(row, TrackModel::Letter).data(Qt::CheckStateRole);
    };
    QCOMPARE(checked(7), QVariant(Qt::Checked));
    QCOMPARE(checked(8), QVariant(Qt::Unchecked));
    QVERIFY(!desk.tracks()->setData(desk.tracks()->index(8, 0), Qt::Checked, Qt::CheckStateRole));
    QVERIFY(desk.tracks()->setData(desk.tracks()->index(0, 0), Qt::Unchecked, Qt::CheckStateRole));
    QVERIFY(desk.tracks()->setData(desk.tracks()->index(8, 0), Qt::Checked, Qt::CheckStateRole));
    QCOMPARE(desk.cell(0, TrackModel::Letter), QString());
    QCOMPARE(desk.cell(1, TrackModel::Letter), QStringLiteral("A"));
    QCOMPARE(desk.cell(8, TrackModel::Letter), QStringLiteral("H"));
    QVERIFY(desk.find<widgets::Plot>("trendPlot")->accessibleDescription().endsWith(QStringLiteral("H: M008")));
}

void TrendPageTest::pauseFreezesTheView()
{
    Desk desk;
    QVERIFY(desk.open());
    desk.drop({servo});
    desk.click("pauseTrend");
    const auto *plot = desk.find<widgets::Plot>("trendPlot");
    const auto frozen = plot->range();
    const auto count = desk.recorder().tracks()[0]->series.count();
    QTRY_VERIFY(desk.recorder().tracks()[0]->series.count() > count + 5);
    QVERIFY(plot->range() == frozen);
    desk.click("pauseTrend");
    QVERIFY(plot->range().to > frozen.to);
    desk.find<QComboBox>("trendSpan")->setCurrentIndex(2);
    QVERIFY(plot->range().to - plot->range().from == 5min);
}

void TrendPageTest::gapsStayGaps()
{
    Desk desk;
    QVERIFY(desk.open());
    desk.drop({torque});
    QTRY_VERIFY(desk.recorder().tracks()[0]->series.count() > 3);
    desk.stopController();
    QTRY_VERIFY(desk.recorder().tracks()[0]->series.back().isGap());
    QTRY_COMPARE(desk.cell(0, TrackModel::Value), widgets::dash());
    QVERIFY(desk.startController());
    QTRY_VERIFY(!desk.recorder().tracks()[0]->series.back().isGap());
    QCOMPARE(std::ranges::count_if(desk.recorder().tracks()[0]->series.samples(), &trend::Sample::isGap), 1);
}

void TrendPageTest::saysWhatIsRefused()
{
    Desk desk;
    QVERIFY(desk.open());
    desk.drop({{{Kind::Torque, 2}, 0}}); // there is no R2
    QTRY_VERIFY(desk.state().freshness({Kind::Torque, 2}) == robot::Freshness::Refused);
    QTRY_COMPARE(desk.cell(0, TrackModel::Value), widgets::dash());
}

void TrendPageTest::exports()
{
    Desk desk;
    QVERIFY(desk.open());
    desk.drop({torque, servo});
    QTRY_VERIFY(desk.recorder().tracks()[0]->series.count() > 5);
    desk.click("pauseTrend");
    const QString path = desk.folder.filePath(QStringLiteral("trend.csv"));
    QVERIFY(desk.page()->exportTo(path));
    QFile file {path};
    QVERIFY(file.open(QIODevice::ReadOnly));
    const auto lines = file.readAll().split('\n');
    QCOMPARE(lines[0].trimmed(), QByteArray("time_utc,R1 S torque,Servo on"));
    QVERIFY(lines.size() > 5);
    QVERIFY(lines[1].startsWith("20") && lines[1].contains("Z,"));
    const auto refused = desk.page()->exportTo(desk.folder.filePath(QStringLiteral("no/such/folder.csv")));
    QVERIFY(!refused && refused.error().kind == values::ErrorKind::LocalFile);
}

void TrendPageTest::remembersSignals()
{
    Desk desk;
    QVERIFY(desk.open());
    desk.drop({torque, servo});
    auto other = desk.profile();
    other.name = QStringLiteral("PAINT 1");
    desk.window.connectTo(other);
    QVERIFY(desk.recorder().signalSet().isEmpty());
    desk.connectAnew();
    const QList<trend::Signal> expected {torque, servo};
    QVERIFY(desk.recorder().signalSet() == expected);
}

void TrendPageTest::keepsIncidentsWhileHidden()
{
    Desk desk;
    QVERIFY(desk.connectLive());
    QVERIFY(!desk.page()); // a page is made when it is first opened
    QVERIFY(desk.keepIncident());
    const auto entry = desk.recorder().archive().incidents().front();
    QVERIFY2(entry.title.contains(QStringLiteral("4315")), qPrintable(entry.title));
    const auto incident = desk.recorder().archive().load(entry);
    QVERIFY(incident);
    QCOMPARE(incident->controller, QStringLiteral("CELL 4 · Weld"));
    const auto has = [&](const trend::Signal &signal) {
        return std::ranges::find(incident->tracks, signal, &trend::Track::signal) != incident->tracks.end();
    };
    QVERIFY(has({{Kind::Status, 1}, 12}) && has({{Kind::Position, 101}, 0}) && has({{Kind::Job, 0}, 0}));
}

void TrendPageTest::opensIncidents()
{
    Desk desk;
    QVERIFY(desk.open());
    desk.drop({servo});
    QVERIFY(desk.keepIncident());
    auto *list = desk.find<QListView>("incidentList");
    QTRY_COMPARE(list->model()->rowCount(), 1);
    list->setCurrentIndex(list->model()->index(0, 0));
    desk.click("openIncident");
    QTRY_VERIFY(desk.tracks()->rowCount() > 8);
    const auto *plot = desk.find<widgets::Plot>("trendPlot");
    QVERIFY(plot->range().to - plot->range().from == 80s);
    QVERIFY(desk.page()->exportTo(desk.folder.filePath(QStringLiteral("incident.csv"))));
    QVERIFY(desk.find<QPushButton>("backToLive")->isVisible());
    desk.click("backToLive");
    QCOMPARE(desk.tracks()->rowCount(), 1);
    QVERIFY(!desk.find<QPushButton>("backToLive")->isVisible());
}

void TrendPageTest::saysWhichIncidentIsDamaged()
{
    Desk desk;
    QVERIFY(desk.open());
    QVERIFY(desk.keepIncident());
    QFile file {desk.recorder().archive().incidents().front().file};
    QVERIFY(file.open(QIODevice::WriteOnly | QIODevice::Truncate));
    file.write("{\"version\":1");
    file.close();
    desk.page()->openIncident(desk.recorder().archive().incidents().front());
    const auto labels = desk.find<QWidget>("trendCard")->findChildren<QLabel *>();
    QTRY_VERIFY(std::ranges::any_of(
        labels, [](const QLabel *label) { return label->text().contains(QStringLiteral("cannot be read")); }));
    QVERIFY(!desk.find<QPushButton>("backToLive")->isVisible());
}

void TrendPageTest::hiddenReadsNothing()
{
    Desk desk;
    QVERIFY(desk.open());
    desk.window.view().openPage(rowOf("overview"));
    auto &poller = desk.window.controller().poller();
    const int without = poller.planSize();
    desk.recorder().add({{Kind::Register, 7}, 0});
    QCOMPARE(poller.planSize(), without);
    desk.window.view().openPage(rowOf("trend"));
    QTRY_VERIFY(desk.recorder().tracks()[0]->series.count() > 0);
}

void TrendPageTest::signalsOfADialect()
{
    const robot::RobotState state;
    const auto list = trend::allSignals(protocol::dialect(protocol::Model::FS100), state);
    QVERIFY(list.size() > 1000);
    QVERIFY(list.contains(servo) && list.contains(torque));
    QVERIFY(list.contains(trend::Signal {{Kind::ByteVariable, 99}, 0}));
    QVERIFY(!list.contains(trend::Signal {{Kind::ByteVariable, 100}, 0}));
    QVERIFY(!list.contains(trend::Signal {{Kind::Torque, 1}, 7}));
    for (const trend::Signal &signal : list)
        QVERIFY(!trend::label(signal).isEmpty());
}

void TrendPageTest::modelsBehave()
{
    const trend::Track a {torque, QStringLiteral("a"), trend::Unit::Plain, trend::Series {9}};
    const trend::Track b {servo, QStringLiteral("b"), trend::Unit::Bit, trend::Series {9}};
    TrackModel model;
    QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::QtTest);
    model.setTracks({&a, &b});
    model.refresh({}, {});
    model.setTracks({&b});
    QCOMPARE(model.rowCount(), 1);
    model.setTracks({&b, &a});
    model.setTracks({});
    QCOMPARE(model.rowCount(), 0);
    models::IncidentModel incidents;
    QAbstractItemModelTester incidentTester(&incidents, QAbstractItemModelTester::FailureReportingMode::QtTest);
    incidents.add({QStringLiteral("x.json"), trend::Moment {}, QStringLiteral("Alarm")});
    models::SignalListModel signalList {{torque, servo}, {QStringLiteral("R1 S torque"), QStringLiteral("Servo on")}};
    QAbstractItemModelTester listTester(&signalList, QAbstractItemModelTester::FailureReportingMode::QtTest);
    models::SignalFilter filter {signalList, nullptr};
    QAbstractItemModelTester filterTester(&filter, QAbstractItemModelTester::FailureReportingMode::QtTest);
    filter.search(QStringLiteral("SERVO on"));
    QCOMPARE(filter.rowCount(), 1);
    filter.search({});
    QCOMPARE(filter.rowCount(), 2);
}

void TrendPageTest::pictures_data()
{
    QTest::addColumn<int>("scene");
    QTest::newRow("live") << 0;
    QTest::newRow("stale") << 1;
    QTest::newRow("incident") << 2;
}

/// What a person sees with something plotted, to be looked at.
void TrendPageTest::pictures()
{
    QFETCH(int, scene);
    Desk desk;
    desk.window.resize(1440, 900);
    QVERIFY(desk.open());
    desk.drop({{{Kind::Position, 101}, 0}, {{Kind::Position, 101}, 2}, torque, {{Kind::Torque, 1}, 1}, servo,
        {{Kind::Job, 0}, 0}});
    desk.find<QComboBox>("trendSpan")->setCurrentIndex(0);
    QTRY_VERIFY(desk.recorder().tracks()[0]->series.count() > 25);
    if (scene == 1) {
        desk.stopController();
        QTRY_VERIFY(desk.recorder().tracks()[2]->series.back().isGap());
    }
    if (scene == 2) {
        QVERIFY(desk.keepIncident());
        desk.page()->openIncident(desk.recorder().archive().incidents().front());
        QTRY_VERIFY(desk.find<QPushButton>("backToLive")->isVisible());
    }
    desk.find<widgets::Plot>("trendPlot")->setCursor(widgets::PlotCursor {0.97});
    QVERIFY(QDir().mkpath(QStringLiteral(PENDESK_PICTURES)));
    for (const ui::Scheme scheme : {ui::Scheme::Light, ui::Scheme::Dark}) {
        ui::apply(*qApp, scheme);
        QCoreApplication::sendPostedEvents();
        const QString word = scheme == ui::Scheme::Light ? QStringLiteral("light") : QStringLiteral("dark");
        QVERIFY(desk.window.grab().save(
            QStringLiteral("%1/trend-%2-%3.png")
                .arg(QStringLiteral(PENDESK_PICTURES), QLatin1String(QTest::currentDataTag()), word)));
    }
    ui::apply(*qApp, ui::Scheme::Light);
}

int main(int argc, char *argv[])
{
    QLocale::setDefault(QLocale(QLocale::English, QLocale::UnitedStates));
    QApplication application {argc, argv};
    ui::apply(application, ui::Scheme::Light);
    TrendPageTest test;
    return QTest::qExec(&test, argc, argv);
}

#include "tst_trendpage.moc"
