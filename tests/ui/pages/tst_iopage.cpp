// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/pages/iopage.h"

#include "ui/room.h"
#include <QLineEdit>
#include <QTabBar>

using robot::Freshness;
using robot::LinkState;

namespace {

/// The window on its I/O page.
struct Lamps : Room {
    Lamps() : Room {"io"} { }

    [[nodiscard]] bool isLive() const override { return model() && lamp(0, 0).freshness == Freshness::Live; }
    [[nodiscard]] widgets::Table *table() const { return find<widgets::Table>("ioTable"); }
    [[nodiscard]] QTabBar *tabs() const { return find<QTabBar>("tabs"); }
    [[nodiscard]] models::IoModel *model() const { return qobject_cast<models::IoModel *>(table()->model()); }
    [[nodiscard]] models::Lamp lamp(int row, int column) const { return model()->lamp(model()->index(row, column)); }
    /// Of the station: what is watched goes on without the page.
    [[nodiscard]] robot::SignalWatch &watch() const { return harness.window.view().station()->watch; }
    [[nodiscard]] QString current() const { return toString(model()->signalAt(table()->currentIndex())); }
    [[nodiscard]] QString go(const char *words) const
    {
        auto *field = find<QLineEdit>("goTo");
        field->setText(QLatin1String(words));
        QTest::keyClick(field, Qt::Key_Return);
        return current();
    }
    /// Waits until the status, which every page needs, has been read so often.
    [[nodiscard]] bool statusIsRead(int times)
    {
        const int before = harness.server->arrived(0x72);
        return QTest::qWaitFor([this, before, times] { return harness.server->arrived(0x72) >= before + times; });
    }
};

} // namespace

class TestIoPage : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init() { QLocale::setDefault(QLocale::c()); }
    void everyAreaOfTheModelHasATab();
    void lampsFollowTheController();
    void onlyRowsInViewAreRead();
    void goesToEitherNotation();
    void networkInputsAreWritten();
    void returnInANameIsItsOwn();
    void otherLampsSayWhyNot();
    void aRefusedGroupIsSaidOnce();
    void namesAreShownAndEdited();
    void watchesSignals();
    void pictures();
};

void TestIoPage::everyAreaOfTheModelHasATab()
{
    Lamps room;
    QVERIFY(room.open());
    QCOMPARE(room.tabs()->count(), 13);
    QCOMPARE(room.model()->rowCount(), 512);
    room.tabs()->setCurrentIndex(3);
    QCOMPARE(room.tabs()->tabText(3), QStringLiteral("Network in"));
    QCOMPARE(room.current(), QStringLiteral("#27010"));
    QTRY_VERIFY(room.lamp(0, 0).freshness == Freshness::Live);
}

void TestIoPage::lampsFollowTheController()
{
    Lamps room;
    QVERIFY(room.open());
    room.tabs()->setCurrentIndex(3);
    QTRY_VERIFY(room.lamp(0, 0).freshness == Freshness::Live);
    room.memory().io[2701] = 0b100;
    QTRY_VERIFY(room.lamp(0, 2).isOn);
    QVERIFY(room.lamp(0, 2).isRecent);
    QVERIFY(!room.lamp(0, 1).isOn);
    QTRY_VERIFY(!room.lamp(0, 2).isRecent); // two seconds later
    room.harness.stopController();
    QTRY_VERIFY(room.lamp(0, 2).freshness == Freshness::Stale);
    QVERIFY(room.lamp(0, 2).isOn);
}

void TestIoPage::onlyRowsInViewAreRead()
{
    Lamps room;
    QVERIFY(room.open());
    auto topics = room.page->topics();
    QCOMPARE(topics.size(), 1);
    QCOMPARE(topics.first().first, 1);
    QVERIFY(topics.first().count() > 4 && topics.first().count() < 40);
    QCOMPARE(room.go("IN#(4096)"), QStringLiteral("#05127"));
    topics = room.page->topics();
    QCOMPARE(topics.first().last, 512);
    const int before = room.harness.server->arrived(0x300);
    QTRY_VERIFY(room.harness.server->arrived(0x300) > before);
    room.harness.window.view().openPage(0);
    QCoreApplication::processEvents();
    QVERIFY(room.statusIsRead(2)); // what is on its way arrives
    const int hidden = room.harness.server->arrived(0x300);
    QVERIFY(room.statusIsRead(10));
    QCOMPARE(room.harness.server->arrived(0x300), hidden); // a hidden page polls nothing
}

void TestIoPage::goesToEitherNotation()
{
    Lamps room;
    QVERIFY(room.open());
    QCOMPARE(room.go("#27013"), QStringLiteral("#27013"));
    QCOMPARE(room.tabs()->currentIndex(), 3);
    QCOMPARE(room.go("OT#(9)"), QStringLiteral("#10020"));
    QCOMPARE(room.go("00010"), QStringLiteral("#00010"));
    QTRY_COMPARE(room.go("clamped"), QStringLiteral("#00010")); // IONAME.DAT of the demo
    QCOMPARE(room.go("#00018"), QStringLiteral("#00010"));
    QVERIFY(room.find<QLabel>("complaint")->text().contains(QStringLiteral("0 to 7")));
}

/// Naming an input ends with Return, which must not go on to the lamp.
void TestIoPage::returnInANameIsItsOwn()
{
    Lamps room;
    QVERIFY(room.open());
    QCOMPARE(room.go("#27013"), QStringLiteral("#27013"));
    room.table()->setFocus();
    room.table()->edit(room.table()->currentIndex());
    QTRY_VERIFY(room.table()->viewport()->isAncestorOf(QApplication::focusWidget()));
    QTest::keyClicks(QApplication::focusWidget(), QStringLiteral("Clamp"));
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Return);
    QTRY_VERIFY(!room.table()->viewport()->isAncestorOf(QApplication::focusWidget()));
    QVERIFY(!room.dialog("ioWriteDialog"));
    QCOMPARE(room.lamp(0, 3).name.text, QStringLiteral("Clamp"));
}

void TestIoPage::networkInputsAreWritten()
{
    Lamps room;
    QVERIFY(room.open());
    room.memory().io[2701] = 0b1000'0000;
    QCOMPARE(room.go("#27013"), QStringLiteral("#27013"));
    QTest::keyClick(room.table(), Qt::Key_Return);
    QDialog *dialog = room.dialog("ioWriteDialog");
    QVERIFY(dialog);
    const auto label = [&](const char *name) { return dialog->findChild<QLabel *>(QLatin1String(name))->text(); };
    auto *write = dialog->findChild<QPushButton *>(QStringLiteral("write-io"));
    QTRY_VERIFY(write->isEnabled());
    QCOMPARE(label("before"), QStringLiteral("□ 0   □ 0   □ 0   □ 0   □ 0   □ 0   □ 0   ■ 1"));
    QCOMPARE(label("after"), QStringLiteral("□ 0   □ 0   □ 0   ■ 1   □ 0   □ 0   □ 0   ■ 1"));
    QCOMPARE(write->text(), QStringLiteral("Switch on"));
    for (const char *name : {"before", "after"}) { // all eight can be read
        const auto *bits = dialog->findChild<QLabel *>(QLatin1String(name));
        QVERIFY(bits->width() >= bits->fontMetrics().horizontalAdvance(bits->text()));
    }
    QVERIFY(dialog->grab().save(QStringLiteral(PENDESK_PICTURES "/io-write-dialog.png")));
    QTest::mouseClick(write, Qt::LeftButton);
    QTRY_VERIFY(label("sentence").contains(QStringLiteral("read back as it was written")));
    QCOMPARE(room.memory().io[2701], 0b1000'1000);
    QVERIFY(!write->isEnabled());
    dialog->close();
    QTRY_VERIFY(room.lamp(0, 3).isOn);
}

void TestIoPage::otherLampsSayWhyNot()
{
    Lamps room;
    QVERIFY(room.open());
    QCOMPARE(room.go("OT#(1)"), QStringLiteral("#10010"));
    QTest::keyClick(room.table(), Qt::Key_Return);
    QVERIFY(!room.dialog("ioWriteDialog"));
    QVERIFY(room.find<QLabel>("complaint")->text().contains(QStringLiteral("only network inputs")));
    QCOMPARE(room.harness.server->arrived(0x78), 0);
}

void TestIoPage::aRefusedGroupIsSaidOnce()
{
    Lamps room;
    QVERIFY(room.open());
    auto &state = room.harness.state();
    state.refuse({robot::Kind::IoGroup, 3, 4}, {values::ErrorKind::Refused, 0x1F, 0x2110, {}}, values::now());
    const QString sentence = room.find<QLabel>("sentence")->text();
    QVERIFY2(sentence.contains(QStringLiteral("2 group(s) from #00030")), qPrintable(sentence));
    QCOMPARE(sentence.count(QStringLiteral("0x2110")), 1);
}

void TestIoPage::namesAreShownAndEdited()
{
    Lamps room;
    QVERIFY(room.open());
    QTRY_COMPARE(room.lamp(0, 0).name.text, QStringLiteral("FIXTURE CLAMPED"));
    QVERIFY(!room.lamp(0, 0).name.isLocal);
    QVERIFY(room.model()->setData(room.model()->index(0, 0), QStringLiteral("Clamp 1"), Qt::EditRole));
    QVERIFY(room.lamp(0, 0).name.isLocal);
    QVERIFY(room.model()->setData(room.model()->index(0, 0), QString(), Qt::EditRole));
    QCOMPARE(room.lamp(0, 0).name.text, QStringLiteral("FIXTURE CLAMPED"));
}

void TestIoPage::watchesSignals()
{
    Lamps room;
    QVERIFY(room.open());
    robot::SignalWatch &watch = room.watch();
    watch.add({2701, 0});
    room.tabs()->setCurrentIndex(12);
    QVERIFY(room.page->topics().contains(robot::TopicRange(robot::Topic {robot::Kind::IoGroup, 2701})));
    auto *table = room.find<widgets::Table>("watchTable");
    const auto rises = [&] { return table->model()->index(0, models::WatchModel::Rises).data().toString(); };
    QTRY_VERIFY(watch.traces().first().spans.back().isOn);
    room.memory().io[2701] = 1;
    QTRY_COMPARE(rises(), QStringLiteral("1"));
    QTest::mouseClick(room.find<QPushButton>("resetCounters"), Qt::LeftButton);
    QCOMPARE(rises(), QStringLiteral("0"));
    // Kept for this controller.
    QVERIFY(!room.harness.window.view().station()->notes().read(QStringLiteral("watchedSignals")).isEmpty());
    table->setFocus();
    table->setCurrentIndex(table->model()->index(0, 0));
    QTest::keyClick(table, Qt::Key_Delete);
    QCOMPARE(table->model()->rowCount(), 0);
}

void TestIoPage::pictures()
{
    Lamps room;
    QVERIFY(room.open());
    QTRY_COMPARE(room.lamp(0, 0).name.text, QStringLiteral("FIXTURE CLAMPED"));
    room.picture(QStringLiteral("io-live-1440"));
    room.tabs()->setCurrentIndex(3);
    QTRY_VERIFY(room.lamp(0, 0).freshness == Freshness::Live);
    room.memory().io[2701] = 0b0101'0110;
    QTRY_VERIFY(room.lamp(0, 1).isOn);
    room.harness.state().refuse(
        {robot::Kind::IoGroup, 2704, 2705}, {values::ErrorKind::Refused, 0x1F, 0x2110, {}}, values::now());
    room.harness.window.resize(1024, 768);
    room.picture(QStringLiteral("io-network-1024"));
    room.harness.window.resize(1440, 900);
    robot::SignalWatch &watch = room.watch();
    for (int bit = 0; bit < 3; ++bit)
        watch.add({2701, bit});
    room.tabs()->setCurrentIndex(12);
    for (const int bits : {0, 3, 5, 2, 7}) {
        room.memory().io[2701] = quint8(bits);
        QTRY_COMPARE(int(watch.traces()[0].spans.back().isOn.value_or(false)), bits & 1);
        QVERIFY(room.statusIsRead(3)); // so long each state is in the picture
    }
    room.picture(QStringLiteral("io-watch"));
    room.tabs()->setCurrentIndex(0);
    room.harness.stopController();
    QTRY_VERIFY(room.harness.window.controller().linkState() == LinkState::Lost);
    room.picture(QStringLiteral("io-stale"));
}

int main(int argc, char *argv[])
{
    QApplication application {argc, argv};
    ui::apply(application, ui::Scheme::Light);
    TestIoPage test;
    return QTest::qExec(&test, argc, argv);
}

#include "tst_iopage.moc"
