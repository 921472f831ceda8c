// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "settings/accesssettings.h"
#include "settings/settingsfile.h"
#include <QTemporaryDir>
#include <QTest>

using namespace std::chrono_literals;
using settings::AccessSettings;
using settings::Passcode;

class TestAccessSettings : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void keepsWhatWasWritten()
    {
        QTemporaryDir folder;
        AccessSettings access;
        access.idleTime = 3min;
        access.passcode = Passcode::of(QStringLiteral("ключ ☂"), 1000);
        {
            settings::SettingsFile file {folder.filePath(QStringLiteral("a.json"))};
            settings::writeAccess(file, access);
        }
        settings::SettingsFile file {folder.filePath(QStringLiteral("a.json"))};
        const AccessSettings read = settings::readAccess(file);
        QVERIFY(read == access);
        QVERIFY(read.passcode->matches(QStringLiteral("ключ ☂")));
        QVERIFY(!read.passcode->matches(QStringLiteral("ключ")));
        access.passcode.reset();
        settings::writeAccess(file, access);
        QVERIFY(!settings::readAccess(file).passcode);
    }

    /// The vectors are those of RFC 7914, section 11: PBKDF2-HMAC-SHA-256 of "passwd" and "Password", 64 bytes, of
    /// which the first 32 are what a key of 32 bytes is.
    void isPbkdf2WithSha256_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QByteArray>("salt");
        QTest::addColumn<int>("iterations");
        QTest::addColumn<QByteArray>("hash");
        QTest::newRow("once") << QStringLiteral("passwd") << QByteArray {"salt"} << 1
                              << QByteArray {"55ac046e56e3089fec1691c22544b605f94185216dde0465e68b9d57c20dacbc"};
        QTest::newRow("80000 times") << QStringLiteral("Password") << QByteArray {"NaCl"} << 80'000
                                     << QByteArray {"4ddcd8f60b98be21830cee5ef22701f9641a4418d04c0414aeff08876b34ab56"};
    }
    void isPbkdf2WithSha256()
    {
        QFETCH(QString, text);
        QFETCH(QByteArray, salt);
        QFETCH(int, iterations);
        QFETCH(QByteArray, hash);
        const Passcode passcode {salt, QByteArray::fromHex(hash), iterations};
        QVERIFY(passcode.matches(text));
        QVERIFY(!passcode.matches(text + u' '));
        Passcode turned = passcode;
        turned.hash[31] = char(turned.hash[31] ^ 1);
        QVERIFY(!turned.matches(text));
    }

    /// A passcode of a version that kept no number had 20,000 iterations. It opens, and is due to be made anew.
    void aPasscodeOfEarlierVersions()
    {
        QTemporaryDir folder;
        settings::SettingsFile file {folder.filePath(QStringLiteral("a.json"))};
        const Passcode earlier = Passcode::of(QStringLiteral("1234"), 20'000);
        file.setValue(QStringLiteral("access/passcodeSalt"), QString::fromLatin1(earlier.salt.toHex()));
        file.setValue(QStringLiteral("access/passcodeHash"), QString::fromLatin1(earlier.hash.toHex()));
        const AccessSettings read = settings::readAccess(file);
        QVERIFY(read.passcode && read.passcode->matches(QStringLiteral("1234")));
        QVERIFY(read.passcode->isOutdated());
        QVERIFY(!Passcode {}.isOutdated());
    }

    void neverKeepsThePasscodeItself()
    {
        const Passcode first = Passcode::of(QStringLiteral("1234"), 1000);
        const Passcode second = Passcode::of(QStringLiteral("1234"), 1000);
        QVERIFY(first.salt != second.salt);
        QVERIFY(first.hash != second.hash);
        QVERIFY(!first.hash.contains("1234"));
        QCOMPARE(first.hash.size(), 32);
        QVERIFY(first.matches(QStringLiteral("1234")) && second.matches(QStringLiteral("1234")));
    }

    void damagedSettings_data()
    {
        QTest::addColumn<QJsonValue>("minutes");
        QTest::addColumn<QJsonValue>("hash");
        const QJsonValue none {QJsonValue::Undefined};
        QTest::newRow("nothing") << none << none;
        QTest::newRow("not a number") << QJsonValue {QStringLiteral("soon")} << none;
        QTest::newRow("never") << QJsonValue {0} << none;
        QTest::newRow("negative") << QJsonValue {-5} << none;
        QTest::newRow("too long") << QJsonValue {481} << none;
        QTest::newRow("empty hash") << none << QJsonValue {QString()};
        QTest::newRow("not hexadecimal") << none << QJsonValue {QStringLiteral("zz")};
        QTest::newRow("half a hash") << none << QJsonValue {QStringLiteral("00112233445566778899aabbccddeeff")};
        QTest::newRow("a hash that is a number") << none << QJsonValue {17};
    }

    /// A damaged passcode must not open the door.
    void damagedSettings()
    {
        QFETCH(QJsonValue, minutes);
        QFETCH(QJsonValue, hash);
        QTemporaryDir folder;
        settings::SettingsFile file {folder.filePath(QStringLiteral("a.json"))};
        if (!minutes.isUndefined())
            file.setValue(QStringLiteral("access/idleMinutes"), minutes);
        if (!hash.isUndefined())
            file.setValue(QStringLiteral("access/passcodeHash"), hash);
        const AccessSettings read = settings::readAccess(file);
        QVERIFY(read.idleTime == AccessSettings {}.idleTime);
        QCOMPARE(read.passcode.has_value(), !hash.isUndefined());
        QVERIFY(!read.passcode || !read.passcode->matches(QString()));
    }
};

QTEST_GUILESS_MAIN(TestAccessSettings)
#include "tst_accesssettings.moc"
