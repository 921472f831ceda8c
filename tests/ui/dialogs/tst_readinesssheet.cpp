// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/harness.h"
#include "ui/widgets/question.h"
#include "ui/widgets/sheetlayer.h"

#include "ui/dialogs/readinesssheet.h"
#include "ui/readinesswords.h"
#include <QClipboard>
#include <QDir>
#include <QPushButton>
#include <QSignalSpy>

using dialogs::ReadinessSheet;
using robot::Freshness;
using robot::LinkState;
using values::Status;

namespace {

struct Desk {
    /// A real controller that the store knows, monitored.
    [[nodiscard]] bool connect(bool isSimulation = false)
    {
        if (!harness.startController())
            return false;
        settings::Profile profile = harness.profile();
        profile.isSimulation = isSimulation;
        harness.store.save(profile);
        harness.window.show();
        harness.window.connectTo(profile);
        harness.window.activateWindow();
        if (!QTest::qWaitForWindowActive(&harness.window))
            return false;
        return QTest::qWaitFor([this] { return harness.isAllLive(); });
    }
    [[nodiscard]] bool open()
    {
        harness.window.actions().action(ui::ActionId::Readiness)->trigger();
        return sheet() && QTest::qWaitForWindowExposed(sheet());
    }
    /// Over the page; one that is asked for while it lies there is deleted without having been shown.
    [[nodiscard]] ReadinessSheet *sheet() const
    {
        const auto open = widgets::SheetLayer::of(harness.window.view().window())->sheets();
        const auto found = std::ranges::find_if(open, [](auto *one) { return qobject_cast<ReadinessSheet *>(one); });
        return found == open.end() ? nullptr : qobject_cast<ReadinessSheet *>(*found);
    }
    [[nodiscard]] widgets::ValueLabel *allowance(const char *subject) const
    {
        return sheet()->findChild<widgets::ValueLabel *>(QLatin1String(subject) + QStringLiteral("Allowance"));
    }
    /// "allowed, measured"
    [[nodiscard]] QString verdict(const char *subject) const
    {
        return allowance(subject)->text() + QStringLiteral(", ") + label(subject, "Evidence");
    }
    [[nodiscard]] QString label(const char *subject, const char *part) const
    {
        return sheet()->findChild<QLabel *>(QLatin1String(subject) + QLatin1String(part))->text();
    }
    [[nodiscard]] QPushButton *button(const char *name) const
    {
        return sheet()->findChild<QPushButton *>(QLatin1String(name));
    }
    [[nodiscard]] Status &status() const { return harness.server->memory().status; }
    void picture(const QString &name) const
    {
        QVERIFY(QDir().mkpath(QStringLiteral(PENDESK_PICTURES)));
        for (const ui::Scheme scheme : {ui::Scheme::Dark, ui::Scheme::Light}) {
            ui::apply(*qApp, scheme);
            QCoreApplication::sendPostedEvents();
            const QString word = scheme == ui::Scheme::Light ? QStringLiteral("light") : QStringLiteral("dark");
            QVERIFY(sheet()->grab().save(
                QStringLiteral("%1/readiness-%2-%3.png").arg(QStringLiteral(PENDESK_PICTURES), name, word)));
        }
    }

    Harness harness;
};

} // namespace

/// What a controller allows, over real sockets.
class TestReadinessSheet : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void opensByItselfOnce();
    void neverOverADialog();
    void neverForTheDemo();
    void neverForWhoIsNotInTheStore();
    void opensOnRequest();
    void followsTheState();
    void lost();
    void refused();
    void filePortSilent();
    void disconnected();
    void readsOnlyWhileVisible();
    void copies();
    void numberingTestAndResult();
    void everyRowSpeaks();
    void everyRowSpeaksWithoutAnything();
};

void TestReadinessSheet::opensByItselfOnce()
{
    Desk desk;
    QVERIFY(desk.connect());
    QTRY_VERIFY(desk.sheet() && desk.sheet()->isVisible());
    QVERIFY(!desk.sheet()->isModal());
    const auto *hold = desk.harness.window.findChild<QAbstractButton *>(QStringLiteral("holdButton"));
    const QRect holdPlace {hold->mapToGlobal(QPoint()), hold->size()};
    QVERIFY(!QRect(desk.sheet()->mapToGlobal(QPoint()), desk.sheet()->size()).intersects(holdPlace));
    QTest::keyClick(&desk.harness.window, Qt::Key_Pause);
    QTRY_VERIFY(desk.status().data2 & Status::HeldByCommand);
    QTRY_COMPARE(desk.verdict("hold"), QStringLiteral("allowed, measured")); // it was confirmed
    desk.sheet()->close();
    QTRY_VERIFY(!desk.sheet());
    desk.harness.connectAnew();
    QTRY_VERIFY(desk.harness.isAllLive());
    QCoreApplication::processEvents();
    QVERIFY(!desk.sheet());
}

void TestReadinessSheet::neverOverADialog()
{
    Desk desk;
    desk.harness.window.show();
    widgets::ask("box", {}, {}, {}, &desk.harness.window);
    QVERIFY(desk.harness.startController());
    desk.harness.store.save(desk.harness.profile());
    desk.harness.window.connectTo(desk.harness.profile());
    QTRY_VERIFY(desk.harness.isAllLive());
    QCoreApplication::processEvents();
    QVERIFY(!desk.sheet());
    QVERIFY(!desk.harness.store.isReadinessSeen(desk.harness.profile().name)); // the next time, then
}

void TestReadinessSheet::neverForTheDemo()
{
    Desk desk;
    QVERIFY(desk.connect(true));
    QCoreApplication::processEvents();
    QVERIFY(!desk.sheet());
}

void TestReadinessSheet::neverForWhoIsNotInTheStore()
{
    Desk desk;
    QVERIFY(desk.harness.connectLive());
    QCoreApplication::processEvents();
    QVERIFY(!desk.sheet());
}

void TestReadinessSheet::opensOnRequest()
{
    Desk desk;
    QVERIFY(!desk.harness.window.actions().action(ui::ActionId::Readiness)->isEnabled()); // no controller
    QVERIFY(desk.harness.connectLive());
    desk.harness.window.activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(&desk.harness.window));
    QTest::keyClick(&desk.harness.window, Qt::Key_R, Qt::ControlModifier | Qt::ShiftModifier);
    QTRY_VERIFY(desk.sheet());
    QVERIFY(desk.sheet()->isAncestorOf(QApplication::focusWidget())); // keys go to it
    QVERIFY(desk.sheet()->windowTitle().contains(QStringLiteral("CELL 4 · Weld")));
    const ReadinessSheet *first = desk.sheet();
    QVERIFY(desk.open()); // no second one
    QCOMPARE(widgets::SheetLayer::of(&desk.harness.window)->sheets(), QList<widgets::DialogSheet *> {desk.sheet()});
    QCOMPARE(desk.sheet(), first);
    QTRY_COMPARE(desk.harness.window.findChildren<ReadinessSheet *>().size(), 1);
}

void TestReadinessSheet::followsTheState()
{
    Desk desk;
    QVERIFY(desk.harness.connectLive());
    QVERIFY(desk.open());
    QTRY_COMPARE(desk.verdict("files"), QStringLiteral("allowed, assumed"));
    QTRY_COMPARE(desk.verdict("data"), QStringLiteral("allowed, measured"));
    QCOMPARE(desk.verdict("reading"), QStringLiteral("allowed, measured"));
    QCOMPARE(desk.verdict("remote"), QStringLiteral("allowed, measured"));
    QCOMPARE(desk.verdict("overwrite"), QStringLiteral("not known, cannot be read"));
    QVERIFY(desk.label("overwrite", "Remedy").contains(QStringLiteral("RS029 and RS214")));
    QCOMPARE(desk.verdict("numbering"), QStringLiteral("not known, cannot be read"));
    QCOMPARE(desk.verdict("ranges"), QStringLiteral("not known, assumed")); // its software tells no model
    QCOMPARE(desk.verdict("hold"), QStringLiteral("allowed, assumed"));
    desk.picture(QStringLiteral("live"));
    desk.status() = {Status::Data1 {Status::Teach} | Status::Step, Status::Data2 {}};
    QTRY_COMPARE(desk.verdict("remote"), QStringLiteral("not allowed, measured"));
    QVERIFY(desk.label("remote", "Remedy").contains(QStringLiteral("CMD REMOTE SEL")));
    QCOMPARE(desk.verdict("job-start"), QStringLiteral("not allowed, measured"));
    QVERIFY(desk.label("job-start", "Remedy").contains(QStringLiteral("the person at the pendant has the robot")));
    QCOMPARE(desk.verdict("job-select"), QStringLiteral("not allowed, measured"));
    QCOMPARE(desk.verdict("servo"), QStringLiteral("not allowed, measured"));
    QCOMPARE(desk.verdict("reading"), QStringLiteral("allowed, measured"));
    desk.picture(QStringLiteral("teach"));
}

void TestReadinessSheet::lost()
{
    Desk desk;
    QVERIFY(desk.harness.connectLive());
    QVERIFY(desk.open());
    QTRY_COMPARE(desk.verdict("files"), QStringLiteral("allowed, assumed"));
    QTRY_COMPARE(desk.verdict("data"), QStringLiteral("allowed, measured"));
    desk.harness.stopController();
    QTRY_VERIFY(desk.harness.window.controller().linkState() == LinkState::Lost);
    QTRY_COMPARE(desk.verdict("reading"), QStringLiteral("not allowed, measured"));
    QVERIFY(desk.allowance("reading")->shown().freshness == Freshness::Live);
    QCOMPARE(desk.verdict("remote"), QStringLiteral("allowed, measured")); // as it was seen last
    for (const char *subject : {"remote", "job-start", "files", "hold", "data"})
        QVERIFY2(desk.allowance(subject)->shown().freshness == Freshness::Stale, subject);
    QVERIFY(desk.allowance("remote")->toolTip().startsWith(QStringLiteral("Last seen ")));
    QVERIFY(!desk.button("testNumbering")->isEnabled());
    desk.picture(QStringLiteral("stale"));
    QVERIFY(desk.harness.startController());
    QTRY_VERIFY(desk.allowance("remote")->shown().freshness == Freshness::Live);
}

void TestReadinessSheet::refused()
{
    Desk desk;
    QVERIFY(desk.harness.startController());
    std::vector<virtualcontroller::FaultRule> rules;
    for (const int command : {0x78, 0x300, 0x7A, 0x302})
        rules.push_back({.command = quint16(command),
            .direction = virtualcontroller::Direction::Request,
            .kind = virtualcontroller::FaultKind::Refuse,
            .code = 0x2110});
    desk.harness.server->setFaults(virtualcontroller::Faults {rules});
    QVERIFY(desk.harness.connectLive());
    QVERIFY(desk.open());
    QTRY_COMPARE(desk.verdict("data"), QStringLiteral("not allowed, measured"));
    QVERIFY(desk.label("data", "Sentence").contains(QStringLiteral("0x2110")));
    desk.picture(QStringLiteral("refused"));
}

void TestReadinessSheet::filePortSilent()
{
    Desk desk;
    QVERIFY(desk.harness.startController());
    settings::Profile profile = desk.harness.profile();
    profile.filePort = 9; // discard
    profile.fileTimeout = std::chrono::milliseconds {100};
    desk.harness.window.show();
    desk.harness.window.connectTo(profile);
    QTRY_VERIFY(desk.harness.isAllLive());
    QVERIFY(desk.open());
    QTRY_COMPARE(desk.verdict("files"), QStringLiteral("not allowed, measured"));
    QCOMPARE(desk.verdict("reading"), QStringLiteral("allowed, measured"));
}

void TestReadinessSheet::disconnected()
{
    Desk desk;
    QVERIFY(desk.harness.connectLive());
    QVERIFY(desk.open());
    desk.harness.window.controller().close();
    for (const char *subject : {"reading", "remote", "job-start", "files", "hold", "data", "numbering"}) {
        QCOMPARE(desk.allowance(subject)->text(), QStringLiteral("—"));
        QVERIFY2(desk.allowance(subject)->shown().freshness == Freshness::Unknown, subject);
    }
    desk.picture(QStringLiteral("disconnected"));
}

void TestReadinessSheet::readsOnlyWhileVisible()
{
    Desk desk;
    QVERIFY(desk.harness.connectLive());
    const int before = desk.harness.window.controller().poller().planSize();
    QVERIFY(desk.open());
    QVERIFY(desk.harness.window.controller().poller().planSize() > before);
    desk.sheet()->close();
    QTRY_VERIFY(!desk.sheet());
    QCOMPARE(desk.harness.window.controller().poller().planSize(), before);
}

void TestReadinessSheet::copies()
{
    Desk desk;
    QVERIFY(desk.harness.connectLive());
    QVERIFY(desk.open());
    QTRY_COMPARE(desk.verdict("files"), QStringLiteral("allowed, assumed"));
    QTest::mouseClick(desk.button("copyReadiness"), Qt::LeftButton);
    QTRY_COMPARE(desk.button("copyReadiness")->text(), QStringLiteral("Copied"));
    const QString text = QGuiApplication::clipboard()->text();
    QVERIFY(text.contains(QStringLiteral("readiness of CELL 4 · Weld (127.0.0.1")));
    QVERIFY(text.contains(QStringLiteral("Replacing files: not known, cannot be read")));
    QVERIFY(text.contains(QStringLiteral("diagnosis of CELL 4 · Weld"))); // support needs both
    QVERIFY(text.contains(QStringLiteral("File port")));
}

void TestReadinessSheet::numberingTestAndResult()
{
    Desk desk;
    QVERIFY(desk.connect());
    QVERIFY(desk.open());
    QTRY_VERIFY(desk.button("testNumbering")->isVisible());
    QTest::mouseClick(desk.button("testNumbering"), Qt::LeftButton);
    QTRY_VERIFY(desk.harness.window.findChild<QDialog *>(QStringLiteral("numberingDialog")));
    auto *dialog = desk.harness.window.findChild<QDialog *>(QStringLiteral("numberingDialog"));
    QVERIFY(QMetaObject::invokeMethod(
        dialog, "verified", Q_ARG(protocol::Numbering, protocol::Numbering::FromZero))); // what the test told
    QTRY_COMPARE(desk.verdict("numbering"), QStringLiteral("allowed, measured"));
    QVERIFY(!desk.button("testNumbering")->isVisible());
    QVERIFY(desk.harness.store.find(desk.harness.profile().name)->numberingVerified.isValid());
}

void TestReadinessSheet::everyRowSpeaks()
{
    Desk desk;
    QVERIFY(desk.harness.connectLive());
    QVERIFY(desk.open());
    for (int i = 0; i < robot::subjectCount; ++i) {
        const char *subject = robot::key(robot::Subject(i));
        QVERIFY2(!desk.allowance(subject)->accessibleName().isEmpty(), subject);
        QVERIFY2(!desk.label(subject, "Sentence").isEmpty(), subject);
        QVERIFY2(desk.allowance(subject)->shown().word.lamp != widgets::Lamp::None, subject);
    }
}

/// Whatever is known or not, a row has a sentence.
void TestReadinessSheet::everyRowSpeaksWithoutAnything()
{
    using namespace robot;
    for (const LinkState link :
        {LinkState::Disconnected, LinkState::Checking, LinkState::Monitoring, LinkState::Lost}) {
        ReadinessFacts facts;
        facts.link = link;
        for (const ReadinessRow &row : readiness(facts)) {
            QVERIFY2(!ui::sentence(row, facts).isEmpty(), key(row.subject));
            QVERIFY2(!ui::title(row.subject).isEmpty(), key(row.subject));
        }
        QVERIFY(ui::toText(readiness(facts), facts).count(u'\n') > subjectCount);
    }
}

int main(int argc, char *argv[])
{
    QApplication application {argc, argv};
    ui::apply(application, ui::Scheme::Light);
    TestReadinessSheet test;
    return QTest::qExec(&test, argc, argv);
}

#include "tst_readinesssheet.moc"
