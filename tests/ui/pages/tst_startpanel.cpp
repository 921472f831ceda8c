// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/harness.h"

#include "ui/language.h"
#include "ui/pages/page.h"
#include "ui/pages/start/recenttile.h"
#include <QDialog>
#include <QDir>
#include <QPushButton>
#include <QTimeZone>

using pages::start::connectedText;
using pages::start::RecentTile;
using robot::LinkState;

namespace {

settings::Profile named(const char *name, const char *host)
{
    settings::Profile profile;
    profile.name = QString::fromUtf8(name);
    profile.host = QLatin1String(host);
    return profile;
}

QWidget *panel(const Harness &harness)
{
    for (auto *one : harness.window.view().findChildren<QWidget *>(QStringLiteral("notConnected"))) {
        if (one->isVisible())
            return one;
    }
    return nullptr;
}

QPushButton *button(const Harness &harness, const char *name)
{
    auto *one = panel(harness);
    return one ? one->findChild<QPushButton *>(QLatin1String(name)) : nullptr;
}

void picture(Harness &harness, const QString &name)
{
    QVERIFY(QDir().mkpath(QStringLiteral(PENDESK_PICTURES)));
    harness.window.setMinimumSize(1, 1); // whatever the pages behind would like to have
    for (const ui::Scheme scheme : {ui::Scheme::Dark, ui::Scheme::Light}) {
        ui::apply(*qApp, scheme);
        for (const QSize size : {QSize(1440, 900), QSize(1024, 768)}) {
            harness.window.resize(size);
            QCoreApplication::sendPostedEvents();
            const QString word = scheme == ui::Scheme::Light ? QStringLiteral("light") : QStringLiteral("dark");
            QVERIFY(harness.window.grab().save(QStringLiteral("%1/start-%2-%3-%4.png")
                                                   .arg(QStringLiteral(PENDESK_PICTURES), name)
                                                   .arg(size.width())
                                                   .arg(word)));
        }
    }
}

} // namespace

/// What one sees without a connection, and the ways from there.
class TestStartPanel : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void cleanup() { QVERIFY(ui::speak(*qApp, QStringLiteral("en"))); }

    void connectedText_data();
    void connectedText();
    void firstRunOffersThreeThings();
    void recentControllersNewestFirst();
    void atMostFive();
    void enterConnects();
    void enterOnAnotherButton();
    void anotherOneByClick();
    void lastConnectionIsKept();
    void theDemoLeavesNoTrace();
};

void TestStartPanel::connectedText_data()
{
    QTest::addColumn<QDateTime>("at");
    QTest::addColumn<QString>("text");
    const QDateTime now {{2026, 3, 2}, {0, 30}};
    QTest::newRow("never") << QDateTime() << QStringLiteral("no connection noted yet");
    QTest::newRow("today") << now.addSecs(-60) << QStringLiteral("connected today 12:29 AM");
    QTest::newRow("yesterday, an hour ago") << now.addSecs(-3600) << QStringLiteral("connected yesterday 11:30 PM");
    QTest::newRow("as UTC") << now.addSecs(-60).toUTC() << QStringLiteral("connected today 12:29 AM");
    QTest::newRow("two days ago") << now.addDays(-2) << QStringLiteral("connected 2/28/26 12:30 AM");
}

void TestStartPanel::connectedText()
{
    QFETCH(QDateTime, at);
    QFETCH(QString, text);
    QString words = ::connectedText(at, QDateTime {{2026, 3, 2}, {0, 30}});
    words.replace(QChar(0x202F), u' '); // newer locale data
    QCOMPARE(words, text);
}

void TestStartPanel::firstRunOffersThreeThings()
{
    Harness harness;
    harness.window.show();
    QVERIFY(panel(harness));
    QVERIFY(button(harness, "connectButton")->property("primary").toBool());
    QVERIFY(button(harness, "demoButton")->isVisible());
    QVERIFY(panel(harness)->findChild<QWidget *>(QStringLiteral("setupCard"))->isVisible());
    QVERIFY(panel(harness)->findChildren<RecentTile *>().isEmpty());
    picture(harness, QStringLiteral("first"));
    harness.window.activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(&harness.window));
    QTest::keyClick(&harness.window, Qt::Key_Return); // the filled one
    QTRY_VERIFY(harness.window.findChild<QDialog *>(QStringLiteral("connectionDialog")));
}

void TestStartPanel::recentControllersNewestFirst()
{
    Harness harness;
    const QDateTime now = QDateTime::currentDateTimeUtc();
    harness.store.save(named("CELL 1 · Handling", "192.168.1.11"));
    harness.store.save(named("CELL 4 · Weld", "192.168.1.31"));
    harness.store.save(named("PAINT 2", "paint2.plant.example"));
    harness.store.noteConnected(QStringLiteral("PAINT 2"), now.addSecs(-60));
    harness.store.noteConnected(QStringLiteral("CELL 4 · Weld"), now.addDays(-1));
    harness.window.offer(*harness.store.find(QStringLiteral("PAINT 2")));
    harness.window.show();
    const auto tiles = panel(harness)->findChildren<RecentTile *>();
    QCOMPARE(tiles.size(), 3);
    QVERIFY(tiles[0]->property("primary").toBool());
    QVERIFY(tiles[0]->accessibleName().startsWith(QStringLiteral("Connect to PAINT 2, paint2.plant.example")));
    QVERIFY(!tiles[1]->property("primary").toBool());
    QVERIFY(tiles[1]->accessibleName().contains(QStringLiteral("connected yesterday")));
    QVERIFY(tiles[2]->accessibleName().contains(QStringLiteral("no connection noted yet")));
    QTRY_VERIFY(tiles[2]->accessibleName().contains(QStringLiteral("No backup")));
    QVERIFY(button(harness, "connectButton")->isVisible());
    QVERIFY(button(harness, "demoButton")->isVisible());
    // Tab goes from the newest down.
    tiles[0]->setFocus();
    QTest::keyClick(tiles[0], Qt::Key_Tab);
    QVERIFY(tiles[1]->hasFocus());
    picture(harness, QStringLiteral("recent"));
    QVERIFY(ui::speak(*qApp, QStringLiteral("de")));
    harness.window.view().openPage(2); // made when it comes into view
    picture(harness, QStringLiteral("recent-de"));
}

void TestStartPanel::atMostFive()
{
    Harness harness;
    for (const char *name : {"A", "B", "C", "D", "E", "F"})
        harness.store.save(named(name, "192.168.1.1"));
    harness.window.offer(named("Z, not in the store", "192.168.1.2"));
    harness.window.show();
    const auto tiles = panel(harness)->findChildren<RecentTile *>();
    QCOMPARE(tiles.size(), 5);
    QVERIFY(tiles[0]->accessibleName().contains(QStringLiteral("Z, not in the store")));
}

void TestStartPanel::enterConnects()
{
    Harness harness;
    QVERIFY(harness.startController());
    harness.store.save(harness.profile());
    harness.store.setReadinessSeen(harness.profile().name);
    harness.window.offer(harness.profile());
    harness.window.show();
    QVERIFY(QTest::qWaitForWindowActive(&harness.window));
    QTest::keyClick(&harness.window, Qt::Key_Return);
    QTRY_VERIFY(harness.isAllLive());
    QTest::keyClick(&harness.window, Qt::Key_Return); // and does nothing else
    QVERIFY(harness.window.controller().linkState() == LinkState::Monitoring);
}

/// It presses what has the focus.
void TestStartPanel::enterOnAnotherButton()
{
    Harness harness;
    harness.window.offer(named("ELSEWHERE", "192.0.2.1"));
    harness.window.show();
    harness.window.activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(&harness.window));
    harness.window.findChild<QPushButton *>(QStringLiteral("diagnoseActionEntry"))->setFocus();
    QTest::keyClick(&harness.window, Qt::Key_Return);
    QTRY_VERIFY(harness.window.findChild<QDialog *>(QStringLiteral("diagnosisDialog")));
    QVERIFY(harness.window.controller().linkState() == LinkState::Disconnected);
}

void TestStartPanel::anotherOneByClick()
{
    Harness harness;
    QVERIFY(harness.startController());
    settings::Profile real = harness.profile();
    harness.store.save(real);
    harness.store.setReadinessSeen(real.name);
    harness.window.offer(named("ELSEWHERE", "192.0.2.1"));
    harness.window.show();
    QTest::mouseClick(button(harness, "recentButton1"), Qt::LeftButton);
    QTRY_VERIFY(harness.isAllLive());
    QCOMPARE(harness.window.controller().profile().name, real.name);
    QCOMPARE(harness.store.lastUsed(), real.name);
}

void TestStartPanel::lastConnectionIsKept()
{
    Harness harness;
    QVERIFY(harness.startController());
    harness.store.save(harness.profile());
    harness.store.setReadinessSeen(harness.profile().name);
    QVERIFY(!harness.store.recent(1).first().connected.isValid());
    QVERIFY(harness.connectLive());
    QTRY_VERIFY(harness.store.recent(1).first().connected.isValid());
    harness.window.actions().action(ui::ActionId::Disconnect)->trigger();
    QTRY_VERIFY(button(harness, "reconnectButton"));
    QVERIFY(button(harness, "reconnectButton")->accessibleName().contains(QStringLiteral("connected today")));
}

void TestStartPanel::theDemoLeavesNoTrace()
{
    Harness harness;
    QVERIFY(harness.startController());
    settings::Profile profile = harness.profile();
    profile.isSimulation = true;
    harness.window.show();
    harness.window.connectTo(profile);
    QTRY_VERIFY(harness.isAllLive());
    QVERIFY(harness.store.recent(5).isEmpty());
    harness.window.actions().action(ui::ActionId::Disconnect)->trigger();
    QTRY_VERIFY(button(harness, "reconnectButton"));
    QVERIFY(button(harness, "reconnectButton")->accessibleName().contains(QStringLiteral("simulation")));
}

int main(int argc, char *argv[])
{
    QApplication application {argc, argv};
    ui::apply(application, ui::Scheme::Light);
    QLocale::setDefault(QLocale(QLocale::English, QLocale::UnitedStates));
    TestStartPanel test;
    return QTest::qExec(&test, argc, argv);
}

#include "tst_startpanel.moc"
