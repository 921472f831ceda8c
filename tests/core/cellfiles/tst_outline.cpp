// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "cellfiles/outline.h"
#include <QTest>

using namespace cellfiles;

class OutlineTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void splits();
    void warns_data();
    void warns();
    void readsFixed_data();
    void readsFixed();
    void readsIntegers_data();
    void readsIntegers();
};

void OutlineTest::splits()
{
    const QByteArray file = "//TOOL 1\r\n///CRC 99\r\n///NAME GRIPPER A\r\n1,2\r\n\r\n";
    Warnings warnings;
    const Outline outline = outlineOf(file, warnings);
    QVERIFY(warnings.isEmpty());
    QCOMPARE(int(outline.blocks.size()), 2);
    QCOMPARE(outline.blocks[0].word, QByteArrayView {"TOOL"});
    QCOMPARE(outline.blocks[0].text, QByteArrayView {"1"});
    QCOMPARE(outline.blocks[0].crc, QByteArrayView {"99"});
    QCOMPARE(outline.blocks[1].text, QByteArrayView {"GRIPPER A"});
    QCOMPARE(outline.blocks[1].line, 3);
    QCOMPARE(int(outline.blocks[1].rows.size()), 2); // an empty line is a row: position may count
    QCOMPARE(outline.blocks[1].rows[0].number, 4);
}

void OutlineTest::warns_data()
{
    QTest::addColumn<QByteArray>("file");
    QTest::addColumn<QList<int>>("lines");
    QTest::newRow("good") << QByteArray("//A\r\n1\r\n") << QList<int> {};
    QTest::newRow("empty") << QByteArray() << QList<int> {0};
    QTest::newRow("line feeds") << QByteArray("//A\n1\n") << QList<int> {0};
    QTest::newRow("cut") << QByteArray("//A\r\n1\r\n2") << QList<int> {3};
    QTest::newRow("NUL") << QByteArray("//A\r\n\0\0\r\n\0\r\n", 12) << QList<int> {2};
    QTest::newRow("too long") << QByteArray(longestFile + 1, 'x') << QList<int> {0};
}

void OutlineTest::warns()
{
    QFETCH(QByteArray, file);
    Warnings warnings;
    (void)outlineOf(file, warnings);
    QList<int> found;
    for (const Warning &warning : warnings.list()) {
        found << warning.line;
        QVERIFY2(warning.reason.endsWith(u'.'), qPrintable(warning.reason));
    }
    QTEST(found, "lines");
}

void OutlineTest::readsFixed_data()
{
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<int>("decimals");
    QTest::addColumn<qint64>("value");
    QTest::addColumn<QString>("again"); // empty: it is no number
    QTest::newRow("length") << QByteArray("163.250") << 3 << qint64 {163250} << QStringLiteral("163.250");
    QTest::newRow("negative") << QByteArray("-0.25") << 4 << qint64 {-2500} << QStringLiteral("-0.2500");
    QTest::newRow("whole") << QByteArray("7") << 3 << qint64 {7000} << QStringLiteral("7.000");
    QTest::newRow("no decimals") << QByteArray("-12") << 0 << qint64 {-12} << QStringLiteral("-12");
    QTest::newRow("too many decimals") << QByteArray("1.2345") << 3 << qint64 {0} << QString {};
    QTest::newRow("empty") << QByteArray() << 3 << qint64 {0} << QString {};
    QTest::newRow("a point") << QByteArray(".") << 3 << qint64 {0} << QString {};
    QTest::newRow("a sign") << QByteArray("-") << 3 << qint64 {0} << QString {};
    QTest::newRow("sign behind the point") << QByteArray("1.-2") << 3 << qint64 {0} << QString {};
    QTest::newRow("letters") << QByteArray("1e3") << 3 << qint64 {0} << QString {};
    QTest::newRow("endless") << QByteArray(60, '9') << 3 << qint64 {0} << QString {};
}

void OutlineTest::readsFixed()
{
    QFETCH(QByteArray, text);
    QFETCH(int, decimals);
    QFETCH(QString, again);
    const auto value = fixedFrom(text, decimals);
    QCOMPARE(value.has_value(), !again.isEmpty());
    if (value) {
        QTEST(*value, "value");
        QCOMPARE(fixedText(*value, decimals), again);
    }
}

void OutlineTest::readsIntegers_data()
{
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<bool>("isWord");
    QTest::newRow("least") << QByteArray("-2147483648") << true;
    QTest::newRow("most") << QByteArray("2147483647") << true;
    QTest::newRow("below") << QByteArray("-2147483649") << false;
    QTest::newRow("above") << QByteArray("2147483648") << false;
    QTest::newRow("blanks") << QByteArray(" 12 ") << true;
    QTest::newRow("word") << QByteArray("oops") << false;
    QTest::newRow("two") << QByteArray("1 2") << false;
}

void OutlineTest::readsIntegers()
{
    QFETCH(QByteArray, text);
    QTEST(wordFrom(text).has_value(), "isWord");
}

QTEST_APPLESS_MAIN(OutlineTest)
#include "tst_outline.moc"
