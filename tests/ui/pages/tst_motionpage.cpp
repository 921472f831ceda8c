// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/jobsharness.h"
#include "virtualcontroller/alarms.h"
#include "virtualcontroller/machine.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDir>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QSpinBox>

using robot::Level;
using values::AxisWords;
using values::Status;
using virtualcontroller::FaultKind;
using virtualcontroller::Faults;

namespace {

constexpr quint16 moveCartesian = 0x8A;
const AxisWords home {1'085'000, 0, 620'000, 1'800'000, 0, 0};

/// The page in view, servo on, nothing running; buttons are pressed as the window system does it.
struct Desk : JobsHarness {
    [[nodiscard]] bool openMotion(Level level = Level::Engineer)
    {
        if (!connectLive())
            return false;
        virtualcontroller::stopRunning(server->memory());
        server->memory().groups[0].pose = home;
        rest();
        access().enter(level);
        click("motionEntry");
        window.activateWindow();
        return QTest::qWaitFor([this] { return window.isActiveWindow() && !running() && orders().situation().status; })
            && QTest::qWaitFor([this] { return text("moveNow1") == u"1085.000" && text("moveNow6") == u"0.0000"; })
            && takePresent();
    }
    [[nodiscard]] bool takePresent() const
    {
        find<QPushButton>("moveTakePresent")->click();
        return QTest::qWaitFor([this] { return find<QLineEdit>("moveTarget1")->text() == u"1085.000"; });
    }
    [[nodiscard]] bool openArmed() { return openMotion() && arm() && enabled("jogPlus1"); }
    [[nodiscard]] bool enabled(const char *name) const
    {
        return QTest::qWaitFor([&] { return find(name)->isEnabled(); });
    }
    [[nodiscard]] bool arm() const
    {
        const auto *page = window.view().findChild<QWidget *>(QStringLiteral("motionPage"));
        for (const char *box : {"armNobody", "armSight", "armStop"})
            page->findChild<QAbstractButton *>(QLatin1String(box))->click();
        auto *button = page->findChild<QWidget *>(QStringLiteral("arm"));
        QCoreApplication::processEvents(); // a page that was just made has no layout yet
        const bool isPossible = QTest::qWaitFor([button] { return button->isEnabled() && button->isVisible(); });
        QTest::mousePress(button, Qt::LeftButton);
        const bool isArmed = isPossible && QTest::qWaitFor([this] { return arming.isArmed(); });
        QTest::mouseRelease(button, Qt::LeftButton);
        return isArmed;
    }
    [[nodiscard]] QPoint centre(const char *name) const
    {
        auto *widget = find(name);
        return widget->mapTo(widget->window(), widget->rect().center());
    }
    void press(const char *name)
    {
        m_pressed = centre(name);
        QTest::mousePress(window.windowHandle(), Qt::LeftButton, {}, m_pressed);
    }
    void release() { QTest::mouseRelease(window.windowHandle(), Qt::LeftButton, {}, m_pressed); }
    [[nodiscard]] AxisWords place() const
    {
        return server->memory().findGroup(values::ControlGroup::robotPulse(1))->poseAt(server->memory().now);
    }
    [[nodiscard]] int moves() const { return server->arrived(moveCartesian) + server->arrived(0x8B); }
    [[nodiscard]] bool isHeld() const { return server->memory().status.data2 & Status::HeldByCommand; }
    [[nodiscard]] QDialog *sheet() const { return find<QDialog>("moveSheet"); }
    void type(const char *name, const QString &text) const
    {
        find<QLineEdit>(name)->clear();
        QTest::keyClicks(find<QLineEdit>(name), text);
    }
    void picture(QWidget *widget, const char *name) const
    {
        QDir().mkpath(QStringLiteral(PENDESK_PICTURES));
        QVERIFY(widget->grab().save(
            QStringLiteral("%1/motion-%2.png").arg(QStringLiteral(PENDESK_PICTURES), QLatin1String(name))));
    }

private:
    QPoint m_pressed;
};

} // namespace

using Event = std::function<void(Desk &)>;
Q_DECLARE_METATYPE(Event)

/// Moving an arm from the page, over sockets.
class TestMotionPage : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { ui::apply(*qApp, ui::Scheme::Light); }
    void init() { QLocale::setDefault(QLocale::c()); }
    void closedAndSaysWhy_data();
    void closedAndSaysWhy();
    void aHeldButtonSteps();
    void lettingGo_data();
    void lettingGo();
    void keysDoNothingUnlessAllowed();
    void badLimitsCloseIt();
    void movesToATarget();
    void longMovesAskForTheName();
    void theOutcomeIsUnknown();
    void stopIsHold();
    void planComplaints_data();
    void planComplaints();
    void keepsAndTakesPoints();
};

void TestMotionPage::closedAndSaysWhy_data()
{
    QTest::addColumn<Event>("event");
    QTest::addColumn<QString>("says");
    const auto row = [](const char *name, Event event, const char *says) {
        QTest::newRow(name) << std::move(event) << QString::fromUtf8(says);
    };
    row(
        "TEACH", [](Desk &desk) { desk.server->memory().status.data1 = Status::Data1 {Status::Teach}; }, "armed");
    row(
        "held", [](Desk &desk) { desk.server->memory().status.data2.setFlag(Status::HeldByCommand); }, "eld");
    row(
        "alarm", [](Desk &desk) { virtualcontroller::raiseAlarm(desk.server->memory(), 4315, "COLLISION"); }, "armed");
    row(
        "disarmed", [](Desk &desk) { desk.arming.drop(robot::Arming::Drop::ByHand); }, "armed");
    row(
        "Monitor", [](Desk &desk) { desk.access().enter(Level::Monitor); }, "Engineer");
    row(
        "Operate", [](Desk &desk) { desk.access().enter(Level::Operate); }, "Engineer");
}

void TestMotionPage::closedAndSaysWhy()
{
    QFETCH(Event, event);
    QFETCH(QString, says);
    Desk desk;
    QVERIFY(desk.openArmed());
    QVERIFY(desk.enabled("move"));
    event(desk);
    QTRY_VERIFY(!desk.find("jogPlus1")->isEnabled());
    QTRY_VERIFY(!desk.find("move")->isEnabled());
    QTRY_VERIFY2(desk.text("jogResult").contains(says), qPrintable(desk.text("jogResult")));
    QTRY_VERIFY2(!desk.text("reason-move").isEmpty(), qPrintable(desk.text("reason-move")));
    desk.press("jogPlus1");
    desk.release();
    QTest::mouseClick(desk.find("move"), Qt::LeftButton);
    QVERIFY(!desk.sheet());
    QCOMPARE(desk.moves(), 0);
}

void TestMotionPage::aHeldButtonSteps()
{
    Desk desk;
    QVERIFY(desk.openMotion());
    desk.picture(&desk.window, "disarmed");
    QVERIFY(desk.arm());
    QVERIFY(desk.enabled("jogPlus1"));
    const AxisWords begin = desk.place();
    desk.press("jogPlus1");
    QTRY_VERIFY(desk.moves() >= 3);
    desk.picture(&desk.window, "armed");
    desk.release();
    const int sent = desk.moves();
    QTRY_VERIFY(desk.isHeld());
    QVERIFY(desk.moves() <= sent + 1);
    const qint32 way = desk.place()[0] - begin[0];
    QVERIFY2(way > 0 && way <= (sent + 1) * 1000, qPrintable(QString::number(way))); // 1 mm each
    QCOMPARE(desk.place()[1], begin[1]);
}

void TestMotionPage::lettingGo_data()
{
    QTest::addColumn<Event>("event");
    const auto row = [](const char *name, Event event) { QTest::newRow(name) << std::move(event); };
    row("outside of the button", [](Desk &desk) {
        QTest::mouseMove(desk.window.windowHandle(), desk.centre("jogMinus4"));
        QTest::mouseMove(desk.window.windowHandle(), desk.centre("jogPlus1")); // coming back does not press again
    });
    row("another page", [](Desk &desk) { desk.click("overviewEntry"); });
    row("another window in front", [](Desk &) {
        static QWidget other;
        other.show();
        other.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&other));
        other.hide();
    });
    row("the release went elsewhere",
        [](Desk &desk) { QTest::mouseRelease(desk.window.windowHandle(), Qt::LeftButton, {}, QPoint(2, 2)); });
    row("the other mouse button too", [](Desk &desk) {
        QTest::mousePress(desk.window.windowHandle(), Qt::RightButton, {}, desk.centre("jogPlus1"));
    });
    row("access drops", [](Desk &desk) { desk.access().enter(Level::Monitor); });
    row("Pause key", [](Desk &desk) { QTest::keyClick(&desk.window, Qt::Key_Pause); });
}

void TestMotionPage::lettingGo()
{
    QFETCH(Event, event);
    Desk desk;
    QVERIFY(desk.openArmed());
    desk.press("jogPlus1");
    QTRY_VERIFY(desk.moves() >= 1);
    event(desk);
    const int sent = desk.moves();
    QTRY_VERIFY(!desk.running());
    QTRY_VERIFY(!desk.server->memory().groups[0].motion);
    QVERIFY(desk.moves() <= sent + 1);
    const AxisWords place = desk.place();
    desk.release();
    QCOMPARE(desk.place(), place);
    QVERIFY(desk.moves() <= sent + 1);
}

void TestMotionPage::keysDoNothingUnlessAllowed()
{
    Desk desk;
    QVERIFY(desk.openArmed());
    auto *button = desk.find("jogPlus3");
    button->setFocus();
    for (const auto key : {Qt::Key_Space, Qt::Key_Return, Qt::Key_Enter})
        QTest::keyClick(desk.window.windowHandle(), key);
    QTest::keyPress(desk.window.windowHandle(), Qt::Key_Space, Qt::ControlModifier);
    QTest::keyRelease(desk.window.windowHandle(), Qt::Key_Space, Qt::ControlModifier);
    QCOMPARE(desk.moves(), 0);
    desk.find<QCheckBox>("jogKeys")->click();
    button->setFocus();
    QTest::keyClick(desk.window.windowHandle(), Qt::Key_Space); // without the modifier
    QCOMPARE(desk.moves(), 0);
    QTest::keyPress(desk.window.windowHandle(), Qt::Key_Control, Qt::ControlModifier);
    QTest::keyPress(desk.window.windowHandle(), Qt::Key_Space, Qt::ControlModifier);
    QTRY_VERIFY(desk.moves() >= 2);
    QTest::keyRelease(desk.window.windowHandle(), Qt::Key_Control, Qt::NoModifier); // either key
    QTRY_VERIFY(desk.isHeld());
    const int sent = desk.moves();
    QTRY_VERIFY(!desk.running());
    QCOMPARE(desk.moves(), sent);
}

void TestMotionPage::badLimitsCloseIt()
{
    Desk desk;
    QVERIFY(desk.startController());
    desk.window.show();
    auto profile = desk.profile();
    profile.motion.toolSpeed = -5;
    desk.window.connectTo(profile);
    QTRY_VERIFY(desk.isAllLive());
    desk.rest();
    desk.access().enter(Level::Engineer);
    desk.click("motionEntry");
    QVERIFY(desk.arm());
    QVERIFY(!desk.find("jogPlus1")->isEnabled());
    QVERIFY2(desk.text("jogResult").contains(QStringLiteral("motion limit")), qPrintable(desk.text("jogResult")));
    QTRY_VERIFY(!desk.find("move")->isEnabled());
    QVERIFY2(desk.text("reason-move").contains(QStringLiteral("motion limit")), qPrintable(desk.text("reason-move")));
}

void TestMotionPage::movesToATarget()
{
    Desk desk;
    QVERIFY(desk.openArmed());
    const AxisWords begin = desk.place();
    desk.type("moveTarget1", QString::number(begin[0] / 1e3 + 20, 'f', 3));
    QTRY_COMPARE(desk.text("moveChange1"), QStringLiteral("20.000"));
    desk.find<QDoubleSpinBox>("moveToolSpeed")->setValue(50);
    QVERIFY(desk.enabled("move"));
    desk.click("move");
    QVERIFY(desk.sheet());
    QVERIFY(!desk.find("sheetMove")->isEnabled()); // for a second
    QCOMPARE(desk.text("sheetWay"), QStringLiteral("20.0 mm straight, turning 0.0°"));
    QCOMPARE(desk.text("sheetTime"), QStringLiteral("about 0.4 s"));
    QTRY_VERIFY(desk.text("sheetNear").contains(QStringLiteral("P0")));
    QTest::keyClick(desk.sheet(), Qt::Key_F9); // without the name
    QCOMPARE(desk.moves(), 0);
    QVERIFY(desk.enabled("sheetMove"));
    desk.picture(desk.sheet(), "rehearsal");
    desk.click("sheetMove");
    QTRY_VERIFY2(
        desk.text("sheetOutcome").startsWith(QStringLiteral("Arrived")), qPrintable(desk.text("sheetOutcome")));
    QCOMPARE(desk.moves(), 1);
    QCOMPARE(desk.place()[0], begin[0] + 20'000);
    desk.picture(desk.sheet(), "arrived");
    QVERIFY(!desk.find("sheetMove")->isEnabled()); // a sheet moves once
}

void TestMotionPage::longMovesAskForTheName()
{
    Desk desk;
    QVERIFY(desk.openArmed());
    desk.type("moveTarget2", QStringLiteral("150"));
    QVERIFY(desk.enabled("move"));
    desk.click("move");
    QTRY_VERIFY(desk.find<QLineEdit>("sheetName")->placeholderText().contains(QStringLiteral("CELL 4")));
    QTest::keyClicks(desk.find<QLineEdit>("sheetName"), QStringLiteral("CELL 4"));
    QTRY_COMPARE(desk.text("sheetReason"), QString());
    QVERIFY(!desk.find("sheetMove")->isEnabled());
    QTest::keyClicks(desk.find<QLineEdit>("sheetName"), QStringLiteral(" · Weld"));
    QVERIFY(desk.enabled("sheetMove"));
    QTest::keyClick(desk.sheet(), Qt::Key_F9);
    QTRY_COMPARE(desk.moves(), 1);
}

void TestMotionPage::theOutcomeIsUnknown()
{
    Desk desk;
    QVERIFY(desk.openArmed());
    desk.server->setFaults(Faults {{{.command = moveCartesian, .kind = FaultKind::Lose}}});
    desk.type("moveTarget3", QString::number(desk.place()[2] / 1e3 - 5, 'f', 3));
    QVERIFY(desk.enabled("move"));
    desk.click("move");
    QVERIFY(desk.sheet() && desk.enabled("sheetMove"));
    desk.click("sheetMove");
    QTRY_VERIFY2(desk.text("sheetOutcome").contains(QStringLiteral("unknown")), qPrintable(desk.text("sheetOutcome")));
    QCOMPARE(desk.moves(), 1);
    desk.picture(desk.sheet(), "unknown");
}

void TestMotionPage::stopIsHold()
{
    Desk desk;
    QVERIFY(desk.openArmed());
    const AxisWords begin = desk.place();
    desk.type("moveTarget1", QString::number(begin[0] / 1e3 + 50, 'f', 3));
    QVERIFY(desk.enabled("move"));
    desk.click("move");
    QVERIFY(desk.sheet() && desk.enabled("sheetMove"));
    desk.click("sheetMove");
    QTRY_VERIFY(desk.place()[0] > begin[0] + 1000);
    desk.click("sheetStop");
    QTRY_VERIFY2(
        desk.text("sheetOutcome").startsWith(QStringLiteral("Stopped")), qPrintable(desk.text("sheetOutcome")));
    QVERIFY(desk.isHeld());
    QVERIFY(desk.place()[0] < begin[0] + 50'000);
    desk.picture(desk.sheet(), "stopped");
}

void TestMotionPage::planComplaints_data()
{
    QTest::addColumn<Event>("event");
    QTest::addColumn<QString>("says");
    const auto row = [](const char *name, Event event, const char *says) {
        QTest::newRow(name) << std::move(event) << QString::fromUtf8(says);
    };
    const auto choose = [](Desk &desk, const char *box, int choice) {
        desk.find<QComboBox>(box)->setCurrentIndex(choice);
    };
    row(
        "no number", [](Desk &desk) { desk.type("moveTarget1", QStringLiteral("here")); }, "X");
    row(
        "nan", [](Desk &desk) { desk.type("moveTarget1", QStringLiteral("nan")); }, "X");
    row(
        "user frame", [choose](Desk &desk) { choose(desk, "moveFrame", 2); }, "checked on the robot");
    row(
        "tool frame", [choose](Desk &desk) { choose(desk, "moveFrame", 3); }, "checked on the robot");
    row(
        "straight in pulses", [choose](Desk &desk) { choose(desk, "moveFrame", 4); }, "joint move");
}

void TestMotionPage::planComplaints()
{
    QFETCH(Event, event);
    QFETCH(QString, says);
    Desk desk;
    QVERIFY(desk.openArmed());
    QVERIFY(desk.enabled("move"));
    event(desk);
    QTRY_VERIFY(!desk.find("move")->isEnabled());
    QVERIFY2(desk.text("reason-move").contains(says), qPrintable(desk.text("reason-move")));
}

void TestMotionPage::keepsAndTakesPoints()
{
    Desk desk;
    QVERIFY(desk.openMotion());
    desk.window.view().orders().setNumberingVerified(true);
    QTRY_COMPARE(desk.text("moveNow1"), QString::number(desk.place()[0] / 1e3, 'f', 3));
    desk.find<QSpinBox>("moveVariable")->setValue(50);
    desk.click("moveKeep");
    QTRY_VERIFY2(desk.text("moveNote").contains(QStringLiteral("read back")), qPrintable(desk.text("moveNote")));
    QVERIFY(desk.server->memory().p[50].has_value());
    QCOMPARE(desk.server->memory().p[50]->position.axes[0], desk.place()[0]);
    desk.type("moveTarget1", QStringLiteral("1"));
    desk.click("moveTakeVariable");
    QTRY_COMPARE(desk.text("moveChange1"), QStringLiteral("0.000"));
    desk.find<QSpinBox>("moveVariable")->setValue(51); // never taught
    desk.click("moveTakeVariable");
    QTRY_COMPARE(desk.text("moveNote"), QStringLiteral("P051 is not taught."));
}

QTEST_MAIN(TestMotionPage)
#include "tst_motionpage.moc"
