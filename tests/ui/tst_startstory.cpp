// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/actioncatalog.h"
#include "ui/jobsharness.h"
#include "ui/widgets/filesheet.h"
#include "ui/widgets/jobview.h"

#include <QDir>
#include <QLineEdit>
#include <QPushButton>
#include <QRandomGenerator>

using robot::Level;
using values::Status;
using virtualcontroller::Direction;
using virtualcontroller::FaultKind;
using virtualcontroller::Faults;

namespace {

constexpr quint16 startCommand = 0x86;
using Open = void (*)(JobsHarness &);

/// In the scheme that is applied: changing it would stop the event loop for so long that the link is given up.
void picture(QWidget *widget, const char *name)
{
    QDir().mkpath(QStringLiteral(PENDESK_PICTURES));
    const char *scheme = ui::schemeOf(QApplication::palette()) == ui::Scheme::Light ? "light" : "dark";
    widget->grab().save(QStringLiteral("%1/jobs-%2-%3.png")
                            .arg(QStringLiteral(PENDESK_PICTURES), QLatin1String(name), QLatin1String(scheme)));
}

void closeAllButSheet(JobsHarness &harness)
{
    while (QWidget *popup = QApplication::activePopupWidget())
        popup->close();
    for (QDialog *dialog : harness.window.findChildren<QDialog *>()) {
        if (dialog != harness.sheet())
            dialog->close();
    }
    harness.window.view().openPage(harness.pageRow());
}

/// Who gets what is typed now.
QWidget *typedInto(JobsHarness &harness)
{
    if (QWidget *popup = QApplication::activePopupWidget())
        return popup;
    if (QWidget *focus = QApplication::focusWidget())
        return focus;
    return harness.sheet() ? static_cast<QWidget *>(harness.sheet()) : &harness.window;
}

} // namespace

/// Starting a job from the first click to the last, as one story and with everything that may come in between.
class TestStartStory : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void theWholeStory_data();
    void theWholeStory();
    void theSheetWaitsASecond();
    void theSheetFollowsWhatWouldStart();
    void theSheetIgnoresKeys();
    void theSheetStartsByTypedWords();
    void theModeChangesWhileTheSheetIsOpen();
    void refusalsAreExplainedInTheSheet();
    void aLostReplyEndsInTheTruth_data();
    void aLostReplyEndsInTheTruth();
    void neverTwoStartsUnderLoss();
    void holdFromEveryDialog_data();
    void holdFromEveryDialog();
    void tenThousandKeysStartNothing();
};

void TestStartStory::theWholeStory_data()
{
    QTest::addColumn<int>("scheme");
    QTest::newRow("dark") << int(ui::Scheme::Dark);
    QTest::newRow("light") << int(ui::Scheme::Light);
}

void TestStartStory::theWholeStory()
{
    QFETCH(int, scheme);
    ui::apply(*qApp, ui::Scheme(scheme));
    JobsHarness harness;
    QVERIFY(harness.openJobs(Level::Operate));
    picture(&harness.window, "1-connected");
    harness.choose(QStringLiteral("PALLET"));
    QTRY_VERIFY(harness.find("select-job")->isEnabled());
    harness.click("select-job");
    QTRY_COMPARE(harness.word("jobsJob"), QStringLiteral("PALLET"));
    QVERIFY(harness.arm());
    picture(&harness.window, "2-armed");
    const bool isSheetOpen = harness.openSheet();
    QVERIFY2(isSheetOpen, qPrintable(harness.text("reason-start")));
    picture(harness.sheet(), "3-sheet");
    QCOMPARE(harness.word("sheetController"), harness.profile().name);
    QCOMPARE(harness.word("sheetJob"), QStringLiteral("PALLET"));
    harness.click("sheetStart");
    QTRY_VERIFY(!harness.sheet()); // from now on the strip says whether it runs
    QVERIFY(harness.running());
    QCOMPARE(harness.server->arrived(startCommand), 1);
    auto *view = harness.find<widgets::JobView>("jobText");
    QTRY_VERIFY(view->executingLine().value_or(0) > 2);
    QVERIFY(harness.arming.isArmed());
    picture(&harness.window, "5-running");
    QTest::keyClick(&harness.window, Qt::Key_Pause);
    QTRY_VERIFY(!harness.server->memory().status.isRunning());
    QTRY_VERIFY(harness.find("release-hold")->isEnabled());
    picture(&harness.window, "6-held");
    harness.click("release-hold");
    QTRY_VERIFY(!(harness.server->memory().status.data2 & Status::HeldByCommand));
    QVERIFY(!harness.server->memory().status.isRunning()); // releasing starts nothing
    harness.click("servo-off");
    QTRY_COMPARE(harness.word("jobsServo"), QStringLiteral("OFF"));
    QCOMPARE(harness.server->arrived(startCommand), 1);
    picture(&harness.window, "7-servo-off");
}

void TestStartStory::theSheetWaitsASecond()
{
    JobsHarness harness;
    QVERIFY(harness.openJobs(Level::Operate));
    QVERIFY(harness.arm());
    QTRY_VERIFY(harness.find("start")->isEnabled());
    harness.click("start");
    auto *button = harness.find<QPushButton>("sheetStart");
    QVERIFY(!button->isEnabled());
    QVERIFY(!button->isDefault() && !button->autoDefault());
    QTest::mouseClick(button, Qt::LeftButton); // too early
    QCOMPARE(harness.server->arrived(startCommand), 0);
    QTRY_VERIFY(button->isEnabled());
    QCOMPARE(harness.server->arrived(startCommand), 0);
}

/// Another job is selected at the pendant while the sheet is open: the second begins again.
void TestStartStory::theSheetFollowsWhatWouldStart()
{
    JobsHarness harness;
    QVERIFY(harness.openJobs(Level::Operate));
    QVERIFY(harness.arm());
    QVERIFY(harness.openSheet());
    virtualcontroller::selectJob(harness.server->memory(), 0, "HOME", 1);
    QTRY_COMPARE(harness.word("sheetJob"), QStringLiteral("HOME"));
    QCOMPARE(harness.word("sheetLine"), QStringLiteral("1"));
    QVERIFY(!harness.find("sheetStart")->isEnabled());
    QTRY_VERIFY(harness.find("sheetStart")->isEnabled());
}

void TestStartStory::theSheetIgnoresKeys()
{
    JobsHarness harness;
    QVERIFY(harness.openJobs(Level::Operate));
    QVERIFY(harness.arm());
    QVERIFY(harness.openSheet());
    auto *button = harness.find<QPushButton>("sheetStart");
    for (const Qt::Key key : {Qt::Key_Space, Qt::Key_Return, Qt::Key_Enter, Qt::Key_Select, Qt::Key_F9})
        QTest::keyClick(button, key);
    QCOMPARE(harness.server->arrived(startCommand), 0);
}

void TestStartStory::theSheetStartsByTypedWords()
{
    JobsHarness harness;
    QVERIFY(harness.openJobs(Level::Operate));
    QVERIFY(harness.arm());
    QVERIFY(harness.openSheet());
    auto *words = harness.find<QLineEdit>("sheetWords");
    QTest::keyClicks(words, QStringLiteral("START WELD_A1"));
    QTest::keyClick(words, Qt::Key_F9);
    QCOMPARE(harness.server->arrived(startCommand), 0);
    QTest::keyClicks(words, QStringLiteral("2"));
    QKeyEvent repeat {QEvent::KeyPress, Qt::Key_F9, Qt::NoModifier, {}, true};
    QApplication::sendEvent(words, &repeat);
    QTest::keyClick(words, Qt::Key_F9, Qt::ShiftModifier);
    QCOMPARE(harness.text("sheetPhase"), QString());
    QTest::keyClick(words, Qt::Key_F9);
    QTRY_COMPARE(harness.server->arrived(startCommand), 1);
}

void TestStartStory::theModeChangesWhileTheSheetIsOpen()
{
    JobsHarness harness;
    QVERIFY(harness.openJobs(Level::Operate));
    QVERIFY(harness.arm());
    QVERIFY(harness.openSheet());
    harness.server->memory().status.data1 = Status::Data1 {Status::Teach} | Status::Continuous;
    QTRY_VERIFY(!harness.find("sheetStart")->isEnabled());
    QVERIFY(harness.find("sheetReason")->isVisible());
    QVERIFY(!harness.arming.isArmed());
    harness.server->memory().status.data1 = Status::Data1 {Status::Remote} | Status::Play | Status::Continuous;
    QTRY_VERIFY(harness.text("sheetReason").contains(QStringLiteral("not armed"))); // it does not come back by itself
    QVERIFY(!harness.find("sheetStart")->isEnabled());
}

void TestStartStory::refusalsAreExplainedInTheSheet()
{
    JobsHarness harness;
    QVERIFY(harness.openJobs(Level::Operate));
    QVERIFY(harness.arm());
    QVERIFY(harness.openSheet());
    harness.server->setFaults(Faults {
        {{.command = startCommand, .direction = Direction::Request, .kind = FaultKind::Refuse, .code = 0x3040}}});
    harness.click("sheetStart");
    QTRY_VERIFY(harness.text("sheetPhase").contains(QStringLiteral("0x3040")));
    QVERIFY(harness.text("sheetPhase").contains(QStringLiteral("confirm the position at the pendant")));
    picture(harness.sheet(), "refused");
}

void TestStartStory::aLostReplyEndsInTheTruth_data()
{
    QTest::addColumn<int>("direction");
    QTest::addColumn<bool>("runs");
    QTest::newRow("after the controller started") << int(Direction::Reply) << true;
    QTest::newRow("before it could") << int(Direction::Request) << false;
}

void TestStartStory::aLostReplyEndsInTheTruth()
{
    QFETCH(int, direction);
    QFETCH(bool, runs);
    JobsHarness harness;
    harness.servoTimeout = std::chrono::milliseconds {800};
    QVERIFY(harness.openJobs(Level::Operate));
    QVERIFY(harness.arm());
    QVERIFY(harness.openSheet());
    harness.server->setFaults(Faults {{{.command = startCommand, .direction = Direction(direction)}}});
    harness.click("sheetStart");
    const QString truth = runs ? QStringLiteral("afterwards said RUN") : QStringLiteral("afterwards said no RUN");
    QTRY_VERIFY(harness.text("sheetPhase").contains(truth));
    QVERIFY(!harness.text("sheetPhase").contains(QStringLiteral("fail")));
    QCOMPARE(harness.server->arrived(startCommand), 1);
    QCOMPARE(harness.server->memory().status.isRunning(), runs);
}

/// The story with three of ten exchanges lost. Whatever the person sees, each click of theirs arrives once at the most.
void TestStartStory::neverTwoStartsUnderLoss()
{
    for (quint32 seed = 1; seed <= 3; ++seed) {
        JobsHarness harness;
        harness.servoTimeout = std::chrono::milliseconds {800};
        QVERIFY(harness.openJobs(Level::Operate));
        harness.server->setFaults(Faults {{{.command = {}, .direction = Direction::Request, .probability = 0.163},
                                              {.command = {}, .direction = Direction::Reply, .probability = 0.163}},
            seed});
        bool isOrdered = false; // a lost link disarms, a late status disables: then the person begins again
        for (int round = 0; round < 20 && !isOrdered; ++round) {
            delete harness.sheet();
            if (!harness.arm() || !harness.openSheet())
                continue;
            harness.click("sheetStart");
            isOrdered = !harness.text("sheetPhase").isEmpty();
        }
        QVERIFY(isOrdered);
        QTRY_VERIFY_WITH_TIMEOUT(!harness.sheet() || !harness.text("sheetPhase").endsWith(u'…'), 10000);
        QVERIFY(harness.server->arrived(startCommand) <= 1);
        QTest::keyClick(&harness.window, Qt::Key_Pause);
        QTRY_VERIFY(harness.server->memory().status.data2 & Status::HeldByCommand);
        QVERIFY(harness.server->arrived(startCommand) <= 1);
    }
}

void TestStartStory::holdFromEveryDialog_data()
{
    QTest::addColumn<Open>("open");
    QTest::addColumn<QString>("dialog");
    QTest::addColumn<bool>("isMouse");
    const auto row = [](const char *dialog, Open open) {
        for (const bool isMouse : {false, true})
            QTest::addRow("%s, %s", dialog, isMouse ? "mouse" : "key")
                << open << QString::fromLatin1(dialog) << isMouse;
    };
    row("startSheet", [](JobsHarness &harness) {
        if (harness.arm())
            (void)harness.openSheet();
    });
    row("servoOnBox", [](JobsHarness &harness) {
        if (harness.arm())
            harness.click("servo-on");
    });
    row("whyNotDialog", [](JobsHarness &harness) { harness.click("why-start"); });
    row("releaseLockBox", [](JobsHarness &harness) {
        harness.click("hlock-on");
        (void)QTest::qWaitFor([&] { return harness.orders().isPendantLocked(); });
        harness.window.close();
    });
    row("accessSettingsDialog",
        [](JobsHarness &harness) { harness.window.findChild<QAction *>(QStringLiteral("accessSettings"))->trigger(); });
    row("passcodeDialog", [](JobsHarness &harness) {
        settings::AccessSettings settings;
        settings.passcode = settings::Passcode::of(QStringLiteral("1"), 1000);
        harness.access().enter(Level::Monitor);
        harness.rules.setSettings(settings);
        harness.window.findChild<QAction *>(QStringLiteral("levelOperate"))->trigger();
    });
    row("connectionDialog",
        [](JobsHarness &harness) { harness.window.actions().action(ui::ActionId::Connect)->trigger(); });
    row("helpDialog", [](JobsHarness &harness) { harness.window.actions().action(ui::ActionId::Help)->trigger(); });
    row("readinessSheet",
        [](JobsHarness &harness) { harness.window.actions().action(ui::ActionId::Readiness)->trigger(); });
    row("diagnosisDialog",
        [](JobsHarness &harness) { harness.window.actions().action(ui::ActionId::Diagnose)->trigger(); });
    row("aboutBox", [](JobsHarness &harness) { harness.window.actions().action(ui::ActionId::About)->trigger(); });
    row("appearanceDialog",
        [](JobsHarness &harness) { harness.window.actions().action(ui::ActionId::Appearance)->trigger(); });
    row("fileSheet", [](JobsHarness &harness) {
        widgets::askForPath({"path", widgets::PathKind::NewFile, QStringLiteral("?")}, harness.page(), {});
    });
}

void TestStartStory::holdFromEveryDialog()
{
    QFETCH(Open, open);
    QFETCH(QString, dialog);
    QFETCH(bool, isMouse);
    JobsHarness harness;
    QVERIFY(harness.openJobs());
    QVERIFY(QTest::qWaitForWindowExposed(&harness.window));
    open(harness);
    auto *shown = harness.window.findChild<QDialog *>(dialog);
    QVERIFY(shown);
    QVERIFY(QTest::qWaitForWindowActive(shown));
    const auto *hold = harness.window.findChild<QAbstractButton *>(QStringLiteral("holdButton"));
    if (isMouse) // to whatever lies there
        QTest::mouseClick(
            harness.window.windowHandle(), Qt::LeftButton, {}, hold->mapTo(&harness.window, hold->rect().center()));
    else
        QTest::keyClick(shown->focusWidget() ? shown->focusWidget() : shown, Qt::Key_Pause);
    QTRY_VERIFY(harness.server->memory().status.data2 & Status::HeldByCommand);
}

/// Keys that leave the controller or hold it are left out: they would make the test easier, not harder.
void TestStartStory::tenThousandKeysStartNothing()
{
    const QList<Qt::Key> keys = [] {
        QList<Qt::Key> result {Qt::Key_Space, Qt::Key_Return, Qt::Key_Enter, Qt::Key_Tab, Qt::Key_Backtab, Qt::Key_Up,
            Qt::Key_Down, Qt::Key_Left, Qt::Key_Right, Qt::Key_Escape, Qt::Key_Delete, Qt::Key_Backspace, Qt::Key_Home,
            Qt::Key_End, Qt::Key_PageUp, Qt::Key_PageDown, Qt::Key_Select, Qt::Key_Underscore};
        for (int key = Qt::Key_A; key <= Qt::Key_Z; ++key)
            result << Qt::Key(key);
        for (int key = Qt::Key_0; key <= Qt::Key_9; ++key)
            result << Qt::Key(key);
        for (int key = Qt::Key_F1; key <= Qt::Key_F12; ++key)
            result << Qt::Key(key);
        return result;
    }();
    const QList<Qt::KeyboardModifiers> modifiers {
        {}, {}, {}, Qt::ShiftModifier, Qt::ControlModifier, Qt::AltModifier, Qt::ControlModifier | Qt::ShiftModifier};
    const QSet<int> leaving {Qt::Key_Q, Qt::Key_W, Qt::Key_O, Qt::Key_R, Qt::Key_D, Qt::Key_H, Qt::Key_F1};
    constexpr int events = 10000;
    constexpr int round = 250;
    JobsHarness harness;
    QVERIFY(harness.openJobs());
    QRandomGenerator random {2026};
    int sent = 0;
    while (sent < events) {
        harness.rest();
        harness.access().enter(Level::Engineer);
        QTRY_VERIFY(harness.orders().situation().status && !harness.orders().obstacle(robot::Act::Arm));
        QVERIFY(harness.orders().arm());
        if (!harness.sheet())
            QVERIFY(harness.openSheet());
        QTRY_VERIFY(harness.find("sheetStart")->isEnabled());
        for (int i = 0; i < round; ++i) {
            const Qt::Key key = keys[random.bounded(int(keys.size()))];
            const auto modifier = modifiers[random.bounded(int(modifiers.size()))];
            ++sent;
            if (leaving.contains(key) && modifier != Qt::KeyboardModifiers {})
                continue;
            QTest::keyClick(typedInto(harness), key, modifier);
            if (!harness.sheet() && harness.find("start")->isEnabled())
                harness.click("start"); // Escape has closed it
        }
        QCOMPARE(harness.server->arrived(startCommand), 0);
        closeAllButSheet(harness);
    }
    QCOMPARE(harness.server->arrived(startCommand), 0);
    harness.rest(); // and with the pointer it would have started all along
    harness.access().enter(Level::Engineer);
    delete harness.sheet();
    QTRY_VERIFY(!harness.orders().obstacle(robot::Act::Arm));
    QVERIFY(harness.orders().arm());
    const bool isSheetOpen = harness.openSheet();
    QVERIFY2(isSheetOpen, qPrintable(harness.armingText()));
    harness.click("sheetStart");
    QTRY_COMPARE(harness.server->arrived(startCommand), 1);
}

int main(int argc, char *argv[])
{
    QApplication application {argc, argv};
    ui::apply(application, ui::Scheme::Light);
    TestStartStory test;
    return QTest::qExec(&test, argc, argv);
}

#include "tst_startstory.moc"
