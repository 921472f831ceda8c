// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "disk/durable.h"

#include "core/files/filedesk.h"
#include <QDir>
#include <QFile>
#include <QIODevice>
#include <QTemporaryDir>
#include <QTest>
#include <sys/stat.h>

class TestDurable : public QObject
{
    Q_OBJECT

    QTemporaryDir m_folder;
    [[nodiscard]] QString path(const char *name) const { return m_folder.filePath(QLatin1String(name)); }
    [[nodiscard]] QStringList entries() const
    {
        return QDir {m_folder.path()}.entryList(QDir::Files | QDir::System | QDir::Hidden, QDir::Name);
    }

private Q_SLOTS:
    void replaces()
    {
        QVERIFY(disk::replaceFile(path("a"), "old"));
        QVERIFY(disk::replaceFile(path("a"), "new", disk::Readers::OwnerOnly));
        QCOMPARE(disk::readFile(path("a")).value_or("?"), "new");
        const auto owner = QFile::ReadOwner | QFile::WriteOwner | QFile::ReadUser | QFile::WriteUser;
        QCOMPARE(QFile::permissions(path("a")), owner);
        QCOMPARE(entries(), QStringList {QStringLiteral("a")});
    }

    void whatGoesWrongLeavesTheOldFile_data()
    {
        QTest::addColumn<qsizetype>("size");
        // What fits into the buffers of the library fails when it is flushed, the rest when it is written.
        QTest::newRow("within a buffer") << qsizetype(6000);
        QTest::newRow("many buffers") << qsizetype(3'000'000);
    }
    void whatGoesWrongLeavesTheOldFile()
    {
        QFETCH(qsizetype, size);
        QVERIFY(disk::replaceFile(path("full"), "old"));
        const QStringList before = entries();
        values::Result<void> written;
        {
            const FullDisk full {4096};
            written = disk::replaceFile(path("full"), QByteArray(size, 'x'));
        }
        QVERIFY(!written);
        QCOMPARE(written.error().kind, values::ErrorKind::LocalFile);
        QVERIFY2(written.error().detail.contains(QStringLiteral("File too large")), qPrintable(written.error().detail));
        QCOMPARE(disk::readFile(path("full")).value_or("?"), "old");
        QCOMPARE(entries(), before);
    }

    void anErrorOfTheWriterLeavesTheOldFile()
    {
        QVERIFY(disk::replaceFile(path("half"), "old"));
        const auto written = disk::replaceFile(path("half"), [](QIODevice &file) -> values::Result<void> {
            file.write("half");
            return values::badInput(QStringLiteral("why"));
        });
        QVERIFY(!written);
        QCOMPARE(written.error().detail, QStringLiteral("why"));
        QCOMPARE(disk::readFile(path("half")).value_or("?"), "old");
    }

    void regularFilesAlone()
    {
        QCOMPARE(::mkfifo(QFile::encodeName(path("pipe")).constData(), 0600), 0);
        for (const QString &name : {path("pipe"), m_folder.path(), QStringLiteral("/dev/zero")}) {
            const auto read = disk::readFile(name);
            QVERIFY2(!read, qPrintable(name));
            QVERIFY(read.error().detail.contains(QStringLiteral("regular file")));
            QVERIFY(!disk::replaceFile(name, "x"));
        }
        QVERIFY(!disk::readFile(path("nothing")));
        QVERIFY(!disk::replaceFile(path("no/folder"), "x"));
    }
};

QTEST_GUILESS_MAIN(TestDurable)
#include "tst_durable.moc"
