// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "settings/settingsfile.h"

#include "settings/profilestore.h"
#include <QDir>
#include <QFile>
#include <QJsonDocument>
#include <QLockFile>
#include <QSettings>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#ifdef Q_OS_UNIX
#include <csignal>
#include <sys/resource.h>
#include <sys/stat.h>
#endif

using namespace settings;

namespace {

QByteArray contentOf(const QString &path)
{
    QFile file {path};
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray {};
}

bool writeRaw(const QString &path, const QByteArray &content)
{
    QFile file {path};
    return file.open(QIODevice::WriteOnly) && file.write(content) == content.size();
}

Profile cell(int number)
{
    Profile profile;
    profile.name = QStringLiteral("CELL %1 / ü").arg(number);
    profile.host = QStringLiteral("192.0.2.%1").arg(number);
    return profile;
}

/// A folder with 64 profiles in it.
struct Desk {
    explicit Desk(int count = 64)
    {
        SettingsFile file {path};
        ProfileStore store {file};
        for (int number = 1; number <= count; ++number)
            store.save(cell(number));
    }
    [[nodiscard]] QStringList entries() const
    {
        return QDir {folder.path()}.entryList(QDir::Files | QDir::System | QDir::Hidden);
    }

    QTemporaryDir folder;
    QString path = folder.filePath(QStringLiteral("settings.json"));
};

} // namespace

class TestSettingsFile : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void keepsWhatWasSet()
    {
        const Desk desk {0};
        {
            SettingsFile file {desk.path};
            file.setValue(QStringLiteral("a/b"), 1);
            file.setValue(QStringLiteral("a/c"), QStringLiteral("溶接"));
            file.setValue(QStringLiteral("ab"), true);
            file.setValue(QStringLiteral("ab"), false);
        }
        SettingsFile file {desk.path};
        QCOMPARE(file.notice(), QString());
        QCOMPARE(file.keys(QStringLiteral("a")), (QStringList {QStringLiteral("b"), QStringLiteral("c")}));
        QCOMPARE(file.value(QStringLiteral("a/c")).toString(), QStringLiteral("溶接"));
        QCOMPARE(file.value(QStringLiteral("ab")), QJsonValue {false});
        QVERIFY(file.value(QStringLiteral("nothing")).isUndefined());
        file.remove(QStringLiteral("a"));
        QVERIFY(file.keys(QStringLiteral("a")).isEmpty());
        QSignalSpy saved {&file, &SettingsFile::saved};
        QVERIFY(saved.wait());
        QVERIFY(file.isSaved());
        QCOMPARE(SettingsFile {desk.path}.value(QStringLiteral("ab")), QJsonValue {false});
        QVERIFY(!SettingsFile {desk.path}.contains(QStringLiteral("a/b")));
    }

    void isForItsOwnerAlone()
    {
        const QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("made/settings.json"));
        {
            SettingsFile file {path};
            file.setValue(QStringLiteral("a"), 1);
        }
        const auto owner = QFile::ReadOwner | QFile::WriteOwner;
        const auto user = QFile::ReadUser | QFile::WriteUser;
        QCOMPARE(QFile::permissions(path), owner | user);
        QCOMPARE(QFile::permissions(path + QStringLiteral(".last-good")), owner | user);
        QCOMPARE(QFile::permissions(folder.filePath(QStringLiteral("made"))),
            owner | user | QFile::ExeOwner | QFile::ExeUser);
    }

    void aDamagedFileIsKeptAndTheCopyUsed_data()
    {
        QTest::addColumn<double>("part"); // of the file that is still there
        QTest::addColumn<QByteArray>("rest");
        QTest::newRow("empty") << 0.0 << QByteArray {};
        QTest::newRow("a tenth") << 0.1 << QByteArray {};
        QTest::newRow("half") << 0.5 << QByteArray {};
        QTest::newRow("all but the end") << 0.999 << QByteArray {};
        QTest::newRow("zeros") << 0.0 << QByteArray(5000, '\0');
        QTest::newRow("another format") << 0.0 << QByteArray {R"({"format": 2, "values": {}})"};
        QTest::newRow("an array") << 0.0 << QByteArray {"[1, 2]"};
    }
    void aDamagedFileIsKeptAndTheCopyUsed()
    {
        QFETCH(double, part);
        QFETCH(QByteArray, rest);
        const Desk desk;
        const QByteArray good = contentOf(desk.path);
        const QByteArray damaged = good.left(qsizetype(double(good.size()) * part)) + rest;
        QVERIFY(writeRaw(desk.path, damaged));
        SettingsFile file {desk.path};
        QCOMPARE(ProfileStore {file}.profiles().size(), 64);
        const QStringList aside = desk.entries().filter(QStringLiteral(".damaged-"));
        QCOMPARE(aside.size(), 1);
        QCOMPARE(contentOf(desk.folder.filePath(aside.first())), damaged);
        QVERIFY2(file.notice().contains(aside.first()), qPrintable(file.notice()));
        QCOMPARE(contentOf(desk.path), good);
        QCOMPARE(SettingsFile {desk.path}.notice(), QString());
    }

    /// What was changed meanwhile is not lost either.
    void damagedWhileTheProgramRuns()
    {
        const Desk desk;
        SettingsFile file {desk.path};
        QVERIFY(writeRaw(desk.path, "{"));
        QSignalSpy noticed {&file, &SettingsFile::noticed};
        ProfileStore {file}.save(cell(65));
        QVERIFY(noticed.wait());
        SettingsFile again {desk.path};
        QCOMPARE(ProfileStore {again}.profiles().size(), 65);
        QCOMPARE(desk.entries().filter(QStringLiteral(".damaged-")).size(), 1);
    }

    void aLostFileComesBack()
    {
        const Desk desk;
        QVERIFY(QFile::remove(desk.path));
        const SettingsFile file {desk.path};
        QCOMPARE(file.keys(QStringLiteral("profiles")).size(), 64);
        QVERIFY(!file.notice().isEmpty());
    }

    void bothAreDamaged()
    {
        const Desk desk;
        QVERIFY(writeRaw(desk.path, "{") && writeRaw(desk.path + QStringLiteral(".last-good"), "}"));
        const SettingsFile file {desk.path};
        QVERIFY(file.keys(QStringLiteral("profiles")).isEmpty());
        QVERIFY(file.notice().contains(QStringLiteral("no good copy")));
        QCOMPARE(desk.entries().filter(QStringLiteral(".damaged-")).size(), 1);
    }

    void twoProgramsLoseNothingOfEachOther()
    {
        const Desk desk {0};
        SettingsFile one {desk.path};
        SettingsFile other {desk.path};
        QSignalSpy oneSaved {&one, &SettingsFile::saved};
        one.setValue(QStringLiteral("profiles/1"), 1);
        QVERIFY(oneSaved.wait());
        QSignalSpy otherSaved {&other, &SettingsFile::saved};
        other.setValue(QStringLiteral("profiles/2"), 2);
        QVERIFY(otherSaved.wait());
        QCOMPARE(other.keys(QStringLiteral("profiles")).size(), 2);
        one.remove(QStringLiteral("profiles/1"));
        QVERIFY(oneSaved.wait());
        QCOMPARE(SettingsFile {desk.path}.keys(QStringLiteral("profiles")), QStringList {QStringLiteral("2")});
    }

    void whoHoldsTheLockHoldsNobodyUp()
    {
        const Desk desk {0};
        SettingsFile file {desk.path};
        QLockFile lock {desk.path + QStringLiteral(".lock")};
        QVERIFY(lock.lock());
        QSignalSpy failed {&file, &SettingsFile::failed};
        QSignalSpy recovered {&file, &SettingsFile::recovered};
        file.setValue(QStringLiteral("a"), 1);
        file.setValue(QStringLiteral("b"), 2);
        QCOMPARE(file.value(QStringLiteral("a")).toInt(), 1);
        QVERIFY(failed.wait(20000));
        QVERIFY(failed[0][0].toString().contains(QStringLiteral("another program")));
        QVERIFY(!file.isSaved());
        lock.unlock();
        QVERIFY(recovered.wait(20000));
        QTRY_COMPARE(SettingsFile {desk.path}.value(QStringLiteral("b")).toInt(), 2);
        QCOMPARE(failed.size(), 1);
        QVERIFY(file.trouble().isEmpty());
    }

    /// The end of the program says what it could not write.
    void whatIsLostAtTheEndIsSaid()
    {
        const Desk desk {0};
        QLockFile lock {desk.path + QStringLiteral(".lock")};
        QVERIFY(lock.lock());
        QTest::ignoreMessage(
            QtWarningMsg, QRegularExpression {QStringLiteral("could not be saved.*access/idleMinutes")});
        SettingsFile file {desk.path};
        file.setValue(QStringLiteral("access/idleMinutes"), 5);
    }

    void whatKillsLeftIsRemoved()
    {
        const Desk desk {0};
        const QStringList left {QStringLiteral("settings.json.AbCdEf"),
            QStringLiteral("settings.json.last-good.zzzzzz"), QStringLiteral("pendesk.conf.QwErTy")};
        const QStringList others {QStringLiteral("settings.json.damaged-1"), QStringLiteral("notes.AbCdEf")};
        for (const QString &name : left + others)
            QVERIFY(writeRaw(desk.folder.filePath(name), "x"));
        {
            SettingsFile file {desk.path};
            file.setValue(QStringLiteral("a"), 1);
        }
        for (const QString &name : left)
            QVERIFY2(!desk.entries().contains(name), qPrintable(name));
        for (const QString &name : others)
            QVERIFY2(desk.entries().contains(name), qPrintable(name));
    }

#ifdef Q_OS_UNIX
    void aFullDiskLeavesTheOldFile()
    {
        const Desk desk;
        const QByteArray good = contentOf(desk.path);
        SettingsFile file {desk.path};
        QSignalSpy failed {&file, &SettingsFile::failed};
        QSignalSpy recovered {&file, &SettingsFile::recovered};
        const auto former = std::signal(SIGXFSZ, SIG_IGN); // a write says so
        rlimit before {};
        QCOMPARE(::getrlimit(RLIMIT_FSIZE, &before), 0);
        rlimit little = before;
        little.rlim_cur = 4096;
        QCOMPARE(::setrlimit(RLIMIT_FSIZE, &little), 0);
        ProfileStore {file}.save(cell(65));
        const bool isSaid = failed.wait(20000);
        ::setrlimit(RLIMIT_FSIZE, &before);
        std::signal(SIGXFSZ, former);
        QVERIFY(isSaid);
        QCOMPARE(contentOf(desk.path), good);
        QVERIFY(recovered.wait(20000));
        SettingsFile again {desk.path};
        QCOMPARE(ProfileStore {again}.profiles().size(), 65);
    }

    void aPipeIsNotWaitedFor()
    {
        const QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("settings.json"));
        QCOMPARE(::mkfifo(QFile::encodeName(path).constData(), 0600), 0);
        QTest::ignoreMessage(QtWarningMsg, QRegularExpression {QStringLiteral("regular file")});
        const SettingsFile file {path};
        QVERIFY(file.notice().contains(QStringLiteral("regular file")));
    }
#endif

    /// As earlier versions wrote them, by QSettings.
    void theSettingsOfEarlierVersions_data()
    {
        QTest::addColumn<double>("part"); // of the INI file that is there
        QTest::newRow("whole") << 1.0;
        QTest::newRow("half") << 0.5;
    }
    void theSettingsOfEarlierVersions()
    {
        QFETCH(double, part);
        const QTemporaryDir folder;
        const QString earlier = folder.filePath(QStringLiteral("pendesk.conf"));
        {
            QSettings ini {earlier, QSettings::IniFormat};
            const QByteArray json = QJsonDocument {toJson(cell(4))}.toJson(QJsonDocument::Compact);
            ini.setValue(QStringLiteral("profiles/CELL%204%20%2F%20%C3%BC"), QString::fromUtf8(json));
            ini.setValue(QStringLiteral("connections/CELL%204%20%2F%20%C3%BC/readinessSeen"), true);
            ini.setValue(QStringLiteral("connections/CELL%204%20%2F%20%C3%BC/connected"),
                QStringLiteral("2026-03-01T12:00:00.000Z"));
            ini.setValue(QStringLiteral("notes/CELL%204%20%2F%20%C3%BC/names"), QStringLiteral("{\"B7\":\"Recipe\"}"));
            ini.setValue(QStringLiteral("access/idleMinutes"), 25);
            ini.setValue(QStringLiteral("access/passcodeSalt"), QByteArray {"0011"});
            ini.setValue(QStringLiteral("window/pagesInWindows"), QStringList {QStringLiteral("io")});
            ini.setValue(QStringLiteral("appearance/language"), QStringLiteral("de"));
        }
        const QByteArray text = contentOf(earlier);
        QVERIFY(writeRaw(earlier, text.left(qsizetype(double(text.size()) * part))));
        SettingsFile file {folder.filePath(QStringLiteral("settings.json"))};
        ProfileStore store {file};
        if (part < 1) {
            QVERIFY(!store.find(cell(4).name) && file.contains(QStringLiteral("access/idleMinutes")));
            QVERIFY2(file.notice().contains(earlier), qPrintable(file.notice()));
            return;
        }
        QCOMPARE(file.notice(), QString());
        auto stored = store.find(cell(4).name);
        QVERIFY(stored && !stored->id.isNull());
        stored->id = {};
        stored->folder.clear();
        QVERIFY(stored == cell(4));
        QVERIFY(store.isReadinessSeen(cell(4).name));
        QVERIFY(store.recent(1).first().connected.isValid());
        QCOMPARE(
            store.notes(cell(4).name).read(QStringLiteral("names")).value(u"B7").toString(), QStringLiteral("Recipe"));
        QCOMPARE(file.value(QStringLiteral("access/idleMinutes")).toInt(), 25);
        QCOMPARE(file.value(QStringLiteral("access/passcodeSalt")).toString(), QStringLiteral("0011"));
        QCOMPARE(store.pagesInWindows(), QStringList {QStringLiteral("io")});
        QCOMPARE(store.appearance().language, QStringLiteral("de"));
    }
};

QTEST_GUILESS_MAIN(TestSettingsFile)
#include "tst_settingsfile.moc"
