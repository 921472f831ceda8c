// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/harness.h"

#include "ui/pagecatalog.h"
#include "ui/pages/page.h"
#include "ui/widgets/toolpathview.h"
#include <QClipboard>
#include <QContextMenuEvent>
#include <QMenu>
#include <QPushButton>
#include <QTabBar>

using robot::Freshness;
using robot::Kind;
using values::AxisWords;
using values::ControlGroup;
using widgets::ToolPathView;

namespace {

const AxisWords pose {1024318, -311902, 688004, 1799984, -120, 124410};

/// The position page in view, connected to a controller at rest.
struct Desk : Harness {
    bool open(const settings::Profile &own)
    {
        window.show();
        window.connectTo(own);
        for (int row = 0; row < int(ui::pageCatalog().size()); ++row) {
            if (QLatin1String(ui::pageCatalog()[row].id) == u"position")
                window.view().openPage(row);
        }
        return QTest::qWaitFor([&] { return value("axisPulse1")->shown().freshness == Freshness::Live; });
    }
    bool startAtRest(const AxisWords &at = pose)
    {
        if (!startController())
            return false;
        server->memory() = virtualcontroller::Memory {};
        server->memory().groups[0].pose = at;
        return true;
    }
    bool openAtRest(const AxisWords &at = pose) { return startAtRest(at) && open(profile()); }
    /// On this page: another one shows the tool point too.
    template <typename Widget> [[nodiscard]] Widget *find(const char *name) const
    {
        const auto *page = window.view().findChild<QWidget *>(QStringLiteral("positionPage"));
        return page->findChild<Widget *>(QLatin1String(name));
    }
    [[nodiscard]] widgets::ValueLabel *value(const char *name) const { return find<widgets::ValueLabel>(name); }
    [[nodiscard]] QString word(const char *name) const { return value(name) ? value(name)->text() : QString(); }
    void click(const char *name) const { QTest::mouseClick(find<QPushButton>(name), Qt::LeftButton); }
    [[nodiscard]] QStringList tabs() const
    {
        QStringList result;
        const auto *bar = find<QTabBar>("groupTabs");
        for (int i = 0; i < bar->count(); ++i)
            result << bar->tabText(i);
        return result;
    }
    void refuse(quint16 command)
    {
        server->setFaults(virtualcontroller::Faults {{{.command = command,
            .direction = virtualcontroller::Direction::Request,
            .kind = virtualcontroller::FaultKind::Refuse,
            .code = 0xA001}}});
    }
};

} // namespace

/// The position page over real sockets.
class PositionPageTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void showsWhereItStands();
    void showsAsManyAxesAsThereAre_data();
    void showsAsManyAxesAsThereAre();
    void showsGroupsThatAnswer();
    void stationHasNoToolPoint();
    void degreesOnlyFromTheProfile();
    void temperaturesWhereTheModelHasThem();
    void saysWhatIsRefused();
    void keepsExtremes();
    void looksStale();
    void drawsThePath();
    void copiesText();
    void offersTheTrend();
    void hiddenReadsNothing();
};

void PositionPageTest::showsWhereItStands()
{
    Desk desk;
    QVERIFY(desk.openAtRest());
    QTRY_COMPARE(desk.word("cartesian1"), QStringLiteral("1024.318"));
    QCOMPARE(desk.word("cartesian5"), QStringLiteral("-0.0120"));
    QCOMPARE(desk.word("form"), QStringLiteral("front · upper arm · flip · R < 180 · T < 180 · S < 180"));
    const auto &pulses = desk.state().pulsePosition().value->axes;
    QCOMPARE(desk.word("axisPulse1"), QLocale().toString(pulses[0]));
    QTRY_COMPARE(desk.word("axisError1"), QStringLiteral("0"));
    QTRY_VERIFY(desk.value("axisTorque1")->shown().freshness == Freshness::Live);
    QTRY_VERIFY(desk.value("axisTemperature1")->shown().freshness == Freshness::Live);
    QTRY_VERIFY(desk.find<QLabel>("converters")->text().startsWith(QStringLiteral("Converter 1:")));
    QVERIFY(desk.value("cartesian1")->accessibleName().contains(QStringLiteral("1024.318")));
}

void PositionPageTest::showsAsManyAxesAsThereAre_data()
{
    QTest::addColumn<int>("axes");
    for (int axes = 4; axes <= values::maxAxes; ++axes)
        QTest::addRow("%d axes", axes) << axes;
}

void PositionPageTest::showsAsManyAxesAsThereAre()
{
    QFETCH(int, axes);
    AxisWords at = pose;
    at.resize(axes);
    Desk desk;
    QVERIFY(desk.openAtRest(at));
    for (int axis = 1; axis <= values::maxAxes; ++axis) {
        const QByteArray name = "axisPulse" + QByteArray::number(axis);
        QTRY_COMPARE(desk.value(name.constData())->isVisible(), axis <= axes);
    }
}

void PositionPageTest::showsGroupsThatAnswer()
{
    Desk desk;
    QVERIFY(desk.startAtRest());
    desk.server->memory().groups.push_back({ControlGroup::basePulse(1), AxisWords {1500}, {}});
    desk.server->memory().groups.push_back({ControlGroup::stationPulse(1), AxisWords {10, 20, -30}, {}});
    QVERIFY(desk.open(desk.profile()));
    QTRY_COMPARE(desk.tabs(), (QStringList {QStringLiteral("R1"), QStringLiteral("B1"), QStringLiteral("S1")}));
    // 8 robots, 8 bases and 24 stations may be there (reference §2.1); three are.
    QTRY_VERIFY(desk.find<QLabel>("pageSubject")->toolTip().contains(QStringLiteral("37 of 40")));
    desk.find<QTabBar>("groupTabs")->setCurrentIndex(2);
    QTRY_COMPARE(desk.word("axisPulse3"), QStringLiteral("-30"));
    QVERIFY(!desk.value("axisPulse4")->isVisible());
}

void PositionPageTest::stationHasNoToolPoint()
{
    Desk desk;
    QVERIFY(desk.startAtRest());
    desk.server->memory().groups.push_back({ControlGroup::stationPulse(1), AxisWords {10}, {}});
    QVERIFY(desk.open(desk.profile()));
    QTRY_COMPARE(desk.tabs().size(), 2);
    desk.find<QTabBar>("groupTabs")->setCurrentIndex(1);
    QTRY_COMPARE(desk.word("axisPulse1"), QStringLiteral("10"));
    QCOMPARE(desk.word("cartesian1"), widgets::dash());
    QCOMPARE(desk.word("form"), widgets::dash());
}

void PositionPageTest::degreesOnlyFromTheProfile()
{
    Desk desk;
    QVERIFY(desk.openAtRest());
    QVERIFY(!desk.value("axisDegree1")->isVisible());
    Desk knowing;
    QVERIFY(knowing.startAtRest());
    auto profile = knowing.profile();
    profile.pulsesPerDegree[1] = {1000, -500};
    QVERIFY(knowing.open(profile));
    QVERIFY(knowing.value("axisDegree1")->isVisible());
    const auto &pulses = knowing.state().pulsePosition().value->axes;
    QTRY_COMPARE(knowing.word("axisDegree1"), QLocale().toString(pulses[0] / 1000.0, 'f', 4));
    QCOMPARE(knowing.word("axisDegree2"), QLocale().toString(pulses[1] / -500.0, 'f', 4));
    QCOMPARE(knowing.word("axisDegree3"), widgets::dash());
}

void PositionPageTest::temperaturesWhereTheModelHasThem()
{
    Desk desk;
    QVERIFY(desk.startAtRest());
    auto profile = desk.profile();
    profile.model = protocol::Model::FS100;
    QVERIFY(desk.open(profile));
    QCOMPARE(desk.value("axisTemperature1")->isVisible(), profile.dialect().hasTemperatures);
}

void PositionPageTest::saysWhatIsRefused()
{
    Desk desk;
    QVERIFY(desk.startAtRest());
    desk.refuse(0x77);
    QVERIFY(desk.open(desk.profile()));
    QTRY_VERIFY(desk.value("axisTorque1")->shown().freshness == Freshness::Refused);
    QCOMPARE(desk.word("axisTorque1"), widgets::dash());
    QVERIFY(desk.value("axisTorque1")->toolTip().contains(QStringLiteral("A001")));
    QTRY_VERIFY(desk.value("axisPulse1")->shown().freshness == Freshness::Live);
}

void PositionPageTest::keepsExtremes()
{
    Desk desk;
    QVERIFY(desk.openAtRest());
    QTRY_COMPARE(desk.word("cartesianMin1"), QStringLiteral("1024.318"));
    desk.server->memory().groups[0].pose[0] = 900000;
    QTRY_COMPARE(desk.word("cartesianMin1"), QStringLiteral("900.000"));
    QCOMPARE(desk.word("cartesianMax1"), QStringLiteral("1024.318"));
    desk.click("resetExtremes");
    QCOMPARE(desk.word("cartesianMax1"), QStringLiteral("900.000"));
}

void PositionPageTest::looksStale()
{
    Desk desk;
    QVERIFY(desk.openAtRest());
    for (const char *name : {"cartesian1", "axisTorque1"})
        QTRY_VERIFY(desk.value(name)->shown().freshness == Freshness::Live);
    desk.stopController();
    QTRY_VERIFY(desk.value("cartesian1")->shown().freshness == Freshness::Stale);
    QTRY_VERIFY(desk.value("axisTorque1")->shown().freshness == Freshness::Stale);
    QTRY_VERIFY(desk.find<ToolPathView>("pathTop")->accessibleDescription().contains(QStringLiteral("Last seen")));
}

void PositionPageTest::drawsThePath()
{
    Desk desk;
    QVERIFY(desk.openAtRest());
    const auto describes = [&](const char *view, const char *text) {
        return desk.find<ToolPathView>(view)->accessibleDescription() == QLatin1String(text);
    };
    QTRY_VERIFY(describes("pathTop", "X 1,024.3 mm, Y -311.9 mm."));
    desk.server->memory().groups[0].pose[2] = 700000;
    QTRY_VERIFY(describes("pathFront", "Y -311.9 mm, Z 700.0 mm."));
    QVERIFY(describes("pathSide", "X 1,024.3 mm, Z 700.0 mm."));
    desk.click("clearPath");
    QTRY_VERIFY(describes("pathTop", "X 1,024.3 mm, Y -311.9 mm."));
}

void PositionPageTest::copiesText()
{
    Desk desk;
    QVERIFY(desk.openAtRest());
    QTRY_COMPARE(desk.word("cartesian1"), QStringLiteral("1024.318"));
    QTRY_VERIFY(desk.state().baseAxisNames().value && desk.state().pulseAxisNames().value);
    desk.click("copyPosition");
    const QString text = QApplication::clipboard()->text();
    QVERIFY(text.contains(QStringLiteral("CELL 4 · Weld")));
    QVERIFY(text.contains(QStringLiteral("R1, base frame, tool 0")));
    QVERIFY(text.contains(QStringLiteral("X (mm)\t1024.318")));
    QVERIFY(text.contains(QStringLiteral("Form: front")));
}

void PositionPageTest::offersTheTrend()
{
    Desk desk;
    QVERIFY(desk.openAtRest());
    QTRY_VERIFY(desk.state().pulseAxisNames().value);
    QWidget *value = desk.value("axisTorque2");
    QContextMenuEvent event(QContextMenuEvent::Mouse, QPoint(3, 3), value->mapToGlobal(QPoint(3, 3)));
    QCoreApplication::sendEvent(value, &event);
    auto *menu = value->findChild<QMenu *>(QStringLiteral("trendMenu"));
    QVERIFY(menu);
    QAction *action = menu->actions().front();
    QCOMPARE(action->text(), QStringLiteral("Add to trend: R1 L torque"));
    action->trigger();
    menu->close();
    const QList<trend::Signal> expected {{{Kind::Torque, 1}, 1}};
    QVERIFY(desk.window.view().recorder().signalSet() == expected);
}

void PositionPageTest::hiddenReadsNothing()
{
    Desk desk;
    QVERIFY(desk.openAtRest());
    auto &poller = desk.window.controller().poller();
    QVERIFY(poller.planSize() > 40);
    desk.window.view().openPage(0);
    QVERIFY(poller.planSize() < 20);
}

int main(int argc, char *argv[])
{
    QLocale::setDefault(QLocale(QLocale::English, QLocale::UnitedStates));
    QApplication application {argc, argv};
    ui::apply(application, ui::Scheme::Light);
    PositionPageTest test;
    return QTest::qExec(&test, argc, argv);
}

#include "tst_positionpage.moc"
