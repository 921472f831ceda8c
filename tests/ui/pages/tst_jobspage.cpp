// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/jobsharness.h"
#include "ui/models/joblistmodel.h"
#include "ui/widgets/jobview.h"

#include <QAbstractItemModelTester>
#include <QComboBox>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QSignalSpy>
#include <QSpinBox>

using robot::Arming;
using robot::Level;
using values::Status;
using virtualcontroller::Direction;
using virtualcontroller::FaultKind;
using virtualcontroller::Faults;

using Way = void (*)(JobsHarness &);
using HasLeft = bool (*)(const JobsHarness &);

class TestJobsPage : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void listsTheJobs();
    void filtersAsTyped();
    void favouritesStandFirst();
    void aNewListKeepsTheSelection();
    void showsTheTextAndFollows();
    void followingChangesNoChoice();
    void outlineJumps();
    void anOldCopySaysSo();
    void aDeletedJobIsExplained();
    void jobAndRunAreTwoBoxes();
    void selectsWithLine();
    void selectsAMasterJob();
    void cycleRequestedBesideActual();
    void servoOnIsConfirmed();
    void servoOffWarnsAndDoesNotBlock();
    void holdIsReleasedWhereItWasSet();
    void pendantMessageCountsBytes_data();
    void pendantMessageCountsBytes();
    void pendantLockHasABannerEverywhere();
    void leavingWithThePendantLockedAsks_data();
    void leavingWithThePendantLockedAsks();
    void armingNeedsBoxesAndASecond();
    void everythingSaysWhyNotInMonitor();
    void tasksAreReadOnDemand();
};

void TestJobsPage::listsTheJobs()
{
    JobsHarness harness;
    QVERIFY(harness.openJobs());
    std::size_t jobs = 0;
    for (const auto &[name, content] : harness.server->memory().files)
        jobs += name.endsWith(".JBI");
    QCOMPARE(harness.list()->model()->rowCount(), int(jobs));
    QTRY_VERIFY(harness.find<widgets::JobView>("jobText")->toPlainText().startsWith(QStringLiteral("NOP")));
}

void TestJobsPage::filtersAsTyped()
{
    JobsHarness harness;
    QVERIFY(harness.openJobs());
    QTest::keyClicks(harness.find("jobFilter"), QStringLiteral("weld"));
    QCOMPARE(harness.list()->model()->rowCount(), 1);
    QTest::keyClicks(harness.find("jobFilter"), QStringLiteral("x"));
    QCOMPARE(harness.list()->model()->rowCount(), 0);
    QVERIFY(harness.find("jobListEmpty")->isVisible());
}

void TestJobsPage::favouritesStandFirst()
{
    JobsHarness harness;
    QVERIFY(harness.openJobs());
    {
        const auto tester = QAbstractItemModelTester(harness.list()->model());
        harness.choose(QStringLiteral("WELD_A12"));
        harness.click("favourite");
    }
    const auto first = [&harness] { return harness.list()->model()->index(0, 0).data().toString(); };
    QCOMPARE(first(), QStringLiteral("★ WELD_A12"));
    harness.connectAnew(); // another view of the same controller
    harness.window.view().openPage(harness.pageRow());
    // The controller is busy until it gives up the job text that the view before was reading.
    const auto isFirst = [&] {
        if (first().isEmpty() && harness.find("readJobs")->isEnabled())
            harness.click("readJobs");
        return first() == u"★ WELD_A12";
    };
    QTRY_VERIFY_WITH_TIMEOUT(isFirst(), 20000);
    harness.choose(QStringLiteral("★ WELD_A12"));
    harness.click("favourite");
    QVERIFY(first() != QStringLiteral("WELD_A12"));
}

void TestJobsPage::aNewListKeepsTheSelection()
{
    JobsHarness harness;
    QVERIFY(harness.openJobs());
    const auto tester = QAbstractItemModelTester(harness.list()->model());
    harness.choose(QStringLiteral("PALLET"));
    QSignalSpy resets {harness.list()->model(), &QAbstractItemModel::modelReset};
    const int before = harness.list()->model()->rowCount();
    harness.server->memory().files["AAA.JBI"] = "NOP\r\nEND\r\n";
    harness.server->memory().files.erase("HOME.JBI");
    harness.server->memory().files["ZZZ.JBI"] = "NOP\r\nEND\r\n";
    harness.click("readJobs");
    QTRY_COMPARE(harness.list()->model()->rowCount(), before + 1);
    QCOMPARE(harness.list()->currentIndex().data().toString(), QStringLiteral("PALLET"));
    QCOMPARE(resets.count(), 0);
}

void TestJobsPage::showsTheTextAndFollows()
{
    JobsHarness harness;
    QVERIFY(harness.openJobs());
    auto *view = harness.find<widgets::JobView>("jobText");
    harness.choose(QStringLiteral("WELD_A12"));
    QTRY_VERIFY(view->toPlainText().contains(QStringLiteral("CALL JOB:CLAMP")));
    QTRY_VERIFY(view->executingLine() == 0);
    harness.server->memory().settings.lineTime = std::chrono::milliseconds {5};
    virtualcontroller::startJob(harness.server->memory());
    QTRY_VERIFY(view->executingLine().value_or(0) > 1);
}

void TestJobsPage::followingChangesNoChoice()
{
    JobsHarness harness;
    QVERIFY(harness.openJobs());
    harness.choose(QStringLiteral("PALLET"));
    auto *view = harness.find<widgets::JobView>("jobText");
    const auto *select = harness.find<QPushButton>("select-job");
    QCOMPARE(select->text(), QStringLiteral("Select PALLET"));
    virtualcontroller::startJob(harness.server->memory()); // of WELD_A12
    QTRY_VERIFY(view->toPlainText().contains(QStringLiteral("CALL JOB:CLAMP")));
    QCOMPARE(harness.list()->currentIndex().data().toString(), QStringLiteral("PALLET"));
    QCOMPARE(select->text(), QStringLiteral("Select PALLET"));
    harness.choose(QStringLiteral("PALLET")); // again: its text
    QTRY_VERIFY(view->toPlainText().contains(QStringLiteral("*NEXT")));
}

void TestJobsPage::outlineJumps()
{
    JobsHarness harness;
    QVERIFY(harness.openJobs());
    harness.choose(QStringLiteral("PALLET"));
    auto *outline = harness.find<QListWidget>("jobOutline");
    QTRY_VERIFY(outline->count() >= 4);
    QVERIFY(outline->item(0)->text().contains(QStringLiteral("*NEXT")));
    outline->setCurrentRow(1);
    auto *view = harness.find<widgets::JobView>("jobText");
    QCOMPARE(view->textCursor().block().text(), QStringLiteral("*SECOND"));
}

void TestJobsPage::anOldCopySaysSo()
{
    JobsHarness harness;
    QVERIFY(harness.openJobs());
    harness.choose(QStringLiteral("HOME"));
    auto *view = harness.find<widgets::JobView>("jobText");
    QTRY_VERIFY(view->toPlainText().startsWith(QStringLiteral("NOP")));
    const QWidget *card = view->parentWidget();
    const auto reason = [card] { return card->findChild<QLabel *>(QStringLiteral("reason"))->text(); };
    QCOMPARE(reason(), QString());
    harness.server->memory().status.data1.setFlag(Status::Teach);
    QTRY_VERIFY(reason().contains(QStringLiteral("this copy may be old")));
    harness.server->memory().status.data1.setFlag(Status::Teach, false);
    harness.click("readJob");
    QTRY_COMPARE(reason(), QString());
}

/// Deleted between list and select.
void TestJobsPage::aDeletedJobIsExplained()
{
    JobsHarness harness;
    QVERIFY(harness.openJobs());
    harness.choose(QStringLiteral("HOME"));
    harness.server->memory().files.erase("HOME.JBI");
    QTRY_VERIFY(harness.find("select-job")->isEnabled());
    harness.click("select-job");
    const auto outcome = [&] {
        return harness.find("select-job")
            ->parentWidget()
            ->parentWidget()
            ->findChild<QLabel *>(QStringLiteral("reason"));
    };
    QTRY_VERIFY(outcome()->text().contains(QStringLiteral("0x4040")));
    QVERIFY(outcome()->text().contains(QStringLiteral("The job is not on the controller")));
    QCOMPARE(harness.server->arrived(0x87), 1);
}

void TestJobsPage::jobAndRunAreTwoBoxes()
{
    JobsHarness harness;
    QVERIFY(harness.openJobs());
    QTRY_COMPARE(harness.word("jobsJob"), QStringLiteral("WELD_A12"));
    QCOMPARE(harness.word("jobsRun"), QStringLiteral("stopped"));
    virtualcontroller::startJob(harness.server->memory());
    QTRY_COMPARE(harness.word("jobsRun"), QStringLiteral("RUNNING"));
    QCOMPARE(harness.word("jobsJob"), harness.word("stripJob"));
    QCOMPARE(harness.word("jobsRun"), harness.word("stripRun"));
}

void TestJobsPage::selectsWithLine()
{
    JobsHarness harness;
    QVERIFY(harness.openJobs(Level::Operate));
    harness.choose(QStringLiteral("PALLET"));
    harness.find<QSpinBox>("selectLine")->setValue(5);
    QTRY_VERIFY(harness.find("select-job")->isEnabled());
    harness.click("select-job");
    QTRY_COMPARE(harness.word("jobsJob"), QStringLiteral("PALLET"));
    QTRY_VERIFY(harness.word("jobsPlace").startsWith(QStringLiteral("line 5")));
    QCOMPARE(harness.server->arrived(0x87), 1);
}

void TestJobsPage::selectsAMasterJob()
{
    JobsHarness harness;
    QVERIFY(harness.openJobs(Level::Operate));
    harness.choose(QStringLiteral("PALLET"));
    harness.find<QComboBox>("selectTarget")->setCurrentIndex(1);
    QVERIFY(!harness.find("selectLine")->isVisible());
    QTRY_VERIFY(harness.find("select-master-job")->isEnabled());
    harness.click("select-master-job");
    QTRY_COMPARE(harness.server->memory().tasks[0].master, QByteArray("PALLET"));
}

void TestJobsPage::cycleRequestedBesideActual()
{
    JobsHarness harness;
    QVERIFY(harness.openJobs(Level::Operate));
    const QString before = harness.word("cycleActual");
    harness.server->setFaults(
        Faults {{{.command = 0x84, .direction = Direction::Request, .kind = FaultKind::Refuse, .code = 0x3220}}});
    harness.find<QComboBox>("cycleChoice")->setCurrentIndex(0);
    QTRY_VERIFY(harness.find("select-cycle")->isEnabled());
    harness.click("select-cycle");
    QTRY_VERIFY(harness.find("select-cycle")->isEnabled()); // refused: nothing is pending
    QCOMPARE(harness.word("cycleActual"), before);
    QVERIFY(harness.word("cycleRequested") != before);
    harness.server->setFaults(Faults {});
    harness.click("select-cycle");
    QTRY_COMPARE(harness.word("cycleActual"), harness.word("cycleRequested"));
}

void TestJobsPage::servoOnIsConfirmed()
{
    JobsHarness harness;
    QVERIFY(harness.openJobs(Level::Operate));
    harness.server->memory().status.data2.setFlag(Status::ServoOn, false);
    QTRY_COMPARE(harness.word("jobsServo"), QStringLiteral("OFF"));
    QVERIFY(!harness.find("servo-on")->isEnabled()); // not armed
    QVERIFY(harness.arm());
    harness.click("servo-on");
    auto *box = harness.find<QDialog>("servoOnBox");
    QVERIFY(box);
    QTest::keyClick(box, Qt::Key_Return); // the default is to cancel
    QTRY_VERIFY(!harness.find("servoOnBox"));
    QCOMPARE(harness.server->arrived(0x83), 0);
    harness.click("servo-on");
    harness.click("confirmServoOn");
    QTRY_COMPARE(harness.word("jobsServo"), QStringLiteral("ON"));
    QCOMPARE(harness.server->arrived(0x83), 1);
}

void TestJobsPage::servoOffWarnsAndDoesNotBlock()
{
    JobsHarness harness;
    QVERIFY(harness.openJobs(Level::Monitor));
    QVERIFY(!harness.find("servoOffWarning")->isVisibleTo(harness.page()));
    virtualcontroller::startJob(harness.server->memory());
    QTRY_VERIFY(harness.find("servoOffWarning")->isVisibleTo(harness.page()));
    QVERIFY(harness.find("servo-off")->isEnabled());
    harness.click("servo-off");
    QTRY_COMPARE(harness.word("jobsServo"), QStringLiteral("OFF"));
    QVERIFY(!harness.server->memory().status.isRunning());
}

void TestJobsPage::holdIsReleasedWhereItWasSet()
{
    JobsHarness harness;
    QVERIFY(harness.openJobs(Level::Operate));
    harness.server->memory().status.data2 |= Status::HeldByPendant;
    QTRY_VERIFY(harness.text("heldElsewhere").contains(QStringLiteral("release it there")));
    QVERIFY(!harness.find("release-hold")->isEnabled());
    QTest::keyClick(&harness.window, Qt::Key_Pause);
    QTRY_VERIFY(harness.find("release-hold")->isEnabled());
    harness.click("release-hold");
    QTRY_VERIFY(!(harness.server->memory().status.data2 & Status::HeldByCommand));
    QVERIFY(harness.server->memory().status.data2 & Status::HeldByPendant);
}

void TestJobsPage::pendantMessageCountsBytes_data()
{
    QTest::addColumn<QString>("message");
    QTest::addColumn<int>("bytes");
    QTest::addColumn<bool>("possible");
    QTest::newRow("empty") << QString() << 0 << false;
    QTest::newRow("short") << QStringLiteral("HELLO") << 5 << true;
    QTest::newRow("30") << QString(30, u'A') << 30 << true;
    QTest::newRow("31") << QString(31, u'A') << 31 << false;
    QTest::newRow("not in the encoding") << QStringLiteral("溶接") << 0 << false;
}

void TestJobsPage::pendantMessageCountsBytes()
{
    QFETCH(QString, message);
    QFETCH(int, bytes);
    QFETCH(bool, possible);
    JobsHarness harness;
    QVERIFY(harness.openJobs(Level::Operate));
    harness.find<QLineEdit>("pendantText")->setText(message);
    QVERIFY(harness.text("pendantBytes").startsWith(QStringLiteral("%1 of 30").arg(bytes)));
    QTRY_COMPARE(harness.find("pendant-text")->isEnabled(), possible);
    QCOMPARE(harness.text("reason-pendant-text").isEmpty(), possible);
    if (!possible)
        return;
    harness.click("pendant-text");
    QTRY_COMPARE(harness.server->memory().pendantText.text.bytes().toByteArray(), message.toLatin1());
}

void TestJobsPage::pendantLockHasABannerEverywhere()
{
    JobsHarness harness;
    QVERIFY(harness.openJobs());
    QVERIFY(!harness.find("lockNotice")->isVisible());
    harness.click("hlock-on");
    QTRY_VERIFY(harness.find("lockNotice")->isVisible());
    QVERIFY(harness.server->memory().interlocks.isPendantLocked);
    harness.window.view().openPage(0);
    QVERIFY(harness.find("lockNotice")->isVisible());
    QTest::mouseClick(
        harness.find("lockNotice")->findChild<QPushButton *>(QStringLiteral("messageLink")), Qt::LeftButton);
    QTRY_VERIFY(!harness.find("lockNotice")->isVisible());
    QVERIFY(!harness.server->memory().interlocks.isPendantLocked);
}

void TestJobsPage::leavingWithThePendantLockedAsks_data()
{
    QTest::addColumn<Way>("leave");
    QTest::addColumn<HasLeft>("hasLeft");
    QTest::newRow("close") << Way([](JobsHarness &harness) { harness.window.close(); })
                           << HasLeft([](const JobsHarness &harness) { return !harness.window.isVisible(); });
    QTest::newRow("disconnect") << Way([](JobsHarness &harness) {
        harness.window.actions().action(ui::ActionId::Disconnect)->trigger();
    }) << HasLeft([](const JobsHarness &harness) {
        return harness.window.controller().linkState() == robot::LinkState::Disconnected;
    });
    QTest::newRow("connect elsewhere") << Way([](JobsHarness &harness) {
        settings::Profile other = harness.profile();
        other.name = QStringLiteral("PAINT 1");
        harness.window.connectTo(other);
    }) << HasLeft([](const JobsHarness &harness) {
        return harness.window.controller().profile().name == QStringLiteral("PAINT 1");
    });
}

void TestJobsPage::leavingWithThePendantLockedAsks()
{
    QFETCH(Way, leave);
    QFETCH(HasLeft, hasLeft);
    JobsHarness harness;
    QVERIFY(harness.openJobs());
    harness.click("hlock-on");
    QTRY_VERIFY(harness.orders().isPendantLocked());
    leave(harness);
    QVERIFY(!hasLeft(harness));
    QVERIFY(harness.find("releaseLockBox"));
    harness.click("cancelButton");
    QTRY_VERIFY(!harness.find("releaseLockBox"));
    QVERIFY(!hasLeft(harness) && harness.orders().isPendantLocked());
    leave(harness);
    harness.click("releaseLock");
    QTRY_VERIFY(hasLeft(harness));
    QVERIFY(!harness.server->memory().interlocks.isPendantLocked);
}

void TestJobsPage::armingNeedsBoxesAndASecond()
{
    JobsHarness harness;
    QVERIFY(harness.openJobs(Level::Operate));
    auto *button = harness.find<QPushButton>("arm");
    QVERIFY(!button->isEnabled());
    QCOMPARE(harness.text("reason-arm"), QStringLiteral("Tick all three first."));
    QVERIFY(harness.arm());
    QVERIFY(!button->isEnabled() && button->isVisibleTo(harness.page())); // nothing changes its place
    QVERIFY(harness.find("disarm")->isEnabled());
    harness.click("disarm");
    QVERIFY(!harness.arming.isArmed());
    QVERIFY(!button->isEnabled()); // what was ticked held for one arming
    QVERIFY(harness.text("reason-arm").contains(QStringLiteral("disarmed by hand")));
    for (const char *box : {"armNobody", "armSight", "armStop"})
        harness.find<QAbstractButton>(box)->click();
    QTRY_VERIFY(button->isEnabled());
    QTest::mouseClick(button, Qt::LeftButton); // not held
    QVERIFY(!harness.arming.isArmed());
    QVERIFY(harness.arm());
    harness.server->memory().status.data1.setFlag(Status::Play, false);
    QTRY_VERIFY(!harness.arming.isArmed());
    QVERIFY(harness.orders().lastDrop()->reason == Arming::Drop::ModeChanged);
}

void TestJobsPage::everythingSaysWhyNotInMonitor()
{
    JobsHarness harness;
    QVERIFY(harness.openJobs(Level::Monitor));
    for (const char *name :
        {"select-job", "start", "release-hold", "servo-on", "select-cycle", "hlock-on", "pendant-text"}) {
        QVERIFY2(!harness.find(name)->isEnabled(), name);
        QVERIFY2(!harness.find<QPushButton>(name)->toolTip().isEmpty(), name);
        const QByteArray why = QByteArray("why-") + name;
        QVERIFY2(harness.find(why.constData())->isVisibleTo(harness.page()), name);
    }
    QVERIFY(harness.find("servo-off")->isEnabled());
}

void TestJobsPage::tasksAreReadOnDemand()
{
    JobsHarness harness;
    QVERIFY(harness.openJobs());
    QVERIFY(harness.state().freshness({robot::Kind::Job, 1}) == robot::Freshness::Unknown);
    harness.find<QPushButton>("showTasks")->click();
    QTRY_VERIFY(harness.state().freshness({robot::Kind::Job, 1}) != robot::Freshness::Unknown);
    QVERIFY(harness.value("task1")->isVisibleTo(harness.page()));
}

int main(int argc, char *argv[])
{
    QApplication application {argc, argv};
    ui::apply(application, ui::Scheme::Light);
    TestJobsPage test;
    return QTest::qExec(&test, argc, argv);
}

#include "tst_jobspage.moc"
