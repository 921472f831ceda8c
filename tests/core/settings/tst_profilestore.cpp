// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "settings/profilestore.h"
#include <QSettings>
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
        const QString path = folder.filePath(QStringLiteral("settings.ini"));
        {
            QSettings file {path, QSettings::IniFormat};
            ProfileStore store {file};
            store.save(weldCell());
            auto other = weldCell();
            other.name = QStringLiteral("A");
            store.save(other);
            store.setLastUsed(other.name);
        }
        QSettings file {path, QSettings::IniFormat};
        ProfileStore store {file};
        QCOMPARE(store.profiles().size(), 2);
        QCOMPARE(store.profiles().first().name, QStringLiteral("A"));
        QVERIFY(store.find(weldCell().name) == weldCell());
        QCOMPARE(store.lastUsed(), QStringLiteral("A"));
        store.remove(QStringLiteral("A"));
        QVERIFY(!store.find(QStringLiteral("A")));
        QCOMPARE(store.profiles().size(), 1);
    }

    void aDamagedEntryIsLeftAlone()
    {
        QTemporaryDir folder;
        QSettings file {folder.filePath(QStringLiteral("settings.ini")), QSettings::IniFormat};
        file.setValue(QStringLiteral("profiles/broken"), QStringLiteral("{\"name\": "));
        ProfileStore store {file};
        store.save(weldCell());
        QCOMPARE(store.profiles().size(), 1);
        QVERIFY(file.contains(QStringLiteral("profiles/broken")));
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
