// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/accessswitch.h"
#include "ui/desktopwatch.h"
#include "ui/harness.h"
#include "ui/presence.h"

#include <QDialog>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QSignalSpy>
#include <QSpinBox>
#include <QStatusBar>

using robot::Arming;
using robot::Level;
using Happening = void (*)(Harness &);

class TestAccessSwitch : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void showsTheLevel()
    {
        Harness harness;
        harness.window.show();
        QCOMPARE(badge(harness)->text(), QStringLiteral("MONITOR"));
        choose(harness, "levelOperate");
        QCOMPARE(badge(harness)->text(), QStringLiteral("OPERATE"));
        QVERIFY(harness.access().level() == Level::Operate);
        QCOMPARE(harness.window.findChild<QLabel *>(QStringLiteral("levelInStatusBar"))->text(),
            QStringLiteral("Level: Operate"));
        harness.access().enter(Level::Monitor);
        QCOMPARE(badge(harness)->text(), QStringLiteral("MONITOR"));
    }

    void keyboardOpensIt()
    {
        Harness harness;
        harness.window.show();
        QVERIFY(QTest::qWaitForWindowActive(&harness.window));
        QTimer::singleShot(0, badge(harness)->menu(), [menu = badge(harness)->menu()] {
            QVERIFY(menu->isVisible());
            QTest::keyClick(menu, Qt::Key_Down);
            QTest::keyClick(menu, Qt::Key_Down);
            QTest::keyClick(menu, Qt::Key_Return);
        });
        QTest::keyClick(&harness.window, Qt::Key_L, Qt::ControlModifier);
        QTRY_VERIFY(harness.access().level() == Level::Operate);
    }

    void asksForThePasscode()
    {
        Harness harness;
        settings::AccessSettings settings;
        settings.passcode = settings::Passcode::of(QStringLiteral("0815"), 1000);
        harness.rules.setSettings(settings);
        harness.window.show();
        choose(harness, "levelEngineer");
        auto *dialog = harness.window.findChild<QDialog *>(QStringLiteral("passcodeDialog"));
        QVERIFY(dialog);
        QVERIFY(harness.access().level() == Level::Monitor);
        auto *edit = dialog->findChild<QLineEdit *>(QStringLiteral("passcode"));
        QTest::keyClicks(edit, QStringLiteral("4711"));
        QTest::keyClick(edit, Qt::Key_Return);
        const auto *complaint = dialog->findChild<QLabel *>(QStringLiteral("passcodeComplaint"));
        QTRY_COMPARE(complaint->text(), QStringLiteral("That is not the passcode."));
        QVERIFY(harness.access().level() == Level::Monitor);
        QTest::keyClicks(edit, QStringLiteral("0815")); // what was wrong is selected
        QTest::keyClick(edit, Qt::Key_Return);
        QTRY_VERIFY_WITH_TIMEOUT(harness.access().level() == Level::Engineer, 60'000); // it is kept anew
    }

    void setsThePasscode()
    {
        Harness harness;
        harness.window.show();
        QVERIFY(!action(harness, "accessSettings")->isEnabled()); // Engineers only
        harness.access().enter(Level::Engineer);
        choose(harness, "accessSettings");
        auto *dialog = harness.window.findChild<QDialog *>(QStringLiteral("accessSettingsDialog"));
        QVERIFY(dialog);
        const auto edit = [&](const char *name) { return dialog->findChild<QLineEdit *>(QLatin1String(name)); };
        QTest::keyClicks(edit("newPasscode"), QStringLiteral("abc"));
        QTest::keyClick(edit("newPasscode"), Qt::Key_Return);
        QVERIFY(!harness.rules.settings().passcode); // not the same twice
        QTest::keyClicks(edit("newPasscodeAgain"), QStringLiteral("abc"));
        dialog->findChild<QSpinBox *>(QStringLiteral("idleMinutes"))->setValue(3);
        QTest::mouseClick(dialog->findChild<QPushButton *>(QStringLiteral("okButton")), Qt::LeftButton);
        QTRY_VERIFY_WITH_TIMEOUT(harness.rules.settings().passcode, 60'000);
        QVERIFY(!harness.rules.settings().passcode->isOutdated());
        QVERIFY(harness.rules.settings().idleTime == std::chrono::minutes {3});
    }

    void monitorOnlyOffersNothingElse()
    {
        Harness harness;
        harness.rules.restrictToMonitor();
        harness.window.offer({});
        harness.window.show();
        QVERIFY(!action(harness, "levelOperate")->isEnabled());
        QVERIFY(!action(harness, "levelEngineer")->isEnabled());
        QVERIFY(!badge(harness)->toolTip().isEmpty());
    }

    void armingShowsInTheStripAndDrops()
    {
        Harness harness;
        const ui::Presence presence {harness.rules, harness.arming};
        QVERIFY(harness.connectLive());
        harness.server->memory().alarms.clear();
        auto *armed = harness.window.findChild<QPushButton *>(QStringLiteral("armBadge"));
        QVERIFY(!armed->isVisible());
        QVERIFY(!harness.window.view().orders().arm()); // Monitor
        harness.access().enter(Level::Operate);
        QVERIFY(harness.window.view().orders().arm());
        QVERIFY(armed->isVisible());
        QVERIFY(armed->text().startsWith(QStringLiteral("ARMED")));
        QTest::mouseClick(armed, Qt::LeftButton);
        QVERIFY(!armed->isVisible());
        QVERIFY(harness.window.view().orders().lastDrop()->reason == Arming::Drop::ByHand);
        QVERIFY(harness.window.view().orders().arm());
        QSignalSpy dropped {&harness.arming, &Arming::dropped};
        harness.window.offer({});
        QCOMPARE(dropped.count(), 1);
        QVERIFY(dropped.constFirst().at(1).value<Arming::Drop>() == Arming::Drop::StationLeft);
    }

    void anotherControllerBeginsInMonitor()
    {
        Harness harness;
        QVERIFY(harness.connectLive());
        harness.server->memory().alarms.clear();
        harness.access().enter(Level::Engineer);
        QVERIFY(harness.window.view().orders().arm());
        settings::Profile other = harness.profile();
        other.name = QStringLiteral("CELL 5");
        harness.window.connectTo(other);
        QVERIFY(harness.access().level() == Level::Monitor);
        QCOMPARE(badge(harness)->text(), QStringLiteral("MONITOR"));
        QCOMPARE(harness.window.findChild<QLabel *>(QStringLiteral("levelInStatusBar"))->text(),
            QStringLiteral("Level: Monitor"));
        QVERIFY(!harness.arming.isArmed());
        QVERIFY(!harness.window.view().orders().lastDrop()); // this one never was armed
        harness.window.connectTo(harness.profile());
        QVERIFY(harness.access().level() == Level::Monitor); // nor is a level kept for whoever comes back
        QVERIFY(harness.window.view().orders().lastDrop()->reason == Arming::Drop::StationLeft);
    }

    void theReasonOfDisarmingIsTheTrueOne_data()
    {
        QTest::addColumn<Happening>("happening");
        QTest::addColumn<int>("reason");
        using Drop = Arming::Drop;
        const auto row = [](const char *name, Happening happening, Drop reason) {
            QTest::newRow(name) << happening << int(reason);
        };
        row(
            "disconnected", [](Harness &harness) { harness.window.controller().close(); }, Drop::Disconnected);
        row(
            "link lost", [](Harness &harness) { harness.stopController(); }, Drop::CommunicationLost);
        row(
            "level given up", [](Harness &harness) { harness.access().enter(Level::Monitor); }, Drop::AccessDropped);
        row(
            "monitor only", [](Harness &harness) { harness.rules.restrictToMonitor(); }, Drop::AccessDropped);
        row(
            "another language",
            [](Harness &harness) {
                QEvent change {QEvent::LanguageChange};
                QCoreApplication::sendEvent(&harness.window, &change);
            },
            Drop::LanguageChanged);
    }

    void theReasonOfDisarmingIsTheTrueOne()
    {
        QFETCH(Happening, happening);
        QFETCH(int, reason);
        Harness harness;
        QVERIFY(harness.connectLive());
        harness.server->memory().alarms.clear();
        harness.access().enter(Level::Operate);
        QVERIFY(harness.window.view().orders().arm());
        happening(harness);
        QTRY_VERIFY(!harness.arming.isArmed());
        QCOMPARE(int(harness.window.view().orders().lastDrop()->reason), reason);
    }

    void anotherWindowDisarmsAndADialogDoesNot()
    {
        Harness harness;
        const ui::Presence presence {harness.rules, harness.arming};
        QVERIFY(harness.connectLive());
        harness.window.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&harness.window));
        harness.access().enter(Level::Operate);
        QVERIFY(harness.window.view().orders().arm());
        QDialog dialog(&harness.window);
        dialog.show();
        QVERIFY(QTest::qWaitForWindowActive(&dialog));
        QVERIFY(harness.arming.isArmed());
        dialog.close();
        QWidget second;
        second.show();
        second.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&second));
        QTRY_VERIFY(!harness.arming.isArmed());
        QVERIFY(harness.window.view().orders().lastDrop()->reason == Arming::Drop::SecondWindow);
    }

    void theDesktopDisarms_data()
    {
        QTest::addColumn<QByteArray>("signal");
        QTest::addColumn<int>("reason");
        QTest::newRow("lock") << QByteArray("screenLocked") << int(Arming::Drop::ScreenLocked);
        QTest::newRow("sleep") << QByteArray("sleepBegun") << int(Arming::Drop::Sleep);
    }
    void theDesktopDisarms()
    {
        QFETCH(QByteArray, signal);
        QFETCH(int, reason);
        Harness harness;
        const ui::Presence presence {harness.rules, harness.arming};
        QVERIFY(harness.connectLive());
        harness.access().enter(Level::Operate);
        QVERIFY(harness.window.view().orders().arm());
        QVERIFY(QMetaObject::invokeMethod(presence.findChild<ui::DesktopWatch *>(), signal.constData()));
        QVERIFY(!harness.arming.isArmed());
        QCOMPARE(int(harness.window.view().orders().lastDrop()->reason), reason);
    }

    void keysAreActivity()
    {
        Harness harness;
        const ui::Presence presence {harness.rules, harness.arming};
        QVERIFY(harness.connectLive());
        harness.access().enter(Level::Operate);
        QVERIFY(harness.window.view().orders().arm());
        using namespace std::chrono_literals;
        harness.arming.noteActivity(values::now() - 50s);
        QVERIFY(harness.arming.remaining(values::now()) < 11s);
        QTest::keyClick(&harness.window, Qt::Key_F12);
        QVERIFY(harness.arming.remaining(values::now()) > 50s);
    }

private:
    static ui::AccessSwitch *badge(const Harness &harness)
    {
        return harness.window.findChild<ui::AccessSwitch *>(QStringLiteral("accessBadge"));
    }
    static QAction *action(const Harness &harness, const char *name)
    {
        return badge(harness)->menu()->findChild<QAction *>(QLatin1String(name));
    }
    static void choose(const Harness &harness, const char *name) { action(harness, name)->trigger(); }
};

QTEST_MAIN(TestAccessSwitch)
#include "tst_accessswitch.moc"
