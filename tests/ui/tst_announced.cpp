// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/harness.h"

#include "ui/pagecatalog.h"
#include "ui/pages/page.h"
#include "virtualcontroller/alarms.h"
#include <QAccessible>

namespace {

QStringList alerts; ///< What was said aloud, in the order it came.

void listen(QAccessibleEvent *event)
{
    if (event->type() != QAccessible::Alert)
        return;
    if (const QAccessibleInterface *speaker = event->accessibleInterface())
        alerts << speaker->text(QAccessible::Name) + u' ' + speaker->text(QAccessible::Description);
}

int countOf(const QString &words)
{
    return int(std::ranges::count_if(alerts, [&](const QString &alert) { return alert.contains(words); }));
}

} // namespace

/// What must not be missed is said aloud, whatever page or window is in use, and once.
class TestAnnounced : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init() { alerts.clear(); }
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
    QTRY_VERIFY(harness.window.view().pages()[row]->isVisible());
    values::AlarmWithTexts alarm;
    alarm.alarm.code = 4511;
    alarm.alarm.name = values::FixedText<32> {QByteArrayView {"OUT OF RANGE"}};
    virtualcontroller::raiseAlarm(harness.server->memory(), alarm, false);
    QTest::qWait(3000); qWarning() << alerts << harness.window.findChildren<QWidget*>(QStringLiteral("stripAlarm")) << harness.window.view().alarms().alarms().size();
    QTRY_COMPARE(countOf(QStringLiteral("New alarm 4511: OUT OF RANGE")), 1);
    const auto answers = [&] { return harness.window.controller().statistics().seconds.size(); };
    const auto before = answers();
    QTRY_VERIFY(answers() > before); // it is polled again and again meanwhile
    QCOMPARE(countOf(QStringLiteral("New alarm")), 1);
    harness.stopController();
    QTRY_VERIFY(harness.window.controller().linkState() == robot::LinkState::Lost);
    QTRY_VERIFY(countOf(harness.barText()) > 0);
    QVERIFY2(harness.barText().contains(QStringLiteral("lost"), Qt::CaseInsensitive), qPrintable(harness.barText()));
    QCOMPARE(countOf(harness.barText()), 1);
    QCOMPARE(countOf(QStringLiteral("New alarm")), 1);
}

int main(int argc, char *argv[])
{
    QApplication application {argc, argv};
    ui::apply(application, ui::Scheme::Light);
    QAccessible::setActive(true);
    QAccessible::installUpdateHandler(listen);
    TestAnnounced test;
    return QTest::qExec(&test, argc, argv);
}

#include "tst_announced.moc"
