// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "disk/durable.h"
#include "ui/dialogs/overwritedialog.h"
#include "ui/dialogs/restoredialog.h"
#include "ui/harness.h"
#include "ui/models/queuemodel.h"
#include "ui/pagecatalog.h"
#include "ui/pages/backuppage.h"
#include "ui/pages/filespage.h"

#include <QAbstractItemModelTester>
#include <QDialog>
#include <QDir>
#include <QListWidget>
#include <QPushButton>
#include <QSignalSpy>
#include <QTableView>
#include <QTreeWidget>

using namespace pages;

namespace {

int rowOf(const char *id)
{
    const auto rows = ui::pageCatalog();
    return int(std::ranges::find(rows, std::string_view {id}, [](const ui::PageRow &row) {
        return std::string_view {row.id};
    }) - rows.begin());
}

/// A window that shows one page, connected, with a folder of its own for the page's files.
struct Desk : Harness {
    template <typename Shown> Shown *open(const char *id)
    {
        if (!connectLive())
            return nullptr;
        window.resize(1440, 900);
        window.view().openPage(rowOf(id));
        auto *page = qobject_cast<Shown *>(window.view().page(rowOf(id)));
        QCoreApplication::processEvents();
        return page;
    }
    [[nodiscard]] QString local(const char *name) const { return files.filePath(QLatin1String(name)); }
    [[nodiscard]] std::map<QByteArray, QByteArray> &remote() const { return server->memory().files; }
    [[nodiscard]] int remoteJobs() const
    {
        return int(std::ranges::count_if(remote(), [](const auto &entry) { return entry.first.endsWith(".JBI"); }));
    }

    void picture(QWidget *widget, const char *name) const
    {
        QVERIFY(QDir().mkpath(QStringLiteral(PENDESK_PICTURES)));
        for (const ui::Scheme scheme : {ui::Scheme::Light, ui::Scheme::Dark}) {
            ui::apply(*qApp, scheme);
            QCoreApplication::sendPostedEvents();
            QVERIFY(widget->grab().save(
                QStringLiteral("%1/files-%2-%3.png")
                    .arg(QStringLiteral(PENDESK_PICTURES), QLatin1String(name),
                        scheme == ui::Scheme::Light ? QStringLiteral("light") : QStringLiteral("dark"))));
        }
        ui::apply(*qApp, ui::Scheme::Light);
    }

    QTemporaryDir files;
};

template <typename Widget> Widget *find(QWidget *parent, const char *name)
{
    return parent->findChild<Widget *>(QLatin1String(name));
}

bool choose(QListWidget *list, const QString &text)
{
    const auto items = list->findItems(text, Qt::MatchExactly);
    list->clearSelection();
    if (!items.isEmpty())
        items.first()->setSelected(true);
    return !items.isEmpty();
}

template <typename Dialog> Dialog *waitForDialog(QWidget *page, const char *name)
{
    Dialog *dialog = nullptr;
    (void)QTest::qWaitFor([&] { return (dialog = find<Dialog>(page->window(), name)) && dialog->isActiveWindow(); });
    return dialog;
}

} // namespace

/// The Files and the Backup page, against a controller on real sockets.
class TestFilePages : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void fetches();
    void asksBeforeItReplaces();
    void withholdsUploadsInMonitor();
    void sendsAndRecords();
    void backsUpAndCompares();
    void restores();
};

void TestFilePages::fetches()
{
    Desk desk;
    auto *page = desk.open<FilesPage>("files");
    QVERIFY(page);
    page->openFolder(desk.files.path());
    auto *remote = find<QListWidget>(page, "remoteFiles");
    const QAbstractItemModelTester tester(find<QTableView>(page, "transfers")->model());
    QTRY_COMPARE(remote->count(), desk.remoteJobs());
    QVERIFY(choose(remote, QStringLiteral("HOME.JBI")));
    QSignalSpy recorded {&desk.window.view().orders(), &robot::Orders::recorded};
    QTRY_VERIFY(find<QPushButton>(page, "fetchFiles")->isEnabled()); // a busy computer may lose the link for a moment
    QTest::mouseClick(find<QPushButton>(page, "fetchFiles"), Qt::LeftButton);
    QTRY_COMPARE(find<QListWidget>(page, "localFiles")->count(), 1);
    QCOMPARE(disk::readFile(desk.local("HOME.JBI")).value_or("?"), desk.remote()["HOME.JBI"]);
    QTRY_COMPARE(recorded.size(), 1);
    const auto record = recorded[0][0].value<journal::OrderRecord>();
    QCOMPARE(record.action, QStringLiteral("download"));
    QCOMPARE(record.subject, QStringLiteral("HOME.JBI"));
}

void TestFilePages::asksBeforeItReplaces()
{
    Desk desk;
    auto *page = desk.open<FilesPage>("files");
    QVERIFY(page && disk::replaceFile(desk.local("HOME.JBI"), "mine"));
    page->openFolder(desk.files.path());
    auto *remote = find<QListWidget>(page, "remoteFiles");
    QTRY_VERIFY(choose(remote, QStringLiteral("HOME.JBI")));
    QTRY_VERIFY(find<QPushButton>(page, "fetchFiles")->isEnabled()); // a busy computer may lose the link for a moment
    QTest::mouseClick(find<QPushButton>(page, "fetchFiles"), Qt::LeftButton);
    auto *dialog = waitForDialog<dialogs::OverwriteDialog>(page, "overwriteDialog");
    QVERIFY(dialog);
    desk.picture(dialog, "overwrite");
    QVERIFY(find<QPushButton>(dialog, "skip")->isDefault());
    QTest::keyClick(dialog, Qt::Key_Return); // the default
    QTRY_VERIFY(!find<dialogs::OverwriteDialog>(page->window(), "overwriteDialog"));
    QCOMPARE(disk::readFile(desk.local("HOME.JBI")).value_or("?"), "mine");
    QTRY_VERIFY(find<QPushButton>(page, "fetchFiles")->isEnabled()); // a busy computer may lose the link for a moment
    QTest::mouseClick(find<QPushButton>(page, "fetchFiles"), Qt::LeftButton);
    dialog = waitForDialog<dialogs::OverwriteDialog>(page, "overwriteDialog");
    QVERIFY(dialog);
    QTest::mouseClick(find<QPushButton>(dialog, "keepBoth"), Qt::LeftButton);
    QTRY_VERIFY(QFile::exists(desk.local("HOME (2).JBI")));
    QCOMPARE(disk::readFile(desk.local("HOME.JBI")).value_or("?"), "mine");
    QTRY_VERIFY(desk.window.controller().linkState() == robot::LinkState::Monitoring);
    desk.picture(&desk.window, "panes");
}

void TestFilePages::withholdsUploadsInMonitor()
{
    Desk desk;
    auto *page = desk.open<FilesPage>("files");
    QVERIFY(page);
    QVERIFY(!find<QPushButton>(page, "upload")->isEnabled());
    QVERIFY(!find<QPushButton>(page, "delete-file")->isEnabled());
}

void TestFilePages::sendsAndRecords()
{
    Desk desk;
    auto *page = desk.open<FilesPage>("files");
    QVERIFY(page);
    desk.server->memory().isJobRunning = false;
    desk.server->memory().status.data1.setFlag(values::Status::Running, false);
    QVERIFY(desk.window.view().orders().access().enter(robot::Level::Engineer) == robot::Access::Answer::Entered);
    const QByteArray job = QByteArray(desk.remote()["HOME.JBI"]).replace("HOME", "FRESH");
    QVERIFY(disk::replaceFile(desk.local("FRESH.JBI"), job));
    page->openFolder(desk.files.path());
    QTRY_COMPARE(find<QListWidget>(page, "remoteFiles")->count(), desk.remoteJobs());
    QTRY_VERIFY(choose(find<QListWidget>(page, "localFiles"), QStringLiteral("FRESH.JBI")));
    QSignalSpy recorded {&desk.window.view().orders(), &robot::Orders::recorded};
    QTRY_VERIFY(find<QPushButton>(page, "upload")->isEnabled());
    QTest::mouseClick(find<QPushButton>(page, "upload"), Qt::LeftButton);
    QTRY_COMPARE(desk.remote().count("FRESH.JBI"), std::size_t(1));
    QCOMPARE(desk.remote()["FRESH.JBI"], job);
    QTRY_COMPARE(recorded.size(), 1);
    const auto record = recorded[0][0].value<journal::OrderRecord>();
    QCOMPARE(record.action, QStringLiteral("upload"));
    QVERIFY(record.outcome == journal::Outcome::Done);
    QVERIFY(record.newValue.contains(QStringLiteral("sha256")));
    QTRY_VERIFY(choose(find<QListWidget>(page, "remoteFiles"), QStringLiteral("FRESH.JBI")));
    QCOMPARE(find<QListWidget>(page, "remoteFiles")->count(), desk.remoteJobs());
    QTRY_VERIFY(find<QPushButton>(page, "delete-file")->isEnabled());
    QTest::mouseClick(find<QPushButton>(page, "delete-file"), Qt::LeftButton);
    auto *box = waitForDialog<QDialog>(page, "deleteFiles");
    QVERIFY(box && desk.remote().contains("FRESH.JBI"));
    QTest::mouseClick(find<QPushButton>(box, "confirmDelete"), Qt::LeftButton);
    QTRY_VERIFY(!desk.remote().contains("FRESH.JBI"));
    QCOMPARE(disk::readFile(desk.local("deleted/FRESH.JBI")).value_or("?"), job);
}

void TestFilePages::backsUpAndCompares()
{
    Desk desk;
    auto *page = desk.open<BackupPage>("backup");
    QVERIFY(page);
    page->setRoot(desk.files.path());
    auto *timeline = find<QTreeWidget>(page, "timeline");
    auto *backUp = find<QPushButton>(page, "backUp");
    QTest::mouseClick(backUp, Qt::LeftButton);
    QTRY_COMPARE(timeline->topLevelItemCount(), 1);
    QByteArray &weld = desk.remote()["WELD_A12.JBI"];
    weld.replace("V=25.0", "V=50.0");
    desk.remote()["TOOL.CND"] += "//TOOL 2\r\n";
    QTRY_VERIFY(backUp->isEnabled());
    QTest::mouseClick(backUp, Qt::LeftButton);
    QTRY_COMPARE(timeline->topLevelItemCount(), 2);
    QTRY_COMPARE(timeline->topLevelItem(0)->text(2), QStringLiteral("2")); // changed files
    timeline->topLevelItem(0)->setSelected(true);
    QTest::mouseClick(find<QPushButton>(page, "verifyBackup"), Qt::LeftButton);
    QTRY_VERIFY(find<QLabel>(page, "backupState")->text().startsWith(QStringLiteral("Good")));
    QTest::mouseClick(find<QPushButton>(page, "compareBackups"), Qt::LeftButton);
    auto *changed = find<QTreeWidget>(page, "changedFiles");
    QTRY_COMPARE(changed->topLevelItemCount(), 2);
    changed->setCurrentItem(changed->topLevelItem(1));
    QCOMPARE(find<QLabel>(page, "edits")->text(), QStringLiteral("Line 8 MOVL: V 25.0 → 50.0"));
    QTest::mouseClick(find<QPushButton>(page, "pinBackup"), Qt::LeftButton);
    QTRY_VERIFY(timeline->topLevelItem(0)->text(3).contains(QStringLiteral("pinned")));
    desk.picture(&desk.window, "comparison");
    page->exportTo(desk.local("backup.zip"));
    QTRY_COMPARE(find<QLabel>(page, "backupState")->text(), QStringLiteral("Exported."));
    QVERIFY(disk::readFile(desk.local("backup.zip")).value_or("?").startsWith("PK"));
}

void TestFilePages::restores()
{
    Desk desk;
    auto *page = desk.open<BackupPage>("backup");
    QVERIFY(page);
    page->setRoot(desk.files.path());
    desk.server->memory().isJobRunning = false;
    desk.server->memory().status.data1.setFlag(values::Status::Running, false);
    auto *timeline = find<QTreeWidget>(page, "timeline");
    QTest::mouseClick(find<QPushButton>(page, "backUp"), Qt::LeftButton);
    QTRY_COMPARE(timeline->topLevelItemCount(), 1);
    const QByteArray weld = desk.remote()["WELD_A12.JBI"];
    desk.remote()["WELD_A12.JBI"] = QByteArray(weld).replace("V=25.0", "V=50.0");
    desk.remote().erase("TOOL.CND");
    desk.remote()["SYSTEM.SYS"] += "X\r\n";
    timeline->topLevelItem(0)->setSelected(true);
    QVERIFY(!find<QPushButton>(page, "restore")->isEnabled());
    QVERIFY(desk.window.view().orders().access().enter(robot::Level::Engineer) == robot::Access::Answer::Entered);
    QTRY_VERIFY(find<QPushButton>(page, "restore")->isEnabled());
    QTest::mouseClick(find<QPushButton>(page, "restore"), Qt::LeftButton);
    auto *dialog = waitForDialog<dialogs::RestoreDialog>(page, "restoreDialog");
    QVERIFY(dialog);
    desk.picture(dialog, "restoreplan");
    QSignalSpy recorded {&desk.window.view().orders(), &robot::Orders::recorded};
    const auto tools =
        find<QTreeWidget>(dialog, "restorePlan")->findItems(QStringLiteral("TOOL.CND"), Qt::MatchExactly);
    QCOMPARE(tools.size(), 1);
    QCOMPARE(tools.first()->checkState(0), Qt::Unchecked); // it changes how the robot moves: a person chooses it
    tools.first()->setCheckState(0, Qt::Checked);
    QTest::mouseClick(find<QPushButton>(dialog, "startRestore"), Qt::LeftButton);
    const auto *state = find<QLabel>(dialog, "restoreState");
    (void)QTest::qWaitFor([state] { return state->text().contains(QStringLiteral("2 file")); }, 20000);
    QVERIFY2(state->text().contains(QStringLiteral("2 file")), qPrintable(state->text()));
    QCOMPARE(desk.remote()["WELD_A12.JBI"], weld);
    QVERIFY(desk.remote().contains("TOOL.CND"));
    QTRY_COMPARE(recorded.size(), 2);
    QTest::mouseClick(find<QPushButton>(dialog, "closeRestore"), Qt::LeftButton);
    QTRY_COMPARE(timeline->topLevelItemCount(), 2);
}

int main(int argc, char *argv[])
{
    QApplication application {argc, argv};
    ui::apply(application, ui::Scheme::Light);
    TestFilePages test;
    return QTest::qExec(&test, argc, argv);
}

#include "tst_filepages.moc"
