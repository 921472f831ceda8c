// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "core/files/filedesk.h"
#include "disk/durable.h"
#include "files/identity.h"
#include "files/restore.h"

#include <QDir>
#include <QProcess>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <random>
#ifdef Q_OS_UNIX
#include <csignal>
#endif

using namespace files;
using namespace std::chrono_literals;
using values::ErrorKind;
using values::FileName;
using virtualcontroller::Faults;

namespace {

FileName fileName(const QByteArray &bytes) { return *FileName::create(bytes); }

BackupOrder orderFor(const QString &root)
{
    BackupOrder order;
    order.root = root;
    order.info.controller = QStringLiteral("CELL 4");
    order.info.host = QStringLiteral("127.0.0.1");
    order.info.model = QStringLiteral("YRC1000");
    return order;
}

session::FilePolicy quick()
{
    session::FilePolicy policy;
    policy.timeout = 400ms;
    policy.repeatFloor = 4ms;
    policy.busyLeast = 5ms;
    policy.busyMost = 20ms;
    policy.idLinger = 30ms; // nothing is late here
    return policy;
}

QByteArray randomBytes(std::mt19937 &random, qsizetype size)
{
    QByteArray bytes(size, '\0');
    for (char &byte : bytes)
        byte = char(random());
    return bytes;
}

/// Without control characters, which no file to be loaded has.
QByteArray textOf(QByteArray bytes)
{
    for (char &byte : bytes)
        byte = char(0x20 + quint8(byte) % 0xE0);
    return bytes;
}

/// Files of every type and size: jobs, text, bytes of all values, one byte, whole blocks, names of all sorts.
std::map<QByteArray, QByteArray> manyFiles(int count)
{
    std::mt19937 random {5};
    const QByteArrayList types {"JBI", "DAT", "CND", "PRM", "SYS", "LST"};
    const qsizetype sizes[] {1, 479, 480, 958, 100, 2000};
    std::map<QByteArray, QByteArray> files;
    for (int number = 0; number < count; ++number) {
        const QByteArray base = number % 50 == 0 ? "\x83\x65" + QByteArray::number(number)
            : number % 50 == 1                   ? "a b" + QByteArray::number(number)
                                                 : "FILE" + QByteArray::number(number);
        const QByteArray &type = types[number % 6];
        const QByteArray bytes = randomBytes(random, sizes[number % 5]);
        files[base + '.' + type] = type == "JBI" ? jobText(base, int(random() % 40))
            : type == "SYS"                      ? bytes
                                                 : "//" + textOf(bytes);
    }
    return files;
}

std::map<QByteArray, QByteArray> contentsOf(const FileSet &set)
{
    std::map<QByteArray, QByteArray> contents;
    for (const auto &[name, hash] : set.hashes)
        contents[name.bytes()] = set.content(name).value_or("?");
    return contents;
}

Guard refusing(const bool &mayChange)
{
    return [&mayChange](QObject *, const std::function<void(const values::Result<void> &)> &handler) {
        if (mayChange)
            handler({});
        else
            handler(values::failure(ErrorKind::NotSent, QStringLiteral("a job runs")));
    };
}

/// How often a test kills a process: more often once a day (tests/daily).
int kills()
{
    const int wanted = qEnvironmentVariableIntValue("PENDESK_KILLS");
    return wanted > 0 ? wanted : 12;
}

/// A backup in `root` of what the desk holds now; its files.
FileSet backedUp(FileDesk &desk, const QString &root)
{
    Backup backup {desk.session, orderFor(root)};
    if (!FileDesk::finish(backup) || backup.state() != OperationState::Done)
        return {};
    return Bag::open(backup.path())->files();
}

QList<RestoreItem> planFor(FileDesk &desk, const FileSet &bag)
{
    Snapshot snapshot {desk.session};
    return FileDesk::finish(snapshot) ? planRestore(bag, snapshot.files()) : QList<RestoreItem> {};
}

} // namespace

/// Whole controllers to disk and back.
class TestBackup : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void keepsAThousandFiles_data();
    void keepsAThousandFiles();
    void goesOnAfterRefusals();
    void keepsOddFiles();
    void waitsWhileBusy();
    void goesOnWithoutWhatVanished();
    void meetsBadLists_data();
    void meetsBadLists();
    void meetsAListBrokenInAName();
    void endsWithoutABag_data();
    void endsWithoutABag();
    void waitsForNobody();
    void letsGoOfOldOnes();
    void isCancelled();
    void survivesKills();
    void plans_data();
    void plans();
    void restoresWhatChanged();
    void restoresNothingSpoilt();
    void readsInOrder();
    void goesOnAfterARefusedFile();
    void plansInOrder();
    void tellsRobotsApart_data();
    void tellsRobotsApart();
    void neverRestoresWhileAJobRuns();
    void noticesThatThePlanIsOld();
};

void TestBackup::keepsAThousandFiles_data()
{
    QTest::addColumn<QString>("faults");
    QTest::addColumn<int>("count");
    QTest::addRow("good network") << QString() << 1000;
    QTest::addRow("10 %% loss") << QStringLiteral("seed=3; any request lose p=0.05; any reply lose p=0.05") << 200;
    QTest::addRow("2,000 files") << QString() << 2000;
}

void TestBackup::keepsAThousandFiles()
{
    QFETCH(QString, faults);
    QFETCH(int, count);
    FileDesk desk {*Faults::parse(faults), quick()};
    const QTemporaryDir root;
    desk.files() = manyFiles(count);
    const FileSet set = backedUp(desk, root.path());
    const Archive archive {root.path(), QStringLiteral("CELL 4")};
    const auto bag = archive.entries().value(0);
    QCOMPARE(bag.files + bag.failures, count);
    QCOMPARE(bag.failures, 0);
    for (const auto &[name, content] : contentsOf(set))
        QVERIFY2(desk.files()[name] == content, name);
    QVERIFY(verify(bag.path).isGood());
    if (count > 1000)
        return;
    // And back again, into an empty controller. A person tries once more where the outcome is unknown.
    const auto before = std::exchange(desk.files(), {});
    for (const auto &[name, hash] : set.hashes) {
        if (!mayBeSent(preflight(name, *set.content(name))))
            continue;
        Upload upload {desk.session, name, *set.content(name), always()};
        do {
            upload.reset();
            QVERIFY(FileDesk::finish(upload));
        } while (upload.error() && upload.error()->kind != ErrorKind::Refused);
        QVERIFY2(upload.readBack() == ReadBack::Identical, name.bytes());
        QCOMPARE(desk.files()[name.bytes()], before.at(name.bytes()));
    }
    QVERIFY(int(desk.files().size()) > count * 8 / 10);
}

void TestBackup::goesOnAfterRefusals()
{
    FileDesk desk;
    const QTemporaryDir root;
    desk.files() = {{"A.JBI", jobText("A")}, {"EMPTY.DAT", ""}, {"B.PRM", "//PRM\r\n"}};
    Backup backup {desk.session, orderFor(root.path())};
    QVERIFY(FileDesk::finish(backup));
    QVERIFY(backup.state() == OperationState::Done);
    QCOMPARE(backup.filesDone(), 3);
    QCOMPARE(backup.filesTotal(), 3);
    QCOMPARE(backup.info().failures(), 1);
    const auto bag = Bag::open(backup.path());
    QVERIFY(bag && verify(backup.path()).isGood());
    QVERIFY(bag->files().unread.contains(fileName("EMPTY.DAT")));
    QVERIFY(
        bag->info().results.contains(FileResult {"EMPTY.DAT", values::Error {ErrorKind::Refused, 0x1F, 0xE29C, {}}}));
    QCOMPARE(bag->info().model, QStringLiteral("YRC1000"));
}

/// Names that other file systems cannot carry or tell apart, and all line ends.
void TestBackup::keepsOddFiles()
{
    FileDesk desk;
    const QTemporaryDir root;
    const QByteArray job = jobText("A");
    desk.files() = {{"CON.JBI", job}, {"A..JBI", job}, {"WELD.JBI", "1"}, {"weld.JBI", "2"}, {"Weld.JBI", "3"},
        {"\x83\x65.JBI", job}, {QByteArray(32, 'N') + ".JBI", job}, {"100%.JBI", job}, {"A:B.DAT", "//A\r\n"},
        {"LF.JBI", QByteArray(job).replace("\r\n", "\n")}, {"CUT.JBI", job.chopped(2)}, {"HALF.JBI", job.chopped(1)},
        {"CR.DAT", "//A\rB\r"}, {"BLANKS.DAT", "//A \t\r\n\r\n\r\n"}};
    const FileSet set = backedUp(desk, root.path());
    for (const auto &[name, content] : desk.files())
        QVERIFY2(contentsOf(set)[name] == content, name);
    QCOMPARE(set.hashes.size(), desk.files().size());
    QVERIFY(verify(Archive(root.path(), QStringLiteral("CELL 4")).entries().value(0).path).isGood());
}

void TestBackup::waitsWhileBusy()
{
    FileDesk desk {*Faults::parse(u"files request refuse code=0xE444 after=9 times=4"), quick()};
    const QTemporaryDir root;
    desk.files() = manyFiles(20);
    QVERIFY(contentsOf(backedUp(desk, root.path())) == desk.files());
}

void TestBackup::goesOnWithoutWhatVanished()
{
    FileDesk desk;
    const QTemporaryDir root;
    desk.files() = {{"A.JBI", jobText("A")}, {"B.JBI", jobText("B")}, {"C.JBI", jobText("C")}};
    Backup backup {desk.session, orderFor(root.path())};
    connect(&backup, &Operation::progressed, this, [&] { desk.files().erase("B.JBI"); });
    QVERIFY(FileDesk::finish(backup));
    QVERIFY(backup.state() == OperationState::Done);
    const auto bag = Bag::open(backup.path());
    QVERIFY(contentsOf(bag->files()) == desk.files());
    QVERIFY(bag->files().unread == std::set {fileName("B.JBI")});
    QCOMPARE(bag->info().failures(), 1);
}

void TestBackup::meetsBadLists_data()
{
    QTest::addColumn<QByteArrayList>("names");
    QTest::addColumn<QByteArray>("bad");
    QTest::addColumn<int>("kind");
    const auto row = [](const char *title, const QByteArray &bad, ErrorKind kind) {
        QTest::newRow(title) << QByteArrayList {bad, "A.JBI"} << bad << int(kind);
    };
    row("path", "../../etc/passwd.JBI", ErrorKind::BadInput);
    row("backslash", "..\\..\\A.JBI", ErrorKind::BadInput);
    row("200 characters", QByteArray(200, 'N') + ".JBI", ErrorKind::BadInput);
    row("wild card", "*X.JBI", ErrorKind::BadInput);
    row("hidden", ".X.JBI", ErrorKind::BadInput);
}

void TestBackup::meetsBadLists()
{
    QFETCH(QByteArrayList, names);
    QFETCH(QByteArray, bad);
    QFETCH(int, kind);
    FileDesk desk;
    const QTemporaryDir root;
    for (const QByteArray &name : names)
        desk.files()[name] = jobText("A");
    Backup backup {desk.session, orderFor(root.path())};
    QVERIFY(FileDesk::finish(backup));
    const auto bag = Bag::open(backup.path());
    QVERIFY(bag);
    QCOMPARE(bag->files().hashes.size(), std::size_t(1));
    const auto &results = bag->info().results;
    QCOMPARE(results.size(), 2);
    QCOMPARE(results[0].name, bad);
    QCOMPARE(int(results[0].error->kind), kind);
    QCOMPARE(
        QDir {root.path()}.entryList(QDir::AllEntries | QDir::NoDotAndDotDot), QStringList {QStringLiteral("CELL 4")});
}

/// What is left of the name is asked for, refused, and said to be missing.
void TestBackup::meetsAListBrokenInAName()
{
    FileDesk desk;
    const QTemporaryDir root;
    desk.files() = {{"A.JBI", jobText("A")}, {"HALF\r\n.JBI", jobText("HALF")}};
    Backup backup {desk.session, orderFor(root.path())};
    QVERIFY(FileDesk::finish(backup));
    QVERIFY(backup.state() == OperationState::Done);
    QCOMPARE(backup.info().failures(), 2);
    const auto bag = Bag::open(backup.path());
    QCOMPARE(bag->files().hashes.size(), std::size_t(1));
    QVERIFY(bag->files().unread.contains(fileName("HALF")));
}

void TestBackup::endsWithoutABag_data()
{
    QTest::addColumn<QString>("faults");
    QTest::addColumn<int>("kind");
    QTest::addRow("busy for ever") << QStringLiteral("files request refuse code=0xE444") << int(ErrorKind::Refused);
    QTest::addRow("full disk") << QStringLiteral("seed=1") << int(ErrorKind::LocalFile);
    QTest::addRow("remote off") << QStringLiteral("files request refuse code=0xE2B2") << int(ErrorKind::Refused);
    QTest::addRow("silent") << QStringLiteral("files request lose") << int(ErrorKind::NoAnswer);
    QTest::addRow("silent after a while") << QStringLiteral("files request lose after=20") << int(ErrorKind::NoAnswer);
    QTest::addRow("nothing there") << QString() << int(ErrorKind::Malformed);
}

void TestBackup::endsWithoutABag()
{
    QFETCH(QString, faults);
    QFETCH(int, kind);
    session::FilePolicy policy = quick();
    policy.timeout = 40ms;
    FileDesk desk {*Faults::parse(faults), policy};
    const QTemporaryDir root;
    if (!faults.isEmpty())
        desk.files() = manyFiles(20);
    Backup backup {desk.session, orderFor(root.path())};
    {
        const FullDisk disk {kind == int(ErrorKind::LocalFile) ? 1000 : RLIM_INFINITY};
        QVERIFY(FileDesk::finish(backup));
    }
    QVERIFY(backup.state() == OperationState::Failed);
    QCOMPARE(int(backup.error()->kind), kind);
    QVERIFY(Archive(root.path(), QStringLiteral("CELL 4")).entries().isEmpty());
    QVERIFY(QDir {root.filePath(QStringLiteral("CELL 4"))}.entryList(QDir::Dirs | QDir::NoDotAndDotDot).isEmpty());
}

void TestBackup::waitsForNobody()
{
    FileDesk desk;
    const QTemporaryDir root;
    desk.files()["A.JBI"] = jobText("A");
    const auto lock = Archive {root.path(), QStringLiteral("CELL 4")}.lock();
    Backup backup {desk.session, orderFor(root.path())};
    QVERIFY(FileDesk::finish(backup));
    QVERIFY(backup.error()->kind == ErrorKind::LocalFile);
    Backup nowhere {desk.session, orderFor(QStringLiteral("/proc/none"))};
    QVERIFY(FileDesk::finish(nowhere));
    QVERIFY(nowhere.error()->kind == ErrorKind::LocalFile);
    QCOMPARE(desk.server.arrivals().files.size(), std::size_t(0));
}

void TestBackup::letsGoOfOldOnes()
{
    FileDesk desk;
    const QTemporaryDir root;
    desk.files()["A.JBI"] = jobText("A");
    BackupOrder order = orderFor(root.path());
    order.retention.count = 2;
    for (int run = 0; run < 4; ++run) {
        Backup backup {desk.session, order};
        QVERIFY(FileDesk::finish(backup));
        QVERIFY(backup.state() == OperationState::Done);
    }
    QCOMPARE(Archive(root.path(), QStringLiteral("CELL 4")).entries().size(), 2);
}

void TestBackup::isCancelled()
{
    FileDesk desk;
    const QTemporaryDir root;
    desk.files() = manyFiles(50);
    Backup backup {desk.session, orderFor(root.path())};
    connect(&backup, &Operation::progressed, &backup, [&] { backup.cancel(); });
    QVERIFY(FileDesk::finish(backup));
    QVERIFY(backup.state() == OperationState::Cancelled);
    auto second = std::make_unique<Backup>(desk.session, orderFor(root.path()));
    QSignalSpy progressed {second.get(), &Operation::progressed};
    second->start();
    QVERIFY(progressed.wait());
    second.reset();
    QVERIFY(QDir {root.filePath(QStringLiteral("CELL 4"))}.entryList(QDir::Dirs | QDir::NoDotAndDotDot).isEmpty());
    Backup third {desk.session, orderFor(root.path())};
    QVERIFY(FileDesk::finish(third));
    QVERIFY(third.state() == OperationState::Done);
}

/// This program itself, started to write backups until it is killed: see main().
void TestBackup::survivesKills()
{
    FileDesk desk;
    desk.files() = manyFiles(8);
    desk.server.memory().settings.transferTimeout = 30ms; // so that the dead do not keep the living waiting
    const QTemporaryDir root;
    const Archive archive {root.path(), QStringLiteral("CELL 4")};
    QVERIFY(!backedUp(desk, root.path()).hashes.empty());
    const QByteArray first =
        disk::readFile(archive.entries().last().path + QStringLiteral("/manifest-sha256.txt")).value();
    const QString firstId = archive.entries().last().id;
    std::mt19937 random {200};
    QSet<QString> seen;
    for (int run = 0; run < kills(); ++run) {
        QProcess child;
        child.start(QCoreApplication::applicationFilePath(),
            {QStringLiteral("--write-backups"), root.path(), QString::number(desk.server.filePort())});
        QVERIFY(child.waitForStarted());
        // Some die before their first file, some in the third backup.
        const qint64 steps = 1 + random() % 24;
        while (child.bytesAvailable() < steps)
            QVERIFY(QSignalSpy(&child, &QProcess::readyRead).wait(30000));
        child.kill();
        QVERIFY(child.waitForFinished());
        for (const ArchiveEntry &entry : archive.entries()) {
            if (seen.contains(entry.id))
                continue;
            seen.insert(entry.id);
            QVERIFY2(entry.isReadable && verify(entry.path).isGood(), qPrintable(entry.path));
        }
    }
    QCOMPARE(disk::readFile(archive.folder() + u'/' + firstId + QStringLiteral("/manifest-sha256.txt")).value(), first);
    for (const ArchiveEntry &entry : archive.entries())
        QVERIFY(verify(entry.path).isGood());
    const auto whole = archive.entries();
    QVERIFY(std::ranges::count_if(whole, [](const auto &entry) { return entry.files == 8; }) > 1);
    QVERIFY(archive.lock()); // nobody holds it any more
}

void TestBackup::plans_data()
{
    QTest::addColumn<QByteArray>("name");
    QTest::addColumn<int>("step");
    QTest::addRow("same") << QByteArray("SAME.JBI") << int(RestoreStep::Same);
    QTest::addRow("changed") << QByteArray("CHANGED.JBI") << int(RestoreStep::Changed);
    QTest::addRow("new") << QByteArray("NEW.JBI") << int(RestoreStep::New);
    QTest::addRow("running") << QByteArray("RUN.JBI") << int(RestoreStep::NotAllowed);
    QTest::addRow("system") << QByteArray("SYSTEM.SYS") << int(RestoreStep::NotAllowed);
    QTest::addRow("unread") << QByteArray("UNREAD.JBI") << int(RestoreStep::NotAllowed);
    QTest::addRow("not in the bag") << QByteArray("OTHER.JBI") << int(RestoreStep::NotAllowed);
    QTest::addRow("nowhere") << QByteArray("NOWHERE.JBI") << int(RestoreStep::NotAllowed);
    QTest::addRow("unlisted type") << QByteArray("A.PRM") << int(RestoreStep::NotAllowed);
}

void TestBackup::plans()
{
    QFETCH(QByteArray, name);
    QFETCH(int, step);
    const FileSet bag = fileSetOf({{fileName("SAME.JBI"), jobText("SAME")},
        {fileName("CHANGED.JBI"), jobText("CHANGED")}, {fileName("NEW.JBI"), jobText("NEW")},
        {fileName("RUN.JBI"), jobText("RUN")}, {fileName("SYSTEM.SYS"), "//S\r\n"},
        {fileName("UNREAD.JBI"), jobText("UNREAD")}, {fileName("A.PRM"), "//P\r\n"}});
    FileSet controller = fileSetOf({{fileName("SAME.JBI"), jobText("SAME")},
        {fileName("CHANGED.JBI"), jobText("CHANGED", 1)}, {fileName("OTHER.JBI"), jobText("OTHER")}});
    controller.unread.insert(fileName("UNREAD.JBI"));
    controller.unlisted.insert("PRM");
    const auto plan = planRestore(bag, controller, {{fileName(name)}, {"RUN"}});
    QCOMPARE(plan.size(), 1);
    QCOMPARE(int(plan[0].step), step);
    QCOMPARE(plan[0].reason.isEmpty(), plan[0].step != RestoreStep::NotAllowed);
    QCOMPARE(planRestore(bag, controller).size(), 7);
}

void TestBackup::restoresWhatChanged()
{
    FileDesk desk;
    const QTemporaryDir root;
    desk.files() = {{"A.JBI", jobText("A")}, {"B.JBI", jobText("B")}, {"C.DAT", "//C\r\n"}, {"S.SYS", "//S\r\n"}};
    const auto original = desk.files();
    const FileSet bag = backedUp(desk, root.path());
    desk.files()["A.JBI"] = jobText("A", 5);
    desk.files().erase("C.DAT");
    auto plan = planFor(desk, bag);
    QVERIFY(std::ranges::find(plan, fileName("C.DAT"), &RestoreItem::name)->needsCare); // nobody knows what it is
    Restore restore {desk.session, bag, plan, orderFor(root.path()), always()};
    QSignalSpy tried {&restore, &Restore::tried};
    const auto loads = desk.server.arrivals().files.count(protocol::Service::LoadFile);
    QCOMPARE(loads, 0U);
    QVERIFY(FileDesk::finish(restore));
    QVERIFY(restore.state() == OperationState::Done);
    QCOMPARE(restore.filesDone(), 2);
    QCOMPARE(restore.filesTotal(), 2);
    QCOMPARE(tried.size(), 2);
    QVERIFY(desk.files() == original);
    const auto fresh = Bag::open(restore.backup().path());
    QVERIFY(fresh && fresh->files().content(fileName("A.JBI")) == jobText("A", 5));
    // A second time there is nothing to do.
    for (const RestoreItem &item : planFor(desk, bag))
        QVERIFY(!item.isSent());
}

/// Somebody changes the backup after the plan was made of it.
void TestBackup::restoresNothingSpoilt()
{
    FileDesk desk;
    const QTemporaryDir root;
    desk.files() = {{"A.JBI", jobText("A")}};
    const FileSet bag = backedUp(desk, root.path());
    desk.files()["A.JBI"] = jobText("A", 5);
    const auto plan = planFor(desk, bag);
    const QString path = Archive(root.path(), QStringLiteral("CELL 4")).entries().value(0).path;
    QVERIFY(disk::replaceFile(path + QStringLiteral("/data/A.JBI"), jobText("A", 6)));
    Restore restore {desk.session, bag, plan, orderFor(root.path()), always()};
    QVERIFY(FileDesk::finish(restore));
    QVERIFY(restore.state() == OperationState::Failed);
    QVERIFY(restore.error()->kind == ErrorKind::LocalFile);
    QCOMPARE(desk.files()["A.JBI"], jobText("A", 5));
}

void TestBackup::readsInOrder()
{
    FileDesk desk;
    const QTemporaryDir root;
    desk.files() = {{"A.JBI", jobText("A")}, {"ALL.PRM", "/ALL YAS\r\n"}, {"LOGDATA.DAT", "//LOGDATA\r\n"},
        {"PANELBOX.LOG", "/SYSTEM 8\r\n"}, {"RC.PRM", "//RC YAS\r\n"}, {"RS.PRM", "//RS YAS\r\n"},
        {"SV.PRM", "//SV YAS\r\n"}, {"TOOL.CND", "//TOOL 0\r\n"}, {"VAR.DAT", "//VAR\r\n"}};
    const auto read = [&](bool wantsAll) {
        BackupOrder order = orderFor(root.path());
        order.wantsAllParameters = wantsAll;
        Backup backup {desk.session, order};
        QByteArrayList names;
        if (FileDesk::finish(backup)) {
            for (const FileResult &result : backup.info().results)
                names << result.name;
        }
        const auto others = QFile::permissions(backup.path()) & (QFile::ReadGroup | QFile::ReadOther | QFile::ExeOther);
        return others == QFile::Permissions {} ? names : QByteArrayList {};
    };
    const QByteArrayList names {"LOGDATA.DAT", "A.JBI", "TOOL.CND", "VAR.DAT", "RC.PRM", "RS.PRM", "SV.PRM"};
    QCOMPARE(read(false), names + QByteArrayList {"PANELBOX.LOG"});
    QCOMPARE(read(true), (names + QByteArrayList {"PANELBOX.LOG", "ALL.PRM"}));
    desk.files().erase("PANELBOX.LOG"); // not offered: no failure
    desk.files().erase("RC.PRM"); // then ALL.PRM is all there is
    QCOMPARE(
        read(false), (QByteArrayList {"LOGDATA.DAT", "A.JBI", "TOOL.CND", "VAR.DAT", "RS.PRM", "SV.PRM", "ALL.PRM"}));
}

void TestBackup::goesOnAfterARefusedFile()
{
    FileDesk desk;
    const QTemporaryDir root;
    desk.files() = {{"A.JBI", jobText("A")}, {"B.JBI", jobText("B")}, {"C.JBI", jobText("C")}};
    const FileSet bag = backedUp(desk, root.path());
    for (const char *name : {"A", "B", "C"})
        desk.files()[QByteArray(name) + ".JBI"] = jobText(name, 3);
    Restore restore {desk.session, bag, planFor(desk, bag), orderFor(root.path()), always()};
    connect(&restore, &Restore::tried, this, [&](const Upload *upload) {
        desk.server.memory().settings.mayOverwriteFiles = upload->name() != fileName("A.JBI"); // B is refused alone
    });
    QVERIFY(FileDesk::finish(restore));
    QVERIFY(restore.state() == OperationState::Failed);
    QVERIFY(restore.error()->kind == ErrorKind::Refused);
    QCOMPARE(restore.filesDone(), 2);
    QCOMPARE(restore.refusals().size(), 1);
    QCOMPARE(restore.refusals().first().name, QByteArray("B.JBI"));
    QCOMPARE(desk.files()["B.JBI"], jobText("B", 3));
    QCOMPARE(desk.files()["C.JBI"], jobText("C"));
}

void TestBackup::plansInOrder()
{
    const QByteArray calling = jobText("A").replace("NOP\r\n", "NOP\r\nCALL JOB:Z\r\nCALL JOB:A\r\n");
    const FileSet bag =
        fileSetOf({{fileName("VAR.DAT"), "//VAR\r\n"}, {fileName("A.JBI"), calling}, {fileName("Z.JBI"), jobText("Z")},
            {fileName("IONAME.DAT"), "/IONAME\r\n"}, {fileName("WEAV.CND"), "//WEAV 1\r\n"},
            {fileName("MACRO.DAT"), "//MACRO1 1\r\n"}, {fileName("TOOL.CND"), "//TOOL 0\r\n"},
            {fileName("ABSO.DAT"), "//ABSO\r\n"}, {fileName("LOGDATA.DAT"), "//LOGDATA\r\n"}});
    QByteArrayList sent;
    QByteArrayList careful;
    for (const RestoreItem &item : planRestore(bag, fileSetOf({}))) {
        if (item.isSent())
            sent << item.name.bytes();
        if (item.needsCare)
            careful << item.name.bytes();
    }
    QCOMPARE(sent, (QByteArrayList {"TOOL.CND", "WEAV.CND", "IONAME.DAT", "Z.JBI", "A.JBI", "MACRO.DAT", "VAR.DAT"}));
    QCOMPARE(careful, QByteArrayList {"TOOL.CND"});
    // Of another robot nothing is sent but jobs and names that a person named.
    for (const RestoreItem &item : planRestore(bag, fileSetOf({}), {{}, {}, true}))
        QVERIFY(!item.isSent());
    const auto named =
        planRestore(bag, fileSetOf({}), {{fileName("Z.JBI"), fileName("ABSO.DAT"), fileName("VAR.DAT")}, {}, true});
    QCOMPARE(int(std::ranges::count_if(named, &RestoreItem::isSent)), 1);
    QVERIFY(std::ranges::find(named, fileName("Z.JBI"), &RestoreItem::name)->isSent());
}

void TestBackup::tellsRobotsApart_data()
{
    QTest::addColumn<QString>("model");
    QTest::addColumn<QByteArray>("system");
    QTest::addColumn<bool>("isAnother");
    const QByteArray same = "/SYSTEM 8\r\n//SYSTEM NO : YAS4.50\r\n//ROBOT NAME\r\nR1 : R10  0011_1111\r\n";
    QTest::newRow("the same") << QStringLiteral("1-06VXH12-A0*") << same << false;
    QTest::newRow("another model") << QStringLiteral("1-06VX88-A0*") << same << true;
    QTest::newRow("another arm") << QStringLiteral("1-06VXH12-A0*") << QByteArray {same}.replace("R10", "R20") << true;
    QTest::newRow("more axes") << QStringLiteral("1-06VXH12-A0*") << QByteArray {same}.replace("0011", "0111") << true;
    QTest::newRow("newer software") << QStringLiteral("1-06VXH12-A0*") << QByteArray {same}.replace("4.50", "4.60")
                                    << false;
    QTest::newRow("nothing known") << QString {} << QByteArray {} << false;
}

void TestBackup::tellsRobotsApart()
{
    QFETCH(QString, model);
    QFETCH(QByteArray, system);
    BagInfo info;
    info.model = QStringLiteral("1-06VXH12-A0*");
    const QByteArray own = "/SYSTEM 8\r\n//SYSTEM NO : YAS4.50\r\n//ROBOT NAME\r\nR1 : R10  0011_1111\r\n";
    const Identity backup = identityOf(info, fileSetOf({{fileName("SYSTEM.SYS"), own}}));
    info.model = model;
    const auto rows = compareIdentities(backup, identityOf(info, fileSetOf({{fileName("SYSTEM.SYS"), system}})));
    QTEST(isAnotherRobot(rows), "isAnother");
}

void TestBackup::neverRestoresWhileAJobRuns()
{
    FileDesk desk;
    const QTemporaryDir root;
    desk.files() = {{"A.JBI", jobText("A")}, {"B.JBI", jobText("B")}};
    const FileSet bag = backedUp(desk, root.path());
    desk.files() = {{"A.JBI", jobText("A", 1)}, {"B.JBI", jobText("B", 1)}};
    const auto plan = planFor(desk, bag);
    bool mayChange = false;
    Restore restore {desk.session, bag, plan, orderFor(root.path()), refusing(mayChange)};
    QVERIFY(FileDesk::finish(restore));
    QVERIFY(restore.error()->kind == ErrorKind::NotSent);
    QCOMPARE(Archive(root.path(), QStringLiteral("CELL 4")).entries().size(), 1);
    mayChange = true; // and a job starts after the first file
    connect(&restore, &Restore::tried, this, [&] { mayChange = false; });
    restore.reset();
    QVERIFY(FileDesk::finish(restore));
    QVERIFY(restore.error()->kind == ErrorKind::NotSent);
    QCOMPARE(desk.files()["A.JBI"], jobText("A"));
    QCOMPARE(desk.files()["B.JBI"], jobText("B", 1));
}

void TestBackup::noticesThatThePlanIsOld()
{
    FileDesk desk;
    const QTemporaryDir root;
    desk.files() = {{"A.JBI", jobText("A")}};
    const FileSet bag = backedUp(desk, root.path());
    desk.files().erase("A.JBI");
    desk.files()["B.JBI"] = jobText("B");
    const auto plan = planFor(desk, bag);
    QVERIFY(plan[0].step == RestoreStep::New);
    desk.files()["A.JBI"] = jobText("A", 9); // somebody has taught it in the meantime
    Restore restore {desk.session, bag, plan, orderFor(root.path()), always()};
    QVERIFY(FileDesk::finish(restore));
    QVERIFY(restore.error()->kind == ErrorKind::NotSent);
    QCOMPARE(desk.files()["A.JBI"], jobText("A", 9));
}

/// A byte for each file.
void tellStep()
{
    std::putchar('.');
    std::fflush(stdout);
}

/// Writes backups until somebody ends the process.
int writeBackups(const QString &root, quint16 port)
{
    session::UdpTransport transport {QHostAddress {QHostAddress::LocalHost}, port};
    session::FileSession session {transport, quick()};
    std::unique_ptr<Backup> next;
    const std::function<void()> again = [&] {
        next = std::make_unique<Backup>(session, orderFor(root));
        QObject::connect(next.get(), &Operation::progressed, qApp, tellStep);
        QObject::connect(next.get(), &Operation::finished, qApp, [&] { QTimer::singleShot(1, qApp, again); });
        next->start();
    };
    again();
    return QCoreApplication::exec();
}

int main(int argc, char *argv[])
{
    QCoreApplication application {argc, argv};
    const QStringList arguments = QCoreApplication::arguments();
    if (arguments.value(1) == u"--write-backups")
        return writeBackups(arguments.value(2), quint16(arguments.value(3).toUInt()));
    TestBackup test;
    return QTest::qExec(&test, argc, argv);
}

#include "tst_backup.moc"
