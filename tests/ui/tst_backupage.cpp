// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "settings/settingsfile.h"
#include "ui/backupage.h"

#include "core/files/bagmaker.h"
#include "station/backupchoices.h"
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

using namespace ui;
using widgets::Lamp;
using widgets::Word;

/// What the tile of a controller says about its backups.
class TestBackupAge : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void says_data();
    void says();
    void looksForTheNewestCompleteOne();
};

void TestBackupAge::says_data()
{
    QTest::addColumn<qint64>("seconds"); // since it was taken
    QTest::addColumn<QString>("text");
    QTest::addColumn<bool>("isAbnormal");
    constexpr qint64 day = 86400;
    QTest::addRow("now") << qint64(0) << QStringLiteral("Backup 0 hour(s) old") << false;
    QTest::addRow("a clock that is ahead") << qint64(-5) << QStringLiteral("Backup 0 hour(s) old") << false;
    QTest::addRow("nearly a day") << day - 1 << QStringLiteral("Backup 23 hour(s) old") << false;
    QTest::addRow("a day") << day << QStringLiteral("Backup 1 day(s) old") << false;
    QTest::addRow("a week") << 7 * day << QStringLiteral("Backup 7 day(s) old") << false;
    QTest::addRow("more than a week") << 7 * day + 1 << QStringLiteral("Old backup: 7 day(s)") << true;
    QTest::addRow("months") << 100 * day << QStringLiteral("Old backup: 100 day(s)") << true;
}

void TestBackupAge::says()
{
    QFETCH(qint64, seconds);
    QFETCH(QString, text);
    QFETCH(bool, isAbnormal);
    const auto now = QDateTime::fromString(QStringLiteral("2026-02-01T00:00:00Z"), Qt::ISODate);
    const Word word = backupWord(now.addSecs(-seconds), now);
    QCOMPARE(word.text, text);
    QVERIFY(word.lamp == (isAbnormal ? Lamp::Warning : Lamp::None));
    QVERIFY((backupWord({}, now) == Word {QStringLiteral("No backup"), Lamp::Warning}));
}

void TestBackupAge::looksForTheNewestCompleteOne()
{
    const QTemporaryDir folder;
    settings::SettingsFile file {folder.filePath(QStringLiteral("settings.json"))};
    const settings::Notes notes {file, QStringLiteral("CELL 4")};
    station::writeBackupChoices(notes, {folder.path(), {3, 30}});
    QCOMPARE(station::readBackupChoices(notes).folder, folder.path());
    QCOMPARE(station::readBackupChoices(notes).retention.count, 3);
    QCOMPARE(station::readBackupChoices(notes).retention.days, 30);
    BackupAge age {QStringLiteral("CELL 4"), notes};
    QSignalSpy told {&age, &BackupAge::told};
    QVERIFY(told.wait());
    QCOMPARE(told[0][0].value<Word>().text, QStringLiteral("No backup"));
    const auto now = QDateTime::currentDateTimeUtc();
    const QString archive = folder.filePath(QStringLiteral("CELL 4"));
    QVERIFY(!makeBag(archive, now.addDays(-3), true).isEmpty());
    QVERIFY(!makeBag(archive, now.addDays(-1), false).isEmpty()); // a file is missing in it
    QTRY_COMPARE_WITH_TIMEOUT(told.last()[0].value<Word>().text, QStringLiteral("Backup 3 day(s) old"), 20000);
}

QTEST_MAIN(TestBackupAge)

#include "tst_backupage.moc"
