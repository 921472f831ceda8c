// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/harness.h"

#include "robot/alarmlog.h"
#include "ui/models/activealarmmodel.h"
#include "ui/models/alarmhistorymodel.h"
#include "ui/pagecatalog.h"
#include "ui/widgets/table.h"
#include "virtualcontroller/alarms.h"
#include <QClipboard>
#include <QComboBox>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QSpinBox>
#include <QTabWidget>

using models::ActiveAlarmModel;
using models::AlarmHistoryModel;
using robot::Level;
using virtualcontroller::Direction;
using virtualcontroller::FaultKind;
using virtualcontroller::Faults;

namespace {

int alarmsRow()
{
    const auto rows = ui::pageCatalog();
    return int(std::ranges::find(rows, QLatin1String("alarms"), [](const auto &row) { return QLatin1String(row.id); })
        - rows.begin());
}

/// The window on the Alarms page.
struct Desk : Harness {
    /// Connected, with the history read, at `level`. Empty, or what did not come.
    [[nodiscard]] QString live(Level level = Level::Operate)
    {
        if (!connectLive())
            return QStringLiteral("connection");
        access().enter(level);
        window.view().openPage(alarmsRow());
        if (!QTest::qWaitFor([this] { return history()->rowCount() == 6; }, 30'000))
            return words("historyState");
        return QTest::qWaitFor([this] { return sentence() == u"No alarm is active."; }) ? QString() : sentence();
    }

    template <typename Widget> [[nodiscard]] Widget *find(const char *name) const
    {
        return window.view().findChild<Widget *>(QLatin1String(name));
    }
    [[nodiscard]] QAbstractItemModel *active() const { return find<widgets::Table>("activeAlarms")->model(); }
    [[nodiscard]] QAbstractItemModel *history() const { return find<widgets::Table>("alarmHistory")->model(); }
    [[nodiscard]] QString cell(int row, int column) const { return active()->index(row, column).data().toString(); }
    [[nodiscard]] QString past(int row, int column) const { return history()->index(row, column).data().toString(); }
    [[nodiscard]] QString words(const char *label) const { return find<QLabel>(label)->text(); }
    [[nodiscard]] QString sentence() const { return words("alarmSentence"); }
    void click(const char *button) const { QTest::mouseClick(find<QPushButton>(button), Qt::LeftButton); }
    [[nodiscard]] virtualcontroller::Memory &memory() const { return server->memory(); }

    /// Raises alarms below the major ones, so that servo power stays on.
    void raise(quint32 code, const char *name, bool hasCause = false) const
    {
        values::AlarmWithTexts alarm;
        alarm.alarm.code = code;
        alarm.alarm.name = values::FixedText<32> {QByteArrayView {name}};
        virtualcontroller::raiseAlarm(memory(), alarm, hasCause);
    }

    /// Chooses `path` in the export dialog as a person would, and waits for the file.
    [[nodiscard]] bool exportTo(const QString &path) const
    {
        auto *dialog = window.findChild<QFileDialog *>(QStringLiteral("exportDialog"));
        if (!dialog)
            return false;
        dialog->findChild<QLineEdit *>(QStringLiteral("fileNameEdit"))->setText(path);
        QMetaObject::invokeMethod(dialog, "accept");
        return QTest::qWaitFor([&] { return QFileInfo::exists(path); });
    }
};

QByteArray contents(const QString &path)
{
    QFile file {path};
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

/// Writes the window, light and dark, to the build folder.
void savePictures(QWidget &window, const QString &name)
{
    QVERIFY(QDir().mkpath(QStringLiteral(PENDESK_PICTURES)));
    for (const auto &[scheme, word] : {std::pair {ui::Scheme::Dark, "dark"}, std::pair {ui::Scheme::Light, "light"}}) {
        ui::apply(*qApp, scheme);
        QCoreApplication::sendPostedEvents();
        QVERIFY(window.grab().save(
            QStringLiteral("%1/%2-%3.png").arg(QStringLiteral(PENDESK_PICTURES), name, QLatin1String(word))));
    }
}

} // namespace

class TestAlarmsPage : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init() { QLocale::setDefault(QLocale::c()); }

    void notConnected()
    {
        Desk desk;
        desk.window.show();
        desk.window.view().openPage(alarmsRow());
        QVERIFY(desk.find<widgets::Table>("activeAlarms")->isVisible());
        QCOMPARE(desk.sentence(), QStringLiteral("Not connected: nothing is known of the active alarms."));
        QVERIFY(!desk.find<QPushButton>("reset-alarm")->isEnabled());
        QTRY_COMPARE(desk.words("historyState"), QStringLiteral("0 entry(s) in the journal, kept for ever."));
    }

    void anActiveAlarm()
    {
        Desk desk;
        QCOMPARE(desk.live(), QString());
        values::AlarmWithTexts alarm;
        alarm.alarm = {4416, {3, values::AlarmDataType::AxesSlurbt}, values::FixedText<16> {"1970/01/01 00:05"},
            values::FixedText<32> {QByteArrayView {"PULSE \x81LIMIT"}}};
        alarm.extra = values::FixedText<16> {QByteArrayView {"[SV#1]"}};
        alarm.subText = values::FixedText<96> {QByteArrayView {"S L axes"}};
        virtualcontroller::raiseAlarm(desk.memory(), alarm);
        QTRY_COMPARE(desk.active()->rowCount(), 1); // three slots are empty
        QCOMPARE(desk.cell(0, ActiveAlarmModel::State), QStringLiteral("◆ unacknowledged"));
        QCOMPARE(desk.cell(0, ActiveAlarmModel::Code), QStringLiteral("4416"));
        QCOMPARE(desk.cell(0, ActiveAlarmModel::Data), QStringLiteral("S L"));
        QCOMPARE(desk.cell(0, ActiveAlarmModel::Text), QStringLiteral("PULSE ⟨81⟩LIMIT · [SV#1] · S L axes"));
        QCOMPARE(desk.cell(0, ActiveAlarmModel::Time), QStringLiteral("1970/01/01 00:05"));
        QVERIFY(desk.cell(0, ActiveAlarmModel::FirstSeen).startsWith(u"20"));
        QCOMPARE(desk.cell(0, ActiveAlarmModel::Count), QStringLiteral("1"));
        QCOMPARE(desk.sentence(), QStringLiteral("1 alarm(s) active, the newest first."));
        QTRY_VERIFY(desk.words("resetTarget").contains(QStringLiteral("4416 PULSE ⟨81⟩LIMIT")));
        QTRY_COMPARE_WITH_TIMEOUT(desk.history()->rowCount(), 7, 30'000); // read on the edge
    }

    void acknowledgingIsLocal()
    {
        Desk desk;
        QCOMPARE(desk.live(Level::Monitor), QString());
        desk.raise(4107, "OVERRUN");
        desk.raise(4108, "OTHER");
        QTRY_COMPARE(desk.active()->rowCount(), 2);
        QVERIFY(!desk.find<QPushButton>("acknowledge")->isEnabled());
        auto *table = desk.find<widgets::Table>("activeAlarms");
        QTest::mouseClick(
            table->viewport(), Qt::LeftButton, {}, table->visualRect(table->model()->index(1, 1)).center());
        QTRY_VERIFY(desk.find<QPushButton>("acknowledge")->isEnabled());
        desk.click("acknowledge");
        QCOMPARE(desk.cell(1, ActiveAlarmModel::State), QStringLiteral("■ acknowledged"));
        QCOMPARE(desk.cell(0, ActiveAlarmModel::State), QStringLiteral("◆ unacknowledged"));
        desk.click("acknowledgeAll");
        QCOMPARE(desk.cell(0, ActiveAlarmModel::State), QStringLiteral("■ acknowledged"));
        QVERIFY(!desk.find<QPushButton>("acknowledgeAll")->isEnabled());
        QCOMPARE(desk.server->arrived(0x82), 0);
        virtualcontroller::resetAlarms(desk.memory()); // at the pendant
        QTRY_COMPARE(desk.active()->rowCount(), 0);
    }

    void clearedBeforeAnybodySawIt()
    {
        Desk desk;
        QCOMPARE(desk.live(), QString());
        desk.raise(4107, "OVERRUN");
        QTRY_COMPARE(desk.active()->rowCount(), 1);
        virtualcontroller::resetAlarms(desk.memory());
        QTRY_COMPARE(desk.cell(0, ActiveAlarmModel::State), QStringLiteral("▲ cleared, unacknowledged"));
        QCOMPARE(desk.sentence(), QStringLiteral("No alarm is active."));
        desk.click("acknowledgeAll");
        QCOMPARE(desk.active()->rowCount(), 0);
    }

    void aResetWithARemainingCauseSaysSo()
    {
        Desk desk;
        QCOMPARE(desk.live(), QString());
        desk.raise(4107, "OVERRUN", true);
        desk.raise(4108, "OTHER");
        QTRY_COMPARE(desk.active()->rowCount(), 2);
        QTRY_VERIFY(desk.find<QPushButton>("reset-alarm")->isEnabled());
        desk.click("reset-alarm");
        QTRY_VERIFY(desk.words("clearOutcome").startsWith(u"▲ Accepted, still active: remove the cause first."));
        QVERIFY(desk.words("clearOutcome").contains(u"4107 OVERRUN"));
        QVERIFY(!desk.words("clearOutcome").contains(u"4108"));
        QCOMPARE(desk.server->arrived(0x82), 1);

        virtualcontroller::removeCause(desk.memory(), 4107);
        desk.click("reset-alarm");
        QTRY_COMPARE(desk.words("clearOutcome"), QStringLiteral("Reset accepted. No alarm is active any more."));
        QCOMPARE(desk.server->arrived(0x82), 2);
        QTRY_COMPARE(desk.words("resetTarget"), QStringLiteral("There is no alarm to clear."));
    }

    void aResetThatIsRefused()
    {
        Desk desk;
        QCOMPARE(desk.live(), QString());
        desk.raise(4107, "OVERRUN");
        desk.server->setFaults(Faults {{{0x82, Direction::Request, FaultKind::Refuse, 1, 0, -1, {}, 0x2100}}});
        QTRY_COMPARE(desk.active()->rowCount(), 1);
        QTRY_VERIFY(desk.find<QPushButton>("reset-alarm")->isEnabled());
        desk.click("reset-alarm");
        QTRY_VERIFY(desk.words("clearOutcome").contains(u"0x2100"));
        QCOMPARE(desk.active()->rowCount(), 1);
    }

    void aResetThatIsNotAllowedSaysWhy()
    {
        Desk desk;
        QCOMPARE(desk.live(Level::Monitor), QString());
        desk.raise(4107, "OVERRUN");
        QTRY_COMPARE(desk.active()->rowCount(), 1);
        QVERIFY(!desk.find<QPushButton>("reset-alarm")->isEnabled());
        QVERIFY(!desk.words("reason-reset-alarm").isEmpty());
        desk.click("reset-alarm");
        QCOMPARE(desk.server->arrived(0x82), 0);
    }

    void errorAndAlarmAreTwoThings()
    {
        Desk desk;
        QCOMPARE(desk.live(), QString());
        QTRY_COMPARE(desk.words("cancelTarget"), QStringLiteral("There is no error to clear."));
        virtualcontroller::raiseError(desk.memory());
        desk.raise(4107, "OVERRUN", true);
        QTRY_COMPARE(
            desk.words("cancelTarget"), QStringLiteral("Clears the error message at the pendant, and no alarm."));
        QTRY_VERIFY(desk.find<QPushButton>("cancel-error")->isEnabled());
        desk.click("cancel-error");
        QTRY_COMPARE(desk.words("cancelTarget"), QStringLiteral("There is no error to clear."));
        QVERIFY(desk.memory().status.hasAlarm());
    }

    void refused()
    {
        Desk desk;
        QVERIFY(desk.startController());
        desk.server->setFaults(Faults {{{0x30A, Direction::Request, FaultKind::Refuse, 1, 0, -1, {}, 0x2010},
            {0x70, Direction::Request, FaultKind::Refuse, 1, 0, -1, {}, 0x2010}}});
        QVERIFY(desk.connectLive());
        desk.window.view().openPage(alarmsRow());
        QTRY_COMPARE(desk.sentence(), QStringLiteral("The controller does not tell its alarms."));
        QCOMPARE(desk.active()->rowCount(), 0);
    }

    void staleAfterTheLinkIsLost()
    {
        Desk desk;
        QCOMPARE(desk.live(), QString());
        desk.raise(4107, "OVERRUN");
        QTRY_COMPARE(desk.active()->rowCount(), 1);
        QVERIFY(!desk.active()->index(0, 1).data(widgets::HatchedRole).toBool());
        desk.stopController();
        QTRY_VERIFY(desk.active()->index(0, 1).data(widgets::HatchedRole).toBool());
        QVERIFY(desk.active()->index(0, 1).data(Qt::ToolTipRole).toString().startsWith(u"Last seen"));
        QTRY_COMPARE(desk.sentence(), QStringLiteral("1 alarm(s) active when last seen."));
        QVERIFY(!desk.find<QPushButton>("reset-alarm")->isEnabled());
    }

    void theHistoryIsFilteredAndCopied()
    {
        Desk desk;
        QCOMPARE(desk.live(), QString());
        auto *list = desk.find<QComboBox>("historyList");
        list->setCurrentText(QStringLiteral("Minor"));
        QCOMPARE(desk.history()->rowCount(), 2);
        QCOMPARE(desk.past(0, AlarmHistoryModel::Code), QStringLiteral("4416"));
        list->setCurrentIndex(0);
        QTest::keyClicks(desk.find<QLineEdit>("historySearch"), QStringLiteral("encoder"));
        QCOMPARE(desk.history()->rowCount(), 1);
        QCOMPARE(desk.past(0, AlarmHistoryModel::Code), QStringLiteral("1325"));
        desk.click("copyHistory");
        const QStringList lines = QApplication::clipboard()->text().split(u'\n', Qt::SkipEmptyParts);
        QCOMPARE(lines.size(), 2);
        QVERIFY(lines[1].startsWith(u"2026/01/09 14:22\tMajor\t1325\tS\tCOMMUNICATION ERROR(ENCODER)\t"));
        desk.find<QLineEdit>("historySearch")->clear();

        auto *table = desk.find<widgets::Table>("alarmHistory");
        table->sortByColumn(AlarmHistoryModel::Code, Qt::AscendingOrder);
        QCOMPARE(desk.past(0, AlarmHistoryModel::Code), QStringLiteral("1204"));
        QCOMPARE(desk.past(5, AlarmHistoryModel::Code), QStringLiteral("9001"));
    }

    void theHistoryIsExported()
    {
        Desk desk;
        QCOMPARE(desk.live(), QString());
        desk.find<QComboBox>("historyList")->setCurrentText(QStringLiteral("Major"));
        desk.click("exportHistory");
        const QString path = desk.folder.filePath(QStringLiteral("alarms.csv"));
        QVERIFY(desk.exportTo(path));
        QCOMPARE(contents(path).count("\r\n"), 3);
        QVERIFY(contents(path).contains("COMMUNICATION ERROR(I/O)"));
        QTRY_COMPARE(desk.words("historyExported"), QStringLiteral("2 entry(s) exported."));
    }

    void notesStayWithTheCode()
    {
        Desk desk;
        QCOMPARE(desk.live(), QString());
        auto *table = desk.find<widgets::Table>("alarmHistory");
        desk.find<QLineEdit>("historySearch")->setText(QStringLiteral("4416"));
        QTest::mouseClick(
            table->viewport(), Qt::LeftButton, {}, table->visualRect(table->model()->index(0, 2)).center());
        desk.find<QTabWidget>("historyTabs")->setCurrentIndex(2);
        QCOMPARE(desk.find<QSpinBox>("noteCode")->value(), 4416);
        QTest::keyClicks(desk.find<QPlainTextEdit>("noteCause"), QStringLiteral("limit switch"));
        QTest::keyClicks(desk.find<QPlainTextEdit>("noteRemedy"), QStringLiteral("moved it"));
        desk.click("saveNote");
        QVERIFY(!desk.find<QPushButton>("saveNote")->isEnabled());
        desk.find<QPlainTextEdit>("noteRemedy")->appendPlainText(QStringLiteral("twice"));
        desk.find<QSpinBox>("noteCode")->setValue(1325); // what was typed is kept
        QCOMPARE(desk.find<QPlainTextEdit>("noteCause")->toPlainText(), QString());
        desk.find<QSpinBox>("noteCode")->setValue(4416);
        QCOMPARE(desk.find<QPlainTextEdit>("noteRemedy")->toPlainText(), QStringLiteral("moved it\ntwice"));
        desk.click("exportNotes");
        const QString path = desk.folder.filePath(QStringLiteral("notes.json"));
        QVERIFY(desk.exportTo(path));
        QVERIFY(contents(path).contains("\"cause\":\"limit switch\""));

        desk.connectAnew(); // a new view of the same journal
        desk.window.view().openPage(alarmsRow());
        desk.find<QSpinBox>("noteCode")->setValue(4416);
        QTRY_COMPARE(desk.find<QPlainTextEdit>("noteCause")->toPlainText(), QStringLiteral("limit switch"));
    }

    void mostFrequentFirst()
    {
        Desk desk;
        QVERIFY(desk.startController());
        auto &minor = desk.memory().histories[values::AlarmHistoryClass::Minor];
        auto again = minor.front(); // 4416, 2026/01/11 10:05
        again.alarm.time = values::FixedText<16> {"2026/01/11 16:10"};
        minor.push_front(again);
        QVERIFY(desk.connectLive());
        desk.window.view().openPage(alarmsRow());
        const auto *table = desk.find<widgets::Table>("alarmStatistics");
        QTRY_COMPARE(table->model()->rowCount(), 6);
        QCOMPARE(table->model()->index(0, 0).data().toString(), QStringLiteral("4416"));
        QCOMPARE(table->model()->index(0, 2).data().toString(), QStringLiteral("2"));
        QCOMPARE(table->model()->index(0, 3).data().toString(), QStringLiteral("6 h 5 min"));
        QCOMPARE(table->model()->index(0, 4).data().toString(), QStringLiteral("2026/01/11 16:10"));
        QCOMPARE(table->model()->index(1, 3).data().toString(), QStringLiteral("—"));
    }

    /// Four alarms that change faster than they are read.
    void aFloodKeepsThePageBounded()
    {
        Desk desk;
        QCOMPARE(desk.live(), QString());
        QTimer flood;
        quint32 code = 0;
        connect(&flood, &QTimer::timeout, this, [&] {
            virtualcontroller::resetAlarms(desk.memory());
            for (int slot = 0; slot < values::activeAlarmCount; ++slot)
                desk.raise(4000 + ++code % 900, "FLOOD");
        });
        flood.start(10);
        QTRY_VERIFY_WITH_TIMEOUT(desk.active()->rowCount() > 12, 30'000);
        QVERIFY(desk.active()->rowCount() <= journal::ActiveAlarms::mostListed);
        QVERIFY(desk.state().freshness(robot::topics::status) == robot::Freshness::Live); // nothing starved
        desk.click("acknowledgeAll");
        flood.stop();
    }

    /// To be looked at, in the build folder.
    void pictures_data()
    {
        QTest::addColumn<QSize>("size");
        QTest::addColumn<int>("tab");
        QTest::newRow("large") << QSize(1440, 900) << 0;
        QTest::newRow("small") << QSize(1024, 768) << 0;
        QTest::newRow("most frequent") << QSize(1440, 900) << 1;
        QTest::newRow("notes") << QSize(1024, 768) << 2;
    }

    void pictures()
    {
        QFETCH(const QSize, size);
        QFETCH(const int, tab);
        Desk desk;
        desk.window.resize(size);
        QCOMPARE(desk.live(), QString());
        desk.raise(4107, "OUT OF RANGE(ABSO DATA)", true);
        desk.raise(4416, "PULSE \x81LIMIT(MIN/MAX)");
        QTRY_COMPARE(desk.active()->rowCount(), 2);
        desk.click("acknowledgeAll");
        desk.raise(9001, "FIXTURE NOT CLAMPED");
        QTRY_COMPARE(desk.active()->rowCount(), 3);
        QTRY_VERIFY(desk.find<QPushButton>("reset-alarm")->isEnabled());
        desk.click("reset-alarm");
        QTRY_VERIFY(desk.words("clearOutcome").startsWith(u"▲"));
        desk.find<QTabWidget>("historyTabs")->setCurrentIndex(tab);
        savePictures(desk.window, QStringLiteral("alarms-%1-%2").arg(tab).arg(size.width()));
    }

    void theJournalFails()
    {
        Desk desk;
        QCOMPARE(desk.live(), QString());
        QTRY_COMPARE(desk.journal.waitingCount(), 0);
        const QDir folder {desk.folder.path()};
        for (const QString &name : folder.entryList({QStringLiteral("journal.sqlite*")}, QDir::Files))
            QVERIFY(QFile::remove(folder.filePath(name)));
        QVERIFY(folder.mkdir(QStringLiteral("journal.sqlite"))); // no file can be made there
        desk.raise(4107, "OVERRUN");
        QTRY_COMPARE(desk.active()->rowCount(), 1); // work goes on
        const auto *bar = desk.window.findChild<widgets::MessageBar *>(QStringLiteral("journalNotice"));
        QTRY_VERIFY(bar->isVisible());
        QVERIFY(bar->message().text.startsWith(u"The journal cannot be written: "));
        QVERIFY(folder.rmdir(QStringLiteral("journal.sqlite")));
        QTRY_VERIFY(!bar->isVisible());
        QCOMPARE(desk.journal.droppedCount(), 0);
    }
};

int main(int argc, char *argv[])
{
    QApplication application {argc, argv};
    ui::apply(application, ui::Scheme::Light);
    QApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
    TestAlarmsPage test;
    return QTest::qExec(&test, argc, argv);
}

#include "tst_alarmspage.moc"
