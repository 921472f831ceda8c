// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "disk/durable.h"
#include "files/zip.h"
#include <QDir>
#include <QTemporaryDir>
#include <QTest>
#include <archive.h>
#include <archive_entry.h>
#include <clocale>
#include <map>

namespace {

/// What another program would find in the file.
std::map<QString, QByteArray> unpacked(const QString &path)
{
    std::map<QString, QByteArray> found;
    archive *zip = archive_read_new();
    archive_read_support_format_zip(zip);
    archive_entry *entry = nullptr;
    if (archive_read_open_filename(zip, path.toUtf8().constData(), 10240) == ARCHIVE_OK) {
        while (archive_read_next_header(zip, &entry) == ARCHIVE_OK) {
            QByteArray content(archive_entry_size(entry), '\0');
            archive_read_data(zip, content.data(), size_t(content.size()));
            found[QString::fromUtf8(archive_entry_pathname_utf8(entry))] = content;
        }
    }
    archive_read_free(zip);
    return found;
}

} // namespace

class TestZip : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    /// The reader of this test puts names into the locale; the writer does not care.
    void initTestCase() { QVERIFY(std::setlocale(LC_ALL, "C.UTF-8")); }

    void everythingIsInIt()
    {
        const QTemporaryDir root;
        const QString bag = root.filePath(QStringLiteral("20261122T101500Z"));
        QVERIFY(QDir {}.mkpath(bag + QStringLiteral("/data")));
        const std::map<QString, QByteArray> expected {
            {QStringLiteral("20261122T101500Z/bagit.txt"), "BagIt-Version: 1.0\n"},
            {QStringLiteral("20261122T101500Z/data/EMPTY.DAT"), {}},
            {QStringLiteral("20261122T101500Z/data/WELD.JBI"), QByteArray("/JOB\r\n").repeated(100'000)},
            {QStringLiteral("20261122T101500Z/data/溶接.JBI"), QByteArray("\x00\xFF\x8A", 3)},
        };
        for (const auto &[name, content] : expected)
            QVERIFY(disk::writeNew(root.filePath(name), content));
        const QString zip = root.filePath(QStringLiteral("backup.zip"));
        const auto written = files::writeZip(bag, zip);
        QVERIFY2(written, written ? "" : qPrintable(written.error().detail));
        QVERIFY(unpacked(zip) == expected);
        QVERIFY(QFileInfo {zip}.size() < 100'000); // packed
    }

    /// Neither harms what stood there.
    void cannotBeWritten_data()
    {
        QTest::addColumn<QString>("target");
        QTest::newRow("no such folder") << QStringLiteral("nowhere/backup.zip");
        QTest::newRow("a folder stands there") << QStringLiteral("20261122T101500Z");
    }
    void cannotBeWritten()
    {
        QFETCH(QString, target);
        const QTemporaryDir root;
        const QString bag = root.filePath(QStringLiteral("20261122T101500Z"));
        QVERIFY(QDir {}.mkpath(bag));
        QVERIFY(disk::writeNew(bag + QStringLiteral("/bagit.txt"), "BagIt-Version: 1.0\n"));
        const auto written = files::writeZip(bag, root.filePath(target));
        QVERIFY(!written);
        QVERIFY(written.error().kind == values::ErrorKind::LocalFile);
        QVERIFY2(written.error().detail.contains(target), qPrintable(written.error().detail));
        QCOMPARE(QDir {root.path()}.entryList(QDir::Files), QStringList());
    }
};

QTEST_APPLESS_MAIN(TestZip)
#include "tst_zip.moc"
