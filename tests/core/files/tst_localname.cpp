// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "files/localname.h"

#include <QTest>
#include <random>

using namespace files;
using values::FileName;

/// What a controller calls its files never becomes a path that leads elsewhere, or a name that is lost.
class TestLocalName : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void writes_data();
    void writes();
    void rejects_data();
    void rejects();
    void comesBack();
    void tellsCasesApart();
    void namesFolders_data();
    void namesFolders();
};

void TestLocalName::writes_data()
{
    QTest::addColumn<QByteArray>("name");
    QTest::addColumn<QString>("local");
    QTest::addRow("plain") << QByteArray("WELD_A12.JBI") << QStringLiteral("WELD_A12.JBI");
    QTest::addRow("device") << QByteArray("CON") << QStringLiteral("%43ON");
    QTest::addRow("device with extension") << QByteArray("con.JBI") << QStringLiteral("%63on.JBI");
    QTest::addRow("nearly a device") << QByteArray("CONS.JBI") << QStringLiteral("CONS.JBI");
    QTest::addRow("trailing dot") << QByteArray("A.") << QStringLiteral("A%2E");
    QTest::addRow("two dots") << QByteArray("A..B") << QStringLiteral("A.%2EB");
    QTest::addRow("blank") << QByteArray("A B.JBI") << QStringLiteral("A%20B.JBI");
    QTest::addRow("trailing blank") << QByteArray("A ") << QStringLiteral("A%20");
    QTest::addRow("percent") << QByteArray("100%.JBI") << QStringLiteral("100%25.JBI");
    QTest::addRow("colon") << QByteArray("C:A.JBI") << QStringLiteral("C%3AA.JBI");
    QTest::addRow("Shift-JIS") << QByteArray("\x83\x5C.JBI") << QStringLiteral("%83%5C.JBI");
    QTest::addRow("tilde") << QByteArray("~A.JBI") << QStringLiteral("%7EA.JBI");
}

void TestLocalName::writes()
{
    QFETCH(QByteArray, name);
    QFETCH(QString, local);
    const auto fileName = FileName::create(name);
    QVERIFY(fileName);
    QCOMPARE(toLocalName(name), local);
    QVERIFY(fromLocalName(local) == *fileName);
}

void TestLocalName::rejects_data()
{
    QTest::addColumn<QString>("local");
    QTest::addRow("empty") << QString();
    QTest::addRow("up") << QStringLiteral("..");
    QTest::addRow("hidden path") << QStringLiteral("..%2F..%2Fetc%2Fpasswd");
    QTest::addRow("backslash") << QStringLiteral("A%5CB");
    QTest::addRow("needlessly escaped") << QStringLiteral("A%42.JBI");
    QTest::addRow("lower-case escape") << QStringLiteral("A%2e");
    QTest::addRow("not escaped") << QStringLiteral("A B.JBI");
    QTest::addRow("zero") << QStringLiteral("A%00.JBI");
    QTest::addRow("beyond Latin-1") << QStringLiteral("ロ.JBI");
    QTest::addRow("too long") << QString(200, u'A');
}

void TestLocalName::rejects()
{
    QFETCH(QString, local);
    QVERIFY(!fromLocalName(local));
}

void TestLocalName::comesBack()
{
    std::mt19937 random {3};
    int tried = 0;
    while (tried < 5000) {
        QByteArray bytes;
        for (auto left = 1 + random() % 36; left > 0; --left)
            bytes += char(random() % 4 ? "ABCcon.. %1"[random() % 11] : char(random() % 256));
        const auto name = FileName::create(bytes);
        if (!name)
            continue;
        ++tried;
        const QString local = toLocalName(bytes);
        QVERIFY2(fromLocalName(local) == *name, qPrintable(local));
        QVERIFY(local.size() < 200 && !local.endsWith(u'.') && !local.endsWith(u' ') && !local.contains(u'/'));
    }
}

void TestLocalName::tellsCasesApart()
{
    LocalNames names;
    QSet<QString> taken;
    for (const char *bytes : {"WELD.JBI", "weld.jbi", "Weld.JBI", "WELD2.JBI"}) {
        const auto name = *FileName::create(bytes);
        const QString local = names.take(name);
        QVERIFY2(!taken.contains(local.toLower()), qPrintable(local));
        taken.insert(local.toLower());
        QVERIFY(fromLocalName(local) == name);
    }
}

void TestLocalName::namesFolders_data()
{
    QTest::addColumn<QString>("controller");
    QTest::addColumn<QString>("folder");
    QTest::addRow("plain") << QStringLiteral("CELL 4 · Weld") << QStringLiteral("CELL 4 · Weld");
    QTest::addRow("letters") << QStringLiteral("溶接") << QStringLiteral("溶接");
    QTest::addRow("path") << QStringLiteral("../../etc") << QStringLiteral("%2E.%2F..%2Fetc");
    QTest::addRow("up") << QStringLiteral("..") << QStringLiteral("%2E%2E");
    QTest::addRow("device") << QStringLiteral("nul") << QStringLiteral("%6Eul");
    QTest::addRow("address") << QStringLiteral("192.168.1.31") << QStringLiteral("192.168.1.31");
    QTest::addRow("nothing") << QString() << QStringLiteral("%00");
    QTest::addRow("dot at the end") << QStringLiteral("A.") << QStringLiteral("A%2E");
}

void TestLocalName::namesFolders()
{
    QFETCH(QString, controller);
    QFETCH(QString, folder);
    QCOMPARE(toFolderName(controller), folder);
}

QTEST_GUILESS_MAIN(TestLocalName)

#include "tst_localname.moc"
