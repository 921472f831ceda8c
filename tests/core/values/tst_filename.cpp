// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "values/filename.h"
#include <QTest>

using values::FileName;

class FileNameTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void creates_data();
    void creates();
    void batchBackup();
};

void FileNameTest::creates_data()
{
    QTest::addColumn<QByteArray>("bytes");
    QTest::addColumn<bool>("isName");
    QTest::addColumn<QByteArray>("base");
    QTest::addColumn<QByteArray>("extension");
    const auto good = [](const char *name, const QByteArray &bytes, const char *base, const char *extension) {
        QTest::newRow(name) << bytes << true << QByteArray(base) << QByteArray(extension);
    };
    const auto bad = [](const char *name, const QByteArray &bytes) {
        QTest::newRow(name) << bytes << false << QByteArray {} << QByteArray {};
    };
    good("job", "DEMO01.JBI", "DEMO01", "JBI");
    good("no extension", "DEMO01", "DEMO01", "");
    good("two dots", "A.B.JBI", "A.B", "JBI");
    good("longest", QByteArray(32, 'A') + ".JBI", "AAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAA", "JBI");
    good("space and minus", "A -1.JBI", "A -1", "JBI");
    good("shift-jis with a backslash byte", "\x83\x5c.JBI", "\x83\x5c", "JBI");
    bad("empty", "");
    bad("extension alone", ".JBI");
    bad("this folder", ".");
    bad("folder above", "..");
    bad("hidden", ".a.JBI");
    bad("too long", QByteArray(33, 'A') + ".JBI");
    bad("long extension", "A.123456789");
    bad("slash", "a/b.JBI");
    bad("path", "../../etc/passwd");
    bad("backslash", "a\\b.JBI");
    bad("backslash in front", "\\b.JBI");
    bad("wild card", "*.JBI");
    bad("question mark", "A?.JBI");
    bad("line feed", "A\n.JBI");
    bad("NUL", QByteArray("A\0.JBI", 6));
    bad("delete", "A\x7f.JBI");
}

void FileNameTest::creates()
{
    QFETCH(QByteArray, bytes);
    QFETCH(bool, isName);
    const auto name = FileName::create(bytes);
    QCOMPARE(name.has_value(), isName);
    if (!isName) {
        QCOMPARE(name.error().kind, values::ErrorKind::BadInput);
        return;
    }
    QCOMPARE(name->bytes(), bytes);
    QTEST(name->base().toByteArray(), "base");
    QTEST(name->extension().toByteArray(), "extension");
}

void FileNameTest::batchBackup() { QCOMPARE(FileName::batchBackup().bytes(), QByteArray("/SPDRV/CMOSBK.BIN")); }

QTEST_APPLESS_MAIN(FileNameTest)
#include "tst_filename.moc"
