// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/harness.h"
#include "ui/pages/page.h"

#include "ui/widgets/holdbutton.h"
#include "ui/widgets/line.h"
#include <QAbstractButton>
#include <QDialog>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QSignalSpy>

using robot::LinkState;

namespace {

/// The first page; every page has a panel for the time without a link.
pages::Page *overview(const Harness &harness) { return harness.window.view().page(0); }

} // namespace

/// The window with a virtual controller behind it, driven by mouse and keys.
class TestMainWindow : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void beginsNotConnected();
    void demoByButton();
    void titleCarriesTheName();
    void holdByButton();
    void holdByKey_data();
    void holdByKey();
    void holdInModalDialog();
    void holdFromMenu();
    void holdWithoutLinkSaysWhyNot();
    void holdWithoutAnswerIsNotConfirmed();
    void lostAndRestored();
    void checkingSaysWhatIsWrong();
    void disconnectForgets();
    void exchangesControllers();
    void simulationMark();
    void shortcutsAreListed();
    void everythingHasAName();
};

void TestMainWindow::beginsNotConnected()
{
    Harness harness;
    harness.window.show();
    QVERIFY(overview(harness)->findChild<QWidget *>(QStringLiteral("notConnected"))->isVisible());
    QVERIFY(overview(harness)->findChild<QPushButton *>(QStringLiteral("connectButton"))->isVisible());
    QCOMPARE(harness.word("stripServo"), QStringLiteral("—"));
    QVERIFY(!harness.window.actions().action(ui::ActionId::Disconnect)->isEnabled());
}

void TestMainWindow::demoByButton()
{
    Harness harness;
    harness.window.show();
    QTest::mouseClick(overview(harness)->findChild<QPushButton *>(QStringLiteral("demoButton")), Qt::LeftButton);
    QTRY_VERIFY(harness.isAllLive());
    QCOMPARE(harness.word("stripMode"), QStringLiteral("REMOTE PLAY"));
    QCOMPARE(harness.word("servo"), QStringLiteral("ON"));
    QVERIFY(harness.window.findChild<QWidget *>(QStringLiteral("overviewBoard"))->isVisible());
}

void TestMainWindow::titleCarriesTheName()
{
    Harness harness;
    QVERIFY(harness.connectLive());
    QVERIFY(harness.window.windowTitle().contains(QStringLiteral("CELL 4 · Weld")));
    QCOMPARE(harness.word("stripName"), QStringLiteral("CELL 4 · Weld"));
}

void TestMainWindow::holdByButton()
{
    Harness harness;
    QVERIFY(harness.connectLive());
    QTest::mouseClick(harness.window.findChild<QAbstractButton *>(QStringLiteral("holdButton")), Qt::LeftButton);
    QTRY_COMPARE(harness.word("heldByCommand"), QStringLiteral("HELD"));
    QTRY_VERIFY(harness.window.controller().holdState().word == robot::HoldWord::HeldByCommand);
    const auto *hold = harness.window.findChild<widgets::HoldButton *>();
    QCOMPARE(hold->caption(), QStringLiteral("held by command"));
    harness.server->memory().status.data2.setFlag(values::Status::HeldByCommand, false);
    QTRY_COMPARE(hold->caption(), QStringLiteral("released"));
    QTRY_COMPARE(hold->caption(), QStringLiteral("software hold · Pause key"));
    QTest::keyClick(&harness.window, Qt::Key_Pause);
    QTRY_COMPARE(hold->caption(), QStringLiteral("held by command"));
    QVERIFY(harness.server->memory().status.data2 & values::Status::HeldByCommand);
}

void TestMainWindow::holdByKey_data()
{
    QTest::addColumn<Qt::Key>("key");
    QTest::addColumn<Qt::KeyboardModifiers>("modifiers");
    QTest::newRow("Pause") << Qt::Key_Pause << Qt::KeyboardModifiers(Qt::NoModifier);
    QTest::newRow("Shift+Pause") << Qt::Key_Pause << Qt::KeyboardModifiers(Qt::ShiftModifier);
    QTest::newRow("Ctrl+Shift+H") << Qt::Key_H << (Qt::ControlModifier | Qt::ShiftModifier);
}

void TestMainWindow::holdByKey()
{
    QFETCH(Qt::Key, key);
    QFETCH(Qt::KeyboardModifiers, modifiers);
    Harness harness;
    QVERIFY(harness.connectLive());
    QTest::keyClick(&harness.window, key, modifiers);
    QTRY_VERIFY(harness.server->memory().status.data2 & values::Status::HeldByCommand);
}

void TestMainWindow::holdInModalDialog()
{
    Harness harness;
    QVERIFY(harness.connectLive());
    QDialog dialog(&harness.window);
    QLineEdit edit(&dialog);
    dialog.setModal(true);
    dialog.show();
    QVERIFY(QTest::qWaitForWindowActive(&dialog));
    edit.setFocus();
    QTest::keyClick(&edit, Qt::Key_Pause);
    QTRY_VERIFY(harness.server->memory().status.data2 & values::Status::HeldByCommand);
    QVERIFY(dialog.isVisible());
}

void TestMainWindow::holdFromMenu()
{
    Harness harness;
    QVERIFY(harness.connectLive());
    harness.window.actions().action(ui::ActionId::Hold)->trigger();
    QTRY_VERIFY(harness.server->memory().status.data2 & values::Status::HeldByCommand);
}

void TestMainWindow::holdWithoutLinkSaysWhyNot()
{
    Harness harness;
    harness.window.show();
    QTest::keyClick(&harness.window, Qt::Key_Pause);
    QVERIFY(harness.barText().contains(QStringLiteral("there is no connection")));
    QVERIFY(harness.bar()->message().severity == widgets::Severity::Alarm);
}

void TestMainWindow::holdWithoutAnswerIsNotConfirmed()
{
    Harness harness;
    QVERIFY(harness.connectLive());
    harness.stopController();
    QTest::keyClick(&harness.window, Qt::Key_Pause);
    QVERIFY(harness.window.controller().holdState().word == robot::HoldWord::Asked);
    QTRY_VERIFY(harness.barText().startsWith(QStringLiteral("HOLD not confirmed: use the pendant.")));
    QTRY_VERIFY(harness.barText().contains(QStringLiteral("Communication lost at")));
}

void TestMainWindow::lostAndRestored()
{
    Harness harness;
    QVERIFY(harness.connectLive());
    harness.stopController();
    QTRY_VERIFY(harness.barText().contains(QStringLiteral("showing the last values read")));
    QVERIFY(harness.value("mode")->shown().freshness == robot::Freshness::Stale);
    QVERIFY(harness.value("base1")->toolTip().startsWith(QStringLiteral("Last seen ")));
    QCOMPARE(harness.word("stripLink"), QStringLiteral("LOST"));
    QVERIFY(harness.startController());
    QTRY_VERIFY(harness.barText().startsWith(QStringLiteral("Communication restored at")));
    QTRY_VERIFY(harness.isAllLive());
    QVERIFY(!(harness.server->memory().status.data2 & values::Status::HeldByCommand)); // it only reads
}

void TestMainWindow::checkingSaysWhatIsWrong()
{
    Harness harness;
    QVERIFY(harness.startController());
    harness.stopController();
    harness.window.show();
    harness.window.connectTo(harness.profile());
    QTRY_VERIFY(harness.barText().startsWith(QStringLiteral("No contact with 127.0.0.1")));
    QCOMPARE(harness.word("mode"), QStringLiteral("—"));
    QTest::mouseClick(harness.bar()->findChild<QPushButton *>(QStringLiteral("messageLink")), Qt::LeftButton);
    QTRY_VERIFY(harness.window.findChild<QDialog *>(QStringLiteral("diagnosisDialog")));
}

void TestMainWindow::disconnectForgets()
{
    Harness harness;
    QVERIFY(harness.connectLive());
    QTest::mouseClick(harness.window.findChild<QPushButton *>(QStringLiteral("disconnectActionEntry")), Qt::LeftButton);
    QVERIFY(harness.window.controller().linkState() == LinkState::Disconnected);
    QVERIFY(overview(harness)->findChild<QWidget *>(QStringLiteral("notConnected"))->isVisible());
    QCOMPARE(harness.word("stripMode"), QStringLiteral("—"));
    QTest::mouseClick(overview(harness)->findChild<QPushButton *>(QStringLiteral("reconnectButton")), Qt::LeftButton);
    QTRY_VERIFY(harness.isAllLive());
}

void TestMainWindow::exchangesControllers()
{
    Harness harness;
    QVERIFY(harness.connectLive());
    settings::Profile other = harness.profile();
    other.name = QStringLiteral("PAINT 1");
    harness.window.connectTo(other);
    QCOMPARE(harness.word("stripName"), QStringLiteral("PAINT 1"));
    QCOMPARE(harness.word("stripMode"), QStringLiteral("—"));
    QTRY_VERIFY(harness.isAllLive());
}

void TestMainWindow::simulationMark()
{
    Harness harness;
    settings::Profile profile = harness.profile();
    harness.window.offer(profile);
    QVERIFY(!harness.window.view().findChild<QWidget *>(QStringLiteral("simulationBadge")));
    profile.isSimulation = true;
    harness.window.offer(profile);
    QVERIFY(harness.window.view().findChild<QWidget *>(QStringLiteral("simulationBadge")));
}

void TestMainWindow::shortcutsAreListed()
{
    Harness harness;
    harness.window.show();
    QVERIFY(QTest::qWaitForWindowActive(&harness.window));
    QTest::keyClick(&harness.window, Qt::Key_F1);
    QTRY_VERIFY(harness.window.findChild<QDialog *>(QStringLiteral("helpDialog")));
}

void TestMainWindow::everythingHasAName()
{
    Harness harness;
    QVERIFY(harness.connectLive());
    const auto buttons = harness.window.view().findChildren<QAbstractButton *>();
    for (const QAbstractButton *button : buttons) {
        if (qobject_cast<QLineEdit *>(button->parentWidget())) // Qt's own, to clear it
            continue;
        if (overview(harness)->isAncestorOf(button)) // see tst_accessibility
            continue;
        QVERIFY2(!button->objectName().isEmpty(), qPrintable(button->text()));
        QVERIFY(!button->text().isEmpty() || !button->accessibleName().isEmpty() || !button->isVisible());
    }
    const auto values = harness.window.view().findChildren<widgets::ValueLabel *>();
    for (const widgets::ValueLabel *value : values) {
        if (qobject_cast<const widgets::Line *>(value)) // a caption or a sentence
            continue;
        QVERIFY2(!value->objectName().isEmpty(), qPrintable(value->accessibleName()));
        QVERIFY2(!value->accessibleName().isEmpty(), qPrintable(value->objectName()));
    }
}

int main(int argc, char *argv[])
{
    QApplication application {argc, argv};
    ui::apply(application, ui::Scheme::Light);
    TestMainWindow test;
    return QTest::qExec(&test, argc, argv);
}

#include "tst_mainwindow.moc"
