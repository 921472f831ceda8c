// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "files/archive.h"

#include <QDirIterator>
#include <QProcess>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>
#include <random>

using namespace files;
using values::ErrorKind;
using values::FileName;

namespace {

FileName fileName(const char *bytes) { return *FileName::create(bytes); }

QDateTime at(const char *iso) { return QDateTime::fromString(QString::fromLatin1(iso), Qt::ISODate); }

BagInfo info()
{
    BagInfo result;
    result.controller = QStringLiteral("CELL 4 · Weld");
    result.host = QStringLiteral("127.0.0.1");
    result.model = QStringLiteral("YRC1000");
    result.software = QStringLiteral("YAS2.80.00A(EN/JP)");
    result.parameterVersion = QStringLiteral("02.14");
    result.taken = at("2026-01-12T08:30:00Z");
    result.results = {{"A.JBI", {}}, {"B\x83\x5C.DAT", {}},
        {"LOCKED.PRM", values::Error {ErrorKind::Refused, 0x1F, 0x2110, {}}},
        {"../../etc/passwd", values::Error {ErrorKind::BadInput, 0, 0, {}}}};
    return result;
}

const std::map<FileName, QByteArray> contents {{fileName("A.JBI"), "/JOB\r\n"},
    {fileName("B\x83\x5C.DAT"), QByteArray("\0\xFF", 2)}, {fileName("CON.CND"), QByteArray(3000, 'c')},
    {fileName("a.jbi"), "lower"}};

/// A bag with `contents` in `folder`; its path.
QString makeBag(const QString &folder, const QDateTime &taken = info().taken, const BagInfo &about = info())
{
    auto writer = BagWriter::create(folder, taken);
    for (const auto &[name, content] : contents) {
        if (!writer || !(*writer)->add(name, content))
            return {};
    }
    return (*writer)->seal(about).value_or(QString {});
}

QStringList filesBelow(const QString &path)
{
    QStringList result;
    QDirIterator files {path, QDir::Files | QDir::Hidden, QDirIterator::Subdirectories};
    while (files.hasNext())
        result << files.next();
    result.sort();
    return result;
}

QByteArray contentOf(const QString &path)
{
    QFile file {path};
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray {};
}

bool write(const QString &path, const QByteArray &content)
{
    QFile file {path};
    return file.open(QIODevice::WriteOnly) && file.write(content) == content.size();
}

using Spoil = bool (*)(const QString &bag);
struct Case {
    const char *name;
    Spoil spoil;
    FaultKind kind;
    const char *path;
};

constexpr Case cases[] {
    {"a file is gone", [](const QString &bag) { return QFile::remove(bag + u"/data/A.JBI"_qs); }, FaultKind::Missing,
        "data/A.JBI"},
    {"a file is shorter", [](const QString &bag) { return QFile::resize(bag + u"/data/%43ON.CND"_qs, 2999); },
        FaultKind::Changed, "data/%43ON.CND"},
    {"a file more", [](const QString &bag) { return write(bag + u"/data/X.JBI"_qs, "x"); }, FaultKind::Extra,
        "data/X.JBI"},
    {"a hidden file more", [](const QString &bag) { return write(bag + u"/.hidden"_qs, "x"); }, FaultKind::Extra,
        ".hidden"},
    {"a file in a folder more",
        [](const QString &bag) { return QDir {}.mkpath(bag + u"/data/D"_qs) && write(bag + u"/data/D/X"_qs, "x"); },
        FaultKind::Extra, "data/D/X"},
    {"a link instead of a file",
        [](const QString &bag) {
            return QFile::rename(bag + u"/data/A.JBI"_qs, bag + u"/../A"_qs)
                && QFile::link(bag + u"/../A"_qs, bag + u"/data/A.JBI"_qs);
        },
        FaultKind::Extra, "data/A.JBI"},
    {"no declaration", [](const QString &bag) { return QFile::remove(bag + u"/bagit.txt"_qs); }, FaultKind::NotABag,
        "bagit.txt"},
    {"another version",
        [](const QString &bag) {
            return write(bag + u"/bagit.txt"_qs, "BagIt-Version: 0.97\nTag-File-Character-Encoding: UTF-8\n");
        },
        FaultKind::NotABag, "bagit.txt"},
    {"no manifest", [](const QString &bag) { return QFile::remove(bag + u"/manifest-sha256.txt"_qs); },
        FaultKind::NotABag, "manifest-sha256.txt"},
    {"no tag manifest", [](const QString &bag) { return QFile::remove(bag + u"/tagmanifest-sha256.txt"_qs); },
        FaultKind::NotABag, "tagmanifest-sha256.txt"},
    {"an empty tag manifest", [](const QString &bag) { return write(bag + u"/tagmanifest-sha256.txt"_qs, ""); },
        FaultKind::Extra, "bagit.txt"},
    {"a manifest cut in a line",
        [](const QString &bag) { return QFile::resize(bag + u"/manifest-sha256.txt"_qs, 100); }, FaultKind::Malformed,
        "manifest-sha256.txt"},
    {"a manifest that leads out",
        [](const QString &bag) {
            return write(bag + u"/manifest-sha256.txt"_qs, QByteArray(64, '0') + "  data/../../A\n");
        },
        FaultKind::Malformed, "manifest-sha256.txt"},
};

} // namespace

/// Backups on disk: written whole or not at all, verified to the bit, kept and let go by rule.
class TestBag : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void keepsEverything();
    void isABagByTheStandard();
    void isNoBackupUntilSealed();
    void goesWhenItIsNotSealed();
    void findsFaults_data();
    void findsFaults();
    void verifiesByAnyPath_data();
    void verifiesByAnyPath();
    void findsEveryBit();
    void withholdsSpoiltContent();
    void readsManifests_data();
    void readsManifests();
    void cannotWriteWhereItMayNot();
    void takesTwoInOneSecond();
    void listsNewestFirst();
    void letsOneWriteAtATime();
    void expires_data();
    void expires();
    void prunesAllButTheLastGood();
};

void TestBag::keepsEverything()
{
    const QTemporaryDir folder;
    const auto bag = Bag::open(makeBag(folder.path()));
    QVERIFY(bag);
    QVERIFY(bag->info() == info());
    QCOMPARE(bag->info().failures(), 2);
    const FileSet set = bag->files();
    QCOMPARE(set.hashes.size(), contents.size());
    for (const auto &[name, content] : contents)
        QCOMPARE(set.content(name).value_or(QByteArray("?")), content);
    QVERIFY(set.unread == std::set<FileName> {fileName("LOCKED.PRM")});
    QCOMPARE(bag->path(), folder.filePath(QStringLiteral("2026-01-12T083000Z")));
    const Verification good = verify(bag->path());
    QVERIFY(good.isGood());
    QCOMPARE(good.files, 4);
    QCOMPARE(good.bytes, 6 + 2 + 3000 + 5);
}

/// With other programs' eyes: the sums that sha256sum(1) computes, and the counts of Payload-Oxum.
void TestBag::isABagByTheStandard()
{
    const QTemporaryDir folder;
    const QString bag = makeBag(folder.path());
    QCOMPARE(contentOf(bag + QStringLiteral("/bagit.txt")), "BagIt-Version: 1.0\nTag-File-Character-Encoding: UTF-8\n");
    QVERIFY(contentOf(bag + QStringLiteral("/bag-info.txt")).contains("\nPayload-Oxum: 3013.4\n"));
    QVERIFY(contentOf(bag + QStringLiteral("/bag-info.txt")).contains("\nBagging-Date: 2026-01-12\n"));
    const QByteArray manifest = contentOf(bag + QStringLiteral("/manifest-sha256.txt"));
    // printf '/JOB\r\n' | sha256sum
    QVERIFY(manifest.contains("  data/A.JBI\n"));
    QVERIFY(manifest.contains("  data/%2543ON.CND\n")); // RFC 8493 §2.1.3: a percent sign is written %25
    QProcess sums;
    sums.setWorkingDirectory(bag);
    sums.start(QStringLiteral("sha256sum"),
        {QStringLiteral("--check"), QStringLiteral("--strict"), QStringLiteral("tagmanifest-sha256.txt")});
    QVERIFY(sums.waitForFinished());
    QCOMPARE(sums.exitCode(), 0);
}

void TestBag::isNoBackupUntilSealed()
{
    const QTemporaryDir root;
    const Archive archive {root.path(), QStringLiteral("A")};
    auto writer = BagWriter::create(archive.folder(), info().taken);
    QVERIFY(writer && (*writer)->add(fileName("A.JBI"), "a"));
    QVERIFY(archive.entries().isEmpty());
    QCOMPARE(QDir {archive.folder()}.entryList(QDir::Dirs | QDir::NoDotAndDotDot),
        QStringList {QStringLiteral("2026-01-12T083000Z.partial")});
    QVERIFY((*writer)->seal(info()));
    QCOMPARE(archive.entries().size(), 1);
    writer->reset();
    QCOMPARE(archive.entries().size(), 1);
}

void TestBag::goesWhenItIsNotSealed()
{
    const QTemporaryDir root;
    auto writer = BagWriter::create(root.path(), info().taken);
    QVERIFY(writer && (*writer)->add(fileName("A.JBI"), "a"));
    writer->reset();
    QVERIFY(QDir {root.path()}.isEmpty());
}

void TestBag::findsFaults_data()
{
    QTest::addColumn<int>("index");
    for (int index = 0; index < int(std::size(cases)); ++index)
        QTest::addRow("%s", cases[index].name) << index;
}

void TestBag::findsFaults()
{
    QFETCH(int, index);
    const QTemporaryDir folder;
    const QString bag = makeBag(folder.path());
    QVERIFY(cases[index].spoil(bag));
    const auto faults = verify(bag).faults;
    QVERIFY(faults.contains(BagFault {cases[index].kind, QString::fromLatin1(cases[index].path)}));
    QVERIFY(!explain(faults.first()).isEmpty());
}

void TestBag::verifiesByAnyPath_data()
{
    QTest::addColumn<QString>("path"); // from the folder that holds the bag
    QTest::addRow("relative") << QStringLiteral("2026-01-12T083000Z");
    QTest::addRow("with a dot") << QStringLiteral("./2026-01-12T083000Z");
    QTest::addRow("with a slash") << QStringLiteral("2026-01-12T083000Z/");
    QTest::addRow("by a detour") << QStringLiteral("2026-01-12T083000Z/data/..");
}

void TestBag::verifiesByAnyPath()
{
    QFETCH(QString, path);
    const QTemporaryDir folder;
    QVERIFY(!makeBag(folder.path()).isEmpty());
    const QString before = QDir::currentPath();
    QVERIFY(QDir::setCurrent(folder.path()));
    const Verification found = verify(path);
    QVERIFY(QDir::setCurrent(before));
    QVERIFY(found.isGood());
    QCOMPARE(found.files, 4);
}

void TestBag::findsEveryBit()
{
    const QTemporaryDir folder;
    const QString bag = makeBag(folder.path());
    const QStringList paths = filesBelow(bag);
    QCOMPARE(paths.size(), 8);
    std::mt19937 random {8493};
    int found = 0;
    for (int run = 0; run < 1000; ++run) {
        const QString &path = paths[int(random() % quint32(paths.size()))];
        const QByteArray before = contentOf(path);
        QByteArray after = before;
        after[qsizetype(random() % quint32(after.size()))] ^= char(1 << random() % 8);
        QVERIFY(write(path, after));
        found += !verify(bag).isGood();
        QVERIFY(write(path, before));
    }
    QCOMPARE(found, 1000);
    QVERIFY(verify(bag).isGood());
}

void TestBag::withholdsSpoiltContent()
{
    const QTemporaryDir folder;
    const auto bag = Bag::open(makeBag(folder.path()));
    QVERIFY(write(bag->path() + QStringLiteral("/data/A.JBI"), "/JOC\r\n"));
    const auto content = bag->files().content(fileName("A.JBI"));
    QVERIFY(!content && content.error().kind == ErrorKind::LocalFile);
}

void TestBag::readsManifests_data()
{
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<bool>("isGood");
    const QByteArray hash(64, 'a');
    QTest::addRow("nothing") << QByteArray() << true;
    QTest::addRow("two") << hash + "  data/A\n" + hash + "  data/B\n" << true;
    QTest::addRow("percent") << hash + "  data/%25\n" << true;
    QTest::addRow("bare percent") << hash + "  data/%\n" << false;
    QTest::addRow("out of order") << hash + "  data/B\n" + hash + "  data/A\n" << false;
    QTest::addRow("twice") << hash + "  data/A\n" + hash + "  data/A\n" << false;
    QTest::addRow("one blank") << hash + " data/A\n" << false;
    QTest::addRow("star") << hash + " *data/A\n" << false;
    QTest::addRow("no final newline") << hash + "  data/A" << false;
    QTest::addRow("CR LF") << hash + "  data/A\r\n" << false;
    QTest::addRow("absolute") << hash + "  /etc/passwd\n" << false;
    QTest::addRow("up") << hash + "  data/../../A\n" << false;
    QTest::addRow("no path") << hash + "  \n" << false;
    QTest::addRow("drive") << hash + "  C:A\n" << false;
    QTest::addRow("backslash") << hash + "  data\\A\n" << false;
    QTest::addRow("empty line") << hash + "  data/A\n\n" << false;
}

void TestBag::readsManifests()
{
    QFETCH(QByteArray, text);
    QFETCH(bool, isGood);
    QCOMPARE(manifestFrom(text).has_value(), isGood);
}

void TestBag::cannotWriteWhereItMayNot()
{
    const auto writer = BagWriter::create(QStringLiteral("/proc/nowhere"), info().taken);
    QVERIFY(!writer && writer.error().kind == ErrorKind::LocalFile);
    const auto lock = Archive {QStringLiteral("/proc"), QStringLiteral("A")}.lock();
    QVERIFY(!lock && lock.error().kind == ErrorKind::LocalFile);
}

void TestBag::takesTwoInOneSecond()
{
    const QTemporaryDir folder;
    const QString first = makeBag(folder.path());
    const QString second = makeBag(folder.path());
    QVERIFY(second.endsWith(QStringLiteral("Z-2")));
    QVERIFY(verify(first).isGood() && verify(second).isGood());
}

void TestBag::listsNewestFirst()
{
    const QTemporaryDir root;
    const Archive archive {root.path(), QStringLiteral("CELL 4 · Weld")};
    for (const char *time : {"2026-01-02T00:00:00Z", "2026-03-01T00:00:00Z", "2026-02-01T00:00:00Z"})
        QVERIFY(!makeBag(archive.folder(), at(time)).isEmpty());
    QVERIFY(QDir {}.mkpath(archive.folder() + QStringLiteral("/notes")));
    QVERIFY(QDir {}.mkpath(archive.folder() + QStringLiteral("/2026-02-02T000000Z")));
    QVERIFY(archive.setPinned(QStringLiteral("2026-01-02T000000Z"), true));
    const auto entries = archive.entries();
    QCOMPARE(entries.size(), 4);
    QCOMPARE(entries[0].taken, at("2026-03-01T00:00:00Z"));
    QCOMPARE(entries[0].files, 4);
    QCOMPARE(entries[0].failures, 2);
    QVERIFY(!entries[0].isComplete() && entries[0].isReadable);
    QVERIFY(!entries[1].isReadable);
    QVERIFY(!entries[0].isPinned && entries[3].isPinned);
    QVERIFY(archive.setPinned(QStringLiteral("2026-01-02T000000Z"), false));
    QVERIFY(!archive.entries()[3].isPinned);
    QCOMPARE(archivedControllers(root.path()), QStringList {QStringLiteral("CELL 4 · Weld")});
}

void TestBag::letsOneWriteAtATime()
{
    const QTemporaryDir root;
    const Archive archive {root.path(), QStringLiteral("A")};
    auto first = archive.lock();
    QVERIFY(first);
    const auto second = archive.lock();
    QVERIFY(!second && second.error().kind == ErrorKind::LocalFile);
    QVERIFY(Archive(root.path(), QStringLiteral("B")).lock());
    first->reset();
    QVERIFY(archive.lock());
    // Killed between making the lock and writing into it.
    const QString path = archive.folder() + QStringLiteral("/.lock");
    QVERIFY(write(path, ""));
    QVERIFY(!archive.lock());
    QFile nameless {path};
    QVERIFY(nameless.open(QIODevice::ReadWrite));
    QVERIFY(nameless.setFileTime(QDateTime::currentDateTime().addSecs(-10), QFileDevice::FileModificationTime));
    nameless.close();
    QVERIFY(archive.lock());
}

void TestBag::expires_data()
{
    QTest::addColumn<int>("count");
    QTest::addColumn<int>("days");
    QTest::addColumn<QString>("lastGood");
    QTest::addColumn<QStringList>("gone"); // of e (newest) to a, c being pinned
    const auto ids = [](const char *letters) {
        return QString::fromLatin1(letters).split(QString(), Qt::SkipEmptyParts);
    };
    QTest::addRow("everything is kept") << 0 << 0 << QString() << ids("");
    QTest::addRow("two") << 2 << 0 << QString() << ids("ba");
    QTest::addRow("one") << 1 << 0 << QString() << ids("dba");
    QTest::addRow("one and the last good") << 1 << 0 << QStringLiteral("b") << ids("da");
    QTest::addRow("15 days") << 0 << 15 << QString() << ids("ba");
    QTest::addRow("15 days, four") << 4 << 15 << QStringLiteral("a") << ids("b");
    QTest::addRow("all are old") << 0 << 1 << QStringLiteral("e") << ids("dba");
    QTest::addRow("more than there are") << 9 << 0 << QString() << ids("");
}

void TestBag::expires()
{
    QFETCH(int, count);
    QFETCH(int, days);
    QFETCH(QString, lastGood);
    QFETCH(QStringList, gone);
    QList<ArchiveEntry> entries; // e is 1 day old, d 11, c 21 …
    const QDateTime now = at("2026-06-01T00:00:00Z");
    for (int index = 0; index < 5; ++index) {
        ArchiveEntry entry;
        entry.id = QChar(u'e' - char16_t(index));
        entry.taken = now.addDays(-1 - 10 * index).addSecs(-1);
        entry.isPinned = entry.id == u'c';
        entries << entry;
    }
    QCOMPARE(expired(entries, {count, days}, now, lastGood), gone);
}

void TestBag::prunesAllButTheLastGood()
{
    const QTemporaryDir root;
    const Archive archive {root.path(), QStringLiteral("A")};
    BagInfo whole = info();
    whole.results.resize(2);
    for (int day = 1; day <= 5; ++day)
        QVERIFY(!makeBag(archive.folder(), at("2026-01-01T00:00:00Z").addDays(day), whole).isEmpty());
    // The three newest: incomplete, spoilt, and not even a bag.
    QVERIFY(!makeBag(archive.folder(), at("2026-02-01T00:00:00Z")).isEmpty());
    QVERIFY(QFile::remove(archive.folder() + QStringLiteral("/2026-01-06T000000Z/data/A.JBI")));
    QVERIFY(QDir {}.mkpath(archive.folder() + QStringLiteral("/2026-03-01T000000Z")));
    const auto gone = archive.prune({1, 0}, at("2026-03-02T00:00:00Z"));
    QVERIFY(gone);
    QCOMPARE(gone->size(), 5);
    const auto left = archive.entries();
    QCOMPARE(left.size(), 2);
    QCOMPARE(left[0].id, QStringLiteral("2026-03-01T000000Z"));
    QCOMPARE(left[1].id, QStringLiteral("2026-01-05T000000Z")); // the newest that is complete and verifies
    QVERIFY(QFile::remove(left[1].path + QStringLiteral("/data/A.JBI")));
    QVERIFY(archive.prune({1, 0}, at("2026-03-02T00:00:00Z"))->isEmpty());
}

QTEST_GUILESS_MAIN(TestBag)

#include "tst_bag.moc"
