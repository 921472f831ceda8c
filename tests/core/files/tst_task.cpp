// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "core/files/filedesk.h"
#include "disk/durable.h"
#include "files/queue.h"

#include <QDir>
#include <QSignalSpy>
#include <QTemporaryDir>

using namespace files;
using namespace std::chrono_literals;
using values::ErrorKind;
using values::FileName;
using virtualcontroller::Faults;

namespace {

FileName fileName(const QByteArray &bytes) { return *FileName::create(bytes); }
const FileName home = fileName("HOME.JBI");

session::FilePolicy impatient()
{
    session::FilePolicy policy;
    policy.timeout = 60ms;
    policy.repeatFloor = 10ms;
    return policy;
}

Guard never()
{
    return [](QObject *, const std::function<void(const values::Result<void> &)> &handler) {
        handler(values::failure(ErrorKind::NotSent, QStringLiteral("a job runs")));
    };
}

bool write(const QString &path, const QByteArray &content) { return disk::replaceFile(path, content).has_value(); }

} // namespace

/// One file on its way, and many of them one after the other.
class TestTask : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void downloads();
    void leavesAGoodFileAlone_data();
    void leavesAGoodFileAlone();
    void uploads();
    void tellsRefusals_data();
    void tellsRefusals();
    void tellsAnUnknownOutcome();
    void judgesReadBack_data();
    void judgesReadBack();
    void deletesWithACopy();
    void deletesNothingWithoutACopy();
    void carriesFourMegabytes();
    void cancelsAtABlockBorder();
    void endsWhenDeleted();
    void queues();
    void queueRetries();
};

void TestTask::downloads()
{
    FileDesk desk;
    const QTemporaryDir folder;
    desk.files()["HOME.JBI"] = jobText("HOME", 300);
    Download task {desk.session, home, folder.filePath(QStringLiteral("HOME.JBI"))};
    const QSignalSpy progressed {&task, &Operation::progressed};
    QVERIFY(task.state() == OperationState::Waiting);
    QVERIFY(FileDesk::finish(task));
    QVERIFY(task.state() == OperationState::Done);
    QCOMPARE(disk::readFile(task.localPath()).value_or("?"), desk.files()["HOME.JBI"]);
    QVERIFY(progressed.size() > 5);
    QVERIFY(task.bytesDone() > 0);
    QVERIFY(!task.remaining()); // a controller does not tell sizes
    QVERIFY(task.record().outcome == journal::Outcome::Done);
    QCOMPARE(task.record().action, QStringLiteral("download-file"));
    QCOMPARE(task.record().subject, QStringLiteral("HOME.JBI"));
}

void TestTask::leavesAGoodFileAlone_data()
{
    QTest::addColumn<QString>("faults");
    QTest::addColumn<bool>("isFull");
    QTest::addColumn<int>("kind");
    QTest::addRow("refused") << QStringLiteral("files request refuse code=0xE2B2") << false << int(ErrorKind::Refused);
    QTest::addRow("silent in the middle")
        << QStringLiteral("files reply lose after=3") << false << int(ErrorKind::NoAnswer);
    QTest::addRow("full disk") << QString() << true << int(ErrorKind::LocalFile);
}

void TestTask::leavesAGoodFileAlone()
{
    QFETCH(QString, faults);
    QFETCH(bool, isFull);
    QFETCH(int, kind);
    FileDesk desk {*Faults::parse(faults), impatient()};
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("HOME.JBI"));
    desk.files()["HOME.JBI"] = jobText("HOME", 1000);
    QVERIFY(write(path, "good"));
    Download task {desk.session, home, path};
    {
        const FullDisk disk {isFull ? 5000 : RLIM_INFINITY};
        QVERIFY(FileDesk::finish(task));
    }
    QVERIFY(task.state() == OperationState::Failed);
    QCOMPARE(int(task.error()->kind), kind);
    QCOMPARE(disk::readFile(path).value_or("?"), "good");
    QCOMPARE(QDir {folder.path()}.entryList(QDir::Files | QDir::Hidden).size(), 1);
}

void TestTask::uploads()
{
    FileDesk desk;
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("HOME.JBI"));
    QVERIFY(write(path, jobText("HOME", 300)));
    Upload task {desk.session, home, path, always()};
    QVERIFY(FileDesk::finish(task));
    QVERIFY(task.state() == OperationState::Done && task.readBack() == ReadBack::Identical);
    QCOMPARE(desk.files()["HOME.JBI"], jobText("HOME", 300));
    QVERIFY(task.record().newValue.contains(QStringLiteral("sha256")));
    QCOMPARE(task.record().reply, QStringLiteral("read back identical"));

    Upload held {desk.session, fileName("NEW.JBI"), jobText("NEW"), never()};
    QVERIFY(FileDesk::finish(held));
    QVERIFY(held.state() == OperationState::Failed && held.error()->kind == ErrorKind::NotSent);
    QVERIFY(held.record().outcome == journal::Outcome::Withheld);
    QVERIFY(!desk.files().contains("NEW.JBI"));

    Upload missing {desk.session, home, folder.filePath(QStringLiteral("NONE.JBI")), always()};
    QVERIFY(FileDesk::finish(missing));
    QVERIFY(missing.error()->kind == ErrorKind::LocalFile);
}

void TestTask::tellsRefusals_data()
{
    QTest::addColumn<QString>("faults");
    QTest::addColumn<quint16>("code");
    QTest::addRow("remote off") << QStringLiteral("files request refuse code=0xE2B2") << quint16(0xE2B2);
    QTest::addRow("busy") << QStringLiteral("files request refuse code=0xE444") << quint16(0xE444);
    QTest::addRow("overwrite") << QStringLiteral("files request refuse code=0xE28C") << quint16(0xE28C);
    QTest::addRow("at the last block") << QStringLiteral("files request refuse after=2 code=0x5110") << quint16(0x5110);
}

void TestTask::tellsRefusals()
{
    QFETCH(QString, faults);
    QFETCH(quint16, code);
    FileDesk desk {*Faults::parse(faults), impatient()};
    Upload task {desk.session, home, jobText("HOME", 40), always()};
    QVERIFY(FileDesk::finish(task));
    QVERIFY(task.state() == OperationState::Failed);
    QVERIFY(task.error()->kind == ErrorKind::Refused);
    QCOMPARE(task.error()->addedStatus, code);
    QVERIFY(task.record().outcome == journal::Outcome::Refused);
    QCOMPARE(task.record().added, code);
}

void TestTask::tellsAnUnknownOutcome()
{
    FileDesk desk {*Faults::parse(u"files reply lose after=1"), impatient()};
    Upload task {desk.session, home, jobText("HOME"), always()};
    QVERIFY(FileDesk::finish(task));
    QVERIFY(task.error()->kind == ErrorKind::UnknownOutcome);
    QVERIFY(task.record().outcome == journal::Outcome::Unknown);
}

void TestTask::judgesReadBack_data()
{
    QTest::addColumn<QByteArray>("sent");
    QTest::addColumn<QByteArray>("received");
    QTest::addColumn<int>("readBack");
    QTest::addColumn<int>("lines");
    const auto row = [](const char *title, const char *sent, const char *received, ReadBack readBack, int lines) {
        QTest::newRow(title) << QByteArray(sent) << QByteArray(received) << int(readBack) << lines;
    };
    row("identical", "NOP\r\nEND\r\n", "NOP\r\nEND\r\n", ReadBack::Identical, 0);
    row("date", "///DATE 1\r\nNOP\r\n", "///DATE 2\r\nNOP\r\n", ReadBack::Reformatted, 1);
    row("line ends", "NOP\nEND\n", "NOP\r\nEND\r\n", ReadBack::Reformatted, 2);
    row("blanks", "MOVJ  C00000 VJ=5.00\r\n", "  MOVJ C00000  VJ=5.00\r\n", ReadBack::Reformatted, 1);
    row("blank line dropped", "NOP\r\n\r\nEND\r\n", "NOP\r\nEND\r\n", ReadBack::Reformatted, 1);
    row("another value", "V=1\r\nEND\r\n", "V=2\r\nEND\r\n", ReadBack::Different, 1);
    row("cut", "NOP\r\nEND\r\n", "NOP\r\n", ReadBack::Different, 1);
}

void TestTask::judgesReadBack()
{
    QFETCH(QByteArray, sent);
    QFETCH(QByteArray, received);
    QFETCH(int, readBack);
    QFETCH(int, lines);
    const auto judged = judgeReadBack(sent, received);
    QCOMPARE(int(judged.first), readBack);
    QCOMPARE(judged.second, lines);
}

void TestTask::deletesWithACopy()
{
    FileDesk desk;
    const QTemporaryDir folder;
    QVERIFY(write(folder.filePath(QStringLiteral("HOME.JBI")), "an older copy"));
    desk.files()["HOME.JBI"] = jobText("HOME");
    Removal task {desk.session, home, folder.path(), always()};
    QVERIFY(FileDesk::finish(task));
    QVERIFY(task.state() == OperationState::Done);
    QVERIFY(!desk.files().contains("HOME.JBI"));
    QCOMPARE(task.copy(), folder.filePath(QStringLiteral("HOME (2).JBI")));
    QCOMPARE(disk::readFile(task.copy()).value_or("?"), jobText("HOME"));
    QVERIFY(task.record().oldValue.contains(task.copy()));
}

void TestTask::deletesNothingWithoutACopy()
{
    FileDesk desk;
    desk.files()["HOME.JBI"] = jobText("HOME");
    for (const auto &[folder, guard] :
        {std::pair {QStringLiteral("/proc/none"), always()}, {QDir::tempPath(), never()}}) {
        Removal task {desk.session, home, folder, guard};
        QVERIFY(FileDesk::finish(task));
        QVERIFY(task.state() == OperationState::Failed);
        QVERIFY(desk.files().contains("HOME.JBI"));
    }
}

void TestTask::carriesFourMegabytes()
{
    FileDesk desk;
    const QTemporaryDir folder;
    const QByteArray content = "//VAR\r\n" + QByteArray(4 << 20, 'x') + "\r\n";
    Upload task {desk.session, fileName("VAR.DAT"), content, always()};
    QVERIFY(FileDesk::finish(task));
    QVERIFY(task.state() == OperationState::Done && task.readBack() == ReadBack::Identical);
    QVERIFY(desk.files()["VAR.DAT"] == content);
}

void TestTask::cancelsAtABlockBorder()
{
    FileDesk desk;
    Upload task {desk.session, home, jobText("HOME", 2000), always()};
    connect(&task, &Operation::progressed, &task, [&] { task.cancel(); });
    QVERIFY(FileDesk::finish(task));
    QVERIFY(task.state() == OperationState::Cancelled);
    QVERIFY(task.record().outcome == journal::Outcome::Cancelled);
    QVERIFY(!desk.files().contains("HOME.JBI"));

    Upload waiting {desk.session, home, jobText("HOME"), always()};
    waiting.cancel();
    QTRY_VERIFY(waiting.isOver());
    waiting.reset();
    QVERIFY(FileDesk::finish(waiting));
    QVERIFY(waiting.state() == OperationState::Done);
}

void TestTask::endsWhenDeleted()
{
    FileDesk desk;
    auto task = std::make_unique<Upload>(desk.session, home, jobText("HOME", 2000), always());
    QSignalSpy progressed {task.get(), &Operation::progressed};
    task->start();
    QVERIFY(progressed.wait());
    task.reset();
    Upload next {desk.session, fileName("NEXT.JBI"), jobText("NEXT"), always()};
    QVERIFY(FileDesk::finish(next));
    QVERIFY(next.state() == OperationState::Done);
    QVERIFY(!desk.files().contains("HOME.JBI"));
}

void TestTask::queues()
{
    FileDesk desk;
    const QTemporaryDir folder;
    desk.files()["HOME.JBI"] = jobText("HOME", 100);
    TransferQueue queue;
    QSignalSpy finished {&queue, &TransferQueue::finished};
    const auto add = [&](const char *name, auto task) {
        Q_UNUSED(name)
        queue.add(std::move(task));
    };
    add("down", std::make_unique<Download>(desk.session, home, folder.filePath(QStringLiteral("HOME.JBI"))));
    add("up", std::make_unique<Upload>(desk.session, fileName("A.JBI"), jobText("A", 100), always()));
    add("no", std::make_unique<Download>(desk.session, fileName("NO.JBI"), folder.filePath(QStringLiteral("NO.JBI"))));
    add("delete", std::make_unique<Removal>(desk.session, home, folder.filePath(QStringLiteral("copies")), always()));
    QVERIFY(queue.at(0).state() == OperationState::Running);
    QVERIFY(queue.at(1).state() == OperationState::Waiting);
    QTRY_VERIFY(queue.isIdle());
    QCOMPARE(finished.size(), 4);
    QVERIFY(queue.at(0).state() == OperationState::Done);
    QVERIFY(queue.at(1).state() == OperationState::Done);
    QVERIFY(queue.at(2).state() == OperationState::Failed);
    QVERIFY(queue.at(3).state() == OperationState::Done);
    QVERIFY(!desk.files().contains("HOME.JBI") && desk.files().contains("A.JBI"));
    queue.clearFinished();
    QCOMPARE(queue.size(), 1);
}

void TestTask::queueRetries()
{
    FileDesk desk;
    const QTemporaryDir folder;
    TransferQueue queue;
    queue.add(std::make_unique<Download>(desk.session, home, folder.filePath(QStringLiteral("HOME.JBI"))));
    queue.add(std::make_unique<Download>(desk.session, home, folder.filePath(QStringLiteral("HOME2.JBI"))));
    queue.cancel(1);
    QTRY_VERIFY(queue.isIdle());
    QVERIFY(queue.at(0).error()->kind == ErrorKind::Refused);
    QVERIFY(queue.at(1).state() == OperationState::Cancelled);
    desk.files()["HOME.JBI"] = jobText("HOME");
    queue.retryFailed();
    QTRY_VERIFY(queue.isIdle());
    QVERIFY(queue.at(0).state() == OperationState::Done && queue.at(1).state() == OperationState::Done);
}

QTEST_GUILESS_MAIN(TestTask)

#include "tst_task.moc"
