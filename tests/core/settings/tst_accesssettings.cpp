// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "settings/accesssettings.h"
#include <QSettings>
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
        access.passcode = Passcode::of(QStringLiteral("ключ ☂"));
        {
            QSettings file {folder.filePath(QStringLiteral("a.ini")), QSettings::IniFormat};
            settings::writeAccess(file, access);
        }
        QSettings file {folder.filePath(QStringLiteral("a.ini")), QSettings::IniFormat};
        const AccessSettings read = settings::readAccess(file);
        QVERIFY(read == access);
        QVERIFY(read.passcode->matches(QStringLiteral("ключ ☂")));
        QVERIFY(!read.passcode->matches(QStringLiteral("ключ")));
        access.passcode.reset();
        settings::writeAccess(file, access);
        QVERIFY(!settings::readAccess(file).passcode);
    }

    void neverKeepsThePasscodeItself()
    {
        const Passcode first = Passcode::of(QStringLiteral("1234"));
        const Passcode second = Passcode::of(QStringLiteral("1234"));
        QVERIFY(first.salt != second.salt);
        QVERIFY(first.hash != second.hash);
        QVERIFY(!first.hash.contains("1234"));
        QCOMPARE(first.hash.size(), 32);
        QVERIFY(first.matches(QStringLiteral("1234")) && second.matches(QStringLiteral("1234")));
    }

    void damagedSettings_data()
    {
        QTest::addColumn<QVariant>("minutes");
        QTest::addColumn<QVariant>("hash");
        QTest::newRow("nothing") << QVariant {} << QVariant {};
        QTest::newRow("not a number") << QVariant {QStringLiteral("soon")} << QVariant {};
        QTest::newRow("never") << QVariant {0} << QVariant {};
        QTest::newRow("negative") << QVariant {-5} << QVariant {};
        QTest::newRow("too long") << QVariant {481} << QVariant {};
        QTest::newRow("empty hash") << QVariant {} << QVariant {QString()};
        QTest::newRow("not hexadecimal") << QVariant {} << QVariant {QStringLiteral("zz")};
    }

    /// A damaged passcode must not open the door.
    void damagedSettings()
    {
        QFETCH(QVariant, minutes);
        QFETCH(QVariant, hash);
        QTemporaryDir folder;
        QSettings file {folder.filePath(QStringLiteral("a.ini")), QSettings::IniFormat};
        if (minutes.isValid())
            file.setValue(QStringLiteral("access/idleMinutes"), minutes);
        if (hash.isValid())
            file.setValue(QStringLiteral("access/passcodeHash"), hash);
        const AccessSettings read = settings::readAccess(file);
        QVERIFY(read.idleTime == AccessSettings {}.idleTime);
        QCOMPARE(read.passcode.has_value(), hash.isValid());
        QVERIFY(!read.passcode || !read.passcode->matches(QString()));
    }
};

QTEST_GUILESS_MAIN(TestAccessSettings)
#include "tst_accesssettings.moc"
