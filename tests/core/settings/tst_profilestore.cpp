// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "settings/profilestore.h"
#include "settings/settingsfile.h"
#include "values/utc.h"
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QTest>

using namespace std::chrono_literals;
using namespace settings;

namespace {

Profile weldCell()
{
    Profile profile;
    profile.name = QStringLiteral("CELL 4 / Schweißen 溶接");
    profile.host = QStringLiteral("192.168.1.31");
    profile.port = 20040;
    profile.model = protocol::Model::FS100;
    profile.readTimeout = 450ms;
    profile.window = 4;
    profile.encoding = protocol::Encoding::ShiftJis;
    profile.numbering = protocol::Numbering::FromOne;
    profile.motion.toolSpeed = 50;
    profile.motion.stepPulses = 200;
    profile.motion.box = motion::Box {{500, -400, 0}, {1400.5, 400, 1200}};
    profile.motion.areFramesChecked = true;
    return profile;
}

/// Without what the store has added.
Profile bare(const std::optional<Profile> &stored)
{
    Profile profile = stored.value_or(Profile {});
    profile.id = {};
    profile.folder.clear();
    return profile;
}

} // namespace

class TestProfileStore : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void whatIsSavedIsFoundAgain()
    {
        QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("settings.json"));
        {
            settings::SettingsFile file {path};
            ProfileStore store {file};
            store.save(weldCell());
            auto other = weldCell();
            other.name = QStringLiteral("A");
            store.save(other);
            store.setLastUsed(other.name);
        }
        settings::SettingsFile file {path};
        ProfileStore store {file};
        QCOMPARE(store.profiles().size(), 2);
        QCOMPARE(store.profiles().first().name, QStringLiteral("A"));
        QVERIFY(bare(store.find(weldCell().name)) == weldCell());
        QCOMPARE(store.lastUsed(), QStringLiteral("A"));
        store.remove(QStringLiteral("A"));
        QVERIFY(!store.find(QStringLiteral("A")));
        QCOMPARE(store.profiles().size(), 1);
    }

    /// Another name is another label: everything that is kept goes on.
    void renamingKeepsWhatIsKept()
    {
        QTemporaryDir folder;
        settings::SettingsFile file {folder.filePath(QStringLiteral("settings.json"))};
        ProfileStore store {file};
        Profile profile = store.save(weldCell());
        QVERIFY(!profile.id.isNull());
        QCOMPARE(profile.folderName(), weldCell().name);
        store.setLastUsed(profile.name);
        store.setReadinessSeen(profile.name);
        store.noteConnected(profile.name, values::utc({2026, 3, 1}, {12, 0}));
        store.notes(profile).write(QStringLiteral("names"), {{QStringLiteral("B7"), QStringLiteral("Recipe")}});
        profile.name = QStringLiteral("CELL 5");
        store.save(profile);
        QCOMPARE(store.profiles().size(), 1);
        const auto renamed = store.find(QStringLiteral("CELL 5"));
        QVERIFY(renamed && renamed->id == profile.id);
        QCOMPARE(renamed->folderName(), weldCell().name); // no file has moved
        QCOMPARE(renamed->formerNames, QStringList {weldCell().name});
        QCOMPARE(store.lastUsed(), QStringLiteral("CELL 5"));
        QVERIFY(store.isReadinessSeen(QStringLiteral("CELL 5")));
        QVERIFY(store.recent(1).first().connected.isValid());
        QCOMPARE(store.notes(*renamed).read(QStringLiteral("names")).value(u"B7").toString(), QStringLiteral("Recipe"));
        profile = *renamed;
        profile.name = weldCell().name; // and back
        QCOMPARE(store.save(profile).formerNames, QStringList {QStringLiteral("CELL 5")});
        Profile second = weldCell(); // another one beside it, which was never here
        second.name = QStringLiteral("CELL 5");
        QVERIFY(store.save(second).id != profile.id);
    }

    /// As settings were kept before profiles had ids.
    void whatGoesByNamesIsTakenOver()
    {
        QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("settings.json"));
        QUuid id;
        {
            settings::SettingsFile file {path};
            const QString key = QStringLiteral("CELL%204");
            Profile profile = weldCell();
            profile.name = QStringLiteral("CELL 4");
            file.setValue(QStringLiteral("profiles/") + key, toJson(profile));
            file.setValue(QStringLiteral("notes/%1/names").arg(key), QJsonObject {{QStringLiteral("B7"), 1}});
            file.setValue(QStringLiteral("connections/%1/readinessSeen").arg(key), true);
            file.setValue(QStringLiteral("lastProfile"), profile.name);
            ProfileStore store {file};
            QCOMPARE(store.profiles().size(), 1);
            id = store.profiles().first().id;
            QVERIFY(!id.isNull());
            QVERIFY(bare(store.find(QStringLiteral("CELL 4"))) == profile);
            QCOMPARE(store.find(id)->folderName(), QStringLiteral("CELL 4"));
            QCOMPARE(store.notes(QStringLiteral("CELL 4")).read(QStringLiteral("names")).value(u"B7").toInt(), 1);
            QVERIFY(store.isReadinessSeen(QStringLiteral("CELL 4")));
            QCOMPARE(store.lastUsed(), QStringLiteral("CELL 4"));
            QVERIFY(!file.contains(QStringLiteral("profiles/") + key));
        }
        settings::SettingsFile file {path};
        const ProfileStore again {file};
        QCOMPARE(again.profiles().size(), 1);
        QVERIFY(again.profiles().first().id == id); // once and for all
    }

    /// The one that answered last first; those that never did by their names.
    void recentControllers()
    {
        QTemporaryDir folder;
        settings::SettingsFile file {folder.filePath(QStringLiteral("settings.json"))};
        ProfileStore store {file};
        QVERIFY(store.recent(5).isEmpty());
        for (const char *name : {"D", "C", "B", "A/ü"}) {
            Profile profile = weldCell();
            profile.name = QString::fromUtf8(name);
            store.save(profile);
        }
        const QDateTime noon = values::utc({2026, 3, 1}, {12, 0});
        store.noteConnected(QStringLiteral("B"), noon);
        store.noteConnected(QStringLiteral("D"), noon.addSecs(1));
        store.noteConnected(QStringLiteral("B"), noon.addMSecs(1500).toLocalTime());
        store.noteConnected(QStringLiteral("nobody"), noon);
        const auto names = [&store](int most) {
            QStringList result;
            for (const RecentProfile &recent : store.recent(most))
                result << recent.profile.name;
            return result;
        };
        QCOMPARE(names(5),
            (QStringList {QStringLiteral("B"), QStringLiteral("D"), QStringLiteral("A/ü"), QStringLiteral("C")}));
        QCOMPARE(names(2), (QStringList {QStringLiteral("B"), QStringLiteral("D")}));
        QCOMPARE(store.recent(1).first().connected, noon.addMSecs(1500));
        QVERIFY(!store.recent(3).last().connected.isValid());
        store.remove(QStringLiteral("B"));
        QCOMPARE(names(1), QStringList {QStringLiteral("D")});
        store.save(weldCell());
        QVERIFY(!file.contains(QStringLiteral("connections/nobody/connected")));
    }

    void readinessIsSeenOnce()
    {
        QTemporaryDir folder;
        settings::SettingsFile file {folder.filePath(QStringLiteral("settings.json"))};
        ProfileStore store {file};
        store.save(weldCell());
        const QString name = weldCell().name;
        QVERIFY(!store.isReadinessSeen(name));
        store.setReadinessSeen(name);
        QVERIFY(store.isReadinessSeen(name));
        QVERIFY(!store.isReadinessSeen(QStringLiteral("other")));
        store.remove(name); // another controller may get the name
        QVERIFY(!store.isReadinessSeen(name));
    }

    void aDamagedEntryIsLeftAlone()
    {
        QTemporaryDir folder;
        settings::SettingsFile file {folder.filePath(QStringLiteral("settings.json"))};
        file.setValue(QStringLiteral("profiles/broken"), QStringLiteral("{\"name\": "));
        ProfileStore store {file};
        store.save(weldCell());
        QCOMPARE(store.profiles().size(), 1);
        QVERIFY(file.contains(QStringLiteral("profiles/broken")));
    }

    /// They stay, and nothing moves: a profile is more than its limits.
    void limitsThatCannotBeUnderstood_data()
    {
        QTest::addColumn<QByteArray>("motion");
        QTest::newRow("a word") << QByteArray {R"({"toolSpeed": "fast"})"};
        QTest::newRow("NaN as text") << QByteArray {R"({"stepLength": "NaN"})"};
        QTest::newRow("negative") << QByteArray {R"({"jointSpeed": -1})"};
        QTest::newRow("0") << QByteArray {R"({"rotationSpeed": 0})"};
        QTest::newRow("null") << QByteArray {R"({"stepAngle": null})"};
        QTest::newRow("a box without inside") << QByteArray {R"({"box": {"least": [0, 0, 0], "most": [1, 0, 1]}})"};
        QTest::newRow("half a box") << QByteArray {R"({"box": {"least": [0, 0, 0]}})"};
        QTest::newRow("a box of words") << QByteArray {R"({"box": "small"})"};
    }
    void limitsThatCannotBeUnderstood()
    {
        QFETCH(QByteArray, motion);
        QJsonObject json = toJson(weldCell());
        json[QStringLiteral("motion")] = QJsonDocument::fromJson(motion).object();
        const auto profile = profileFromJson(json);
        QVERIFY(profile);
        QVERIFY(!motion::limits(profile->motion));
    }
    void limitsAboveTheCeilingAreLowered()
    {
        QJsonObject json = toJson(weldCell());
        json[QStringLiteral("motion")] = QJsonObject {{QStringLiteral("toolSpeed"), 1000}};
        QCOMPARE(motion::limits(profileFromJson(json)->motion)->toolSpeed, 250.0);
        json.remove(QStringLiteral("motion"));
        QCOMPARE(motion::limits(profileFromJson(json)->motion)->toolSpeed, 250.0);
    }

    void badValues_data()
    {
        QTest::addColumn<QString>("key");
        QTest::addColumn<QJsonValue>("value");
        QTest::newRow("no name") << QStringLiteral("name") << QJsonValue(QString());
        QTest::newRow("blank host") << QStringLiteral("host") << QJsonValue(QStringLiteral("  "));
        QTest::newRow("unknown model") << QStringLiteral("model") << QJsonValue(QStringLiteral("NX100"));
        QTest::newRow("unknown encoding") << QStringLiteral("encoding") << QJsonValue(QStringLiteral("EBCDIC"));
        QTest::newRow("numbering 2") << QStringLiteral("numbering") << QJsonValue(2);
        QTest::newRow("port 0") << QStringLiteral("port") << QJsonValue(0);
        QTest::newRow("port 65536") << QStringLiteral("port") << QJsonValue(65536);
        QTest::newRow("port in words") << QStringLiteral("port") << QJsonValue(QStringLiteral("10040"));
        QTest::newRow("half a port") << QStringLiteral("filePort") << QJsonValue(10041.5);
        QTest::newRow("time-out 19") << QStringLiteral("readTimeoutMs") << QJsonValue(19);
        QTest::newRow("time-out missing") << QStringLiteral("readTimeoutMs") << QJsonValue();
        QTest::newRow("negative repeats") << QStringLiteral("readRepeats") << QJsonValue(-1);
        QTest::newRow("window 9") << QStringLiteral("window") << QJsonValue(9);
        QTest::newRow("no ceiling") << QStringLiteral("requestsPerSecond") << QJsonValue(0);
    }

    void badValues()
    {
        QFETCH(QString, key);
        QFETCH(QJsonValue, value);
        QJsonObject json = toJson(weldCell());
        QVERIFY(profileFromJson(json));
        json[key] = value;
        const auto profile = profileFromJson(json);
        QVERIFY(!profile);
        QCOMPARE(profile.error().kind, values::ErrorKind::BadInput);
        QVERIFY(profile.error().detail.endsWith(u'.'));
    }
};

QTEST_GUILESS_MAIN(TestProfileStore)
#include "tst_profilestore.moc"
