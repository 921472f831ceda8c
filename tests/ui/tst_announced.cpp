// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/harness.h"

#include "ui/announcer.h"
#include "ui/pagecatalog.h"
#include "ui/pages/page.h"
#include "virtualcontroller/alarms.h"
#include <QSignalSpy>

/// What must not be missed is said aloud, whatever page or window is in use, and once. Those who speak tell what they
/// handed to QAccessible; without a screen Qt passes nothing on, and nobody could listen there.
class TestAnnounced : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void alarmAndLostLink_data();
    void alarmAndLostLink();
};

void TestAnnounced::alarmAndLostLink_data()
{
    QTest::addColumn<int>("row");
    QTest::addColumn<bool>("isInWindow");
    for (int row = 0; row < int(ui::pageCatalog().size()); ++row)
        QTest::newRow(ui::pageCatalog()[row].id) << row << false;
    QTest::newRow("a page in its own window") << 0 << true;
}

void TestAnnounced::alarmAndLostLink()
{
    QFETCH(int, row);
    QFETCH(bool, isInWindow);
    Harness harness;
    QVERIFY(harness.connectLive());
    harness.window.view().openPage(row);
    if (isInWindow)
        harness.window.view().openInWindow();
    QTRY_VERIFY(harness.window.view().page(row)->isVisible());
    QSignalSpy alarms(harness.window.view().findChild<ui::Announcer *>(), &ui::Announcer::announced);
    QSignalSpy messages(harness.bar(), &widgets::MessageBar::announced);
    values::AlarmWithTexts alarm;
    alarm.alarm.code = 4511;
    alarm.alarm.name = values::FixedText<32> {QByteArrayView {"OUT OF RANGE"}};
    virtualcontroller::raiseAlarm(harness.server->memory(), alarm, true);
    QTRY_COMPARE(alarms.size(), 1);
    QCOMPARE(alarms.first().first().toString(), QStringLiteral("New alarm 4511: OUT OF RANGE"));
    const auto *window = isInWindow ? harness.window.view().page(row)->window() : &harness.window;
    QVERIFY(std::ranges::any_of(window->findChildren<QWidget *>(QStringLiteral("stripAlarm")),
        [](const QWidget *field) { return field->accessibleDescription().contains(QStringLiteral("4511")); }));
    const auto seconds = [&] { return harness.window.controller().statistics().seconds.size(); };
    const auto before = seconds();
    QTRY_VERIFY(seconds() > before); // it is read again and again meanwhile
    harness.stopController();
    QTRY_VERIFY(harness.window.controller().linkState() == robot::LinkState::Lost);
    QTRY_VERIFY(!messages.isEmpty());
    QVERIFY(messages.last().first().toString().contains(QStringLiteral("lost"), Qt::CaseInsensitive));
    const auto said = messages.size();
    QTRY_VERIFY(harness.window.controller().statistics().lastAnswerAge > std::chrono::seconds {1});
    QCOMPARE(messages.size(), said);
    QCOMPARE(alarms.size(), 1);
}

int main(int argc, char *argv[])
{
    QApplication application {argc, argv};
    ui::apply(application, ui::Scheme::Light);
    TestAnnounced test;
    return QTest::qExec(&test, argc, argv);
}

#include "tst_announced.moc"
