// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "cellfiles/signalnames.h"
#include "support/samples.h"
#include <QTest>

using namespace cellfiles;
using variables::Kind;
using variables::Reference;

class SignalNamesTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void readsSignals_data();
    void readsSignals();
    void countsRows();
    void otherEncodings();
    void readsRegisters();
    void readsVariables_data();
    void readsVariables();
    void keepsEveryNameOfANumber();
    void readsTimers();
    void survivesEveryCut();
    void numbersSignals_data();
    void numbersSignals();
};

void SignalNamesTest::readsSignals_data()
{
    QTest::addColumn<QString>("path");
    QTest::addColumn<int>("number"); // logical
    QTest::addColumn<QString>("name");
    const QString yrc = QStringLiteral("yrc1000/IONAME.DAT");
    QTest::newRow("IN 1") << yrc << 10 << QStringLiteral("CYCLE START");
    QTest::newRow("IN 2") << yrc << 11 << QStringLiteral("PART PRESENT");
    QTest::newRow("IN 3") << yrc << 12 << QString {};
    QTest::newRow("IN 8") << yrc << 17 << QStringLiteral("GUARD CLOSED");
    QTest::newRow("IN 9") << yrc << 20 << QStringLiteral("GRIP OPEN LS");
    QTest::newRow("IN 17") << yrc << 30 << QStringLiteral("AIR OK");
    QTest::newRow("OUT 1") << yrc << 10010 << QStringLiteral("GRIP CLOSE");
    QTest::newRow("OUT 4") << yrc << 10013 << QStringLiteral("LAMP GREEN");
    QTest::newRow("OUT 10") << yrc << 10021 << QStringLiteral("MASTER AT HOME");
    const QString external = QStringLiteral("yrc1000/EXIONAME.DAT");
    QTest::newRow("external in") << external << 20010 << QStringLiteral("PLC HEARTBEAT");
    QTest::newRow("external out") << external << 30017 << QStringLiteral("ROBOT READY");
    QTest::newRow("DX100, half as long") << QStringLiteral("dx100/IONAME.DAT") << 10021
                                         << QStringLiteral("MASTER AT HOME");
    QTest::newRow("FS100 OUT 897") << QStringLiteral("fs100/IONAME.DAT") << 11130 << QStringLiteral("AUX READY");
    QTest::newRow("short IN 7") << QStringLiteral("names/IONAME.DAT") << 16 << QStringLiteral("PART");
    QTest::newRow("short OUT 1") << QStringLiteral("names/IONAME.DAT") << 10010 << QStringLiteral("VALVE 1");
}

void SignalNamesTest::readsSignals()
{
    QFETCH(QString, path);
    QFETCH(int, number);
    const QByteArray file = samples::read(path);
    const auto parsed = signalNamesFrom(file, samples::codec());
    QCOMPARE(parsed.warnings.count(), 0);
    QTEST(parsed.value.names.value(number), "name");
}

void SignalNamesTest::countsRows()
{
    // Names of an area of 10,000 rows: the surplus is warned of, and no name gets a number of the next area.
    QByteArray file = "/IONAME\r\n//IN\r\n";
    for (int row = 0; row < 3000; ++row)
        file += "A,B,C,D\r\n";
    const auto parsed = signalNamesFrom(file, samples::codec());
    QCOMPARE(int(parsed.value.names.size()), 8192);
    QCOMPARE(parsed.warnings.count(), 1);
}

void SignalNamesTest::otherEncodings()
{
    const QByteArray file = samples::read(QStringLiteral("damaged/IONAME-sjis.DAT"));
    const auto names = signalNamesFrom(file, protocol::TextCodec {protocol::Encoding::ShiftJis}).value.names;
    QCOMPARE(names.value(10), QStringLiteral("起動釦"));
    QCOMPARE(names.value(11), QStringLiteral("表示ソ"));
    QCOMPARE(names.value(12), QStringLiteral("ｱﾝｾﾞﾝ ﾄﾞｱ"));
    QCOMPARE(names.value(13), QStringLiteral("安全柵閉"));
    QCOMPARE(names.value(10010), QStringLiteral("ハンド閉"));
    // Polish names in an encoding that the profile does not have are shown as far as they go, and no comma is lost.
    const QByteArray polish = samples::read(QStringLiteral("dx200/IONAME.DAT"));
    const auto parsed = signalNamesFrom(polish, protocol::TextCodec {protocol::Encoding::Utf8});
    QCOMPARE(parsed.value.names.value(10), QStringLiteral("PRZYCISK START"));
    QVERIFY(parsed.value.names.value(11).endsWith(QStringLiteral("ONA ZAMK.")));
    QVERIFY(parsed.value.names.value(20).endsWith(QStringLiteral(" OK")));
    QCOMPARE(parsed.warnings.count(), 2);
}

void SignalNamesTest::readsRegisters()
{
    const QByteArray file = samples::read(QStringLiteral("yrc1000/IOMNAME.DAT"));
    const auto parsed = registerNamesFrom(file, samples::codec());
    QCOMPARE(parsed.warnings.count(), 0);
    QCOMPARE(parsed.value.rows, 1000);
    QCOMPARE(
        parsed.value.names, (QMap<int, QString> {{0, QStringLiteral("SPINDLE RPM")}, {559, QStringLiteral("TEMP 1")}}));
}

void SignalNamesTest::readsVariables_data()
{
    QTest::addColumn<QString>("path");
    QTest::addColumn<QString>("variable");
    QTest::addColumn<QString>("name");
    const QString yrc = QStringLiteral("yrc1000/VARNAME.DAT");
    QTest::newRow("B000") << yrc << "B000"
                          << "START OK";
    QTest::newRow("B007") << yrc << "B007"
                          << "MODE";
    QTest::newRow("I012") << yrc << "I012"
                          << "OFFSET X";
    QTest::newRow("S000") << yrc << "S000"
                          << "PART NAME";
    QTest::newRow("P002") << yrc << "P002"
                          << "PICK POS";
    QTest::newRow("P000 behind it") << yrc << "P000"
                                    << "HOME POS";
    QTest::newRow("named twice") << yrc << "P029"
                                 << "PLACE / PLACE HOVER";
    QTest::newRow("Polish") << QStringLiteral("dx200/VARNAME.DAT") << "B001"
                            << "CYKL";
    QTest::newRow("external") << QStringLiteral("dx200/VARNAME.DAT") << "EX003"
                              << "STOL 2";
    QTest::newRow("short") << QStringLiteral("names/VARNAME.DAT") << "B003"
                           << "COUNT";
    QTest::newRow("short P") << QStringLiteral("names/VARNAME.DAT") << "P001"
                             << "HOME";
    QTest::newRow("mixed order") << QStringLiteral("damaged/VARNAME-dup.DAT") << "B002"
                                 << "EARLY";
    QTest::newRow("two digits") << QStringLiteral("damaged/VARNAME-dup.DAT") << "B012"
                                << "SHORT NUMBER";
}

void SignalNamesTest::readsVariables()
{
    QFETCH(QString, path);
    QFETCH(QString, variable);
    const QByteArray file = samples::read(path);
    const auto names = variableNamesFrom(file, samples::codec()).value.byVariable();
    protocol::Dialect dialect = protocol::dialect(protocol::Model::YRC1000);
    const auto reference = variables::referenceFromText(variable, dialect);
    QVERIFY(reference.has_value());
    QTEST(names.value(*reference), "name");
}

void SignalNamesTest::keepsEveryNameOfANumber()
{
    const QByteArray file = samples::read(QStringLiteral("damaged/VARNAME-dup.DAT"));
    const auto parsed = variableNamesFrom(file, samples::codec());
    QCOMPARE(parsed.value.names.size(), 5);
    QCOMPARE(parsed.value.shares.value(Kind::B), 10);
    QCOMPARE(parsed.value.byVariable().value({Kind::B, 5}), QStringLiteral("LATE / OTHER NAME"));
    QList<int> lines;
    for (const Warning &warning : parsed.warnings.list())
        lines << warning.line;
    QCOMPARE(lines, (QList<int> {7, 8, 9})); // B005 again, B099 and B012 beyond the ten
}

void SignalNamesTest::readsTimers()
{
    const auto parsed =
        timerNamesFrom("//TMNAME\r\n///TM\r\nDWELL,\r\n,\r\nCOOL,\r\n///TF\r\n,\r\nDONE,\r\n", samples::codec());
    QCOMPARE(parsed.warnings.count(), 0);
    QCOMPARE(parsed.value.timers, (QMap<int, QString> {{0, QStringLiteral("DWELL")}, {2, QStringLiteral("COOL")}}));
    QCOMPARE(parsed.value.flags, (QMap<int, QString> {{1, QStringLiteral("DONE")}}));
}

void SignalNamesTest::survivesEveryCut()
{
    const QByteArray file = "/IONAME\r\n//IN\r\nA\x8A,B\r\n//OUT\r\nC\r\n";
    for (qsizetype size = 0; size <= file.size(); ++size)
        QVERIFY(signalNamesFrom(file.first(size), samples::codec()).value.names.size() <= 3);
}

void SignalNamesTest::numbersSignals_data()
{
    QTest::addColumn<int>("area");
    QTest::addColumn<int>("index");
    QTest::addColumn<int>("number");
    QTest::addColumn<QString>("text");
    QTest::newRow("IN 5") << 0 << 5 << 14 << QStringLiteral("IN#(5)");
    QTest::newRow("OUT 889") << 10000 << 889 << 11120 << QStringLiteral("OUT#(889)");
    QTest::newRow("external") << 20000 << 9 << 20020 << QStringLiteral("#20020");
}

void SignalNamesTest::numbersSignals()
{
    QFETCH(int, area);
    QFETCH(int, index);
    QFETCH(int, number);
    QCOMPARE(logicalNumber(area, index), number);
    QTEST(signalText(number), "text");
}

QTEST_APPLESS_MAIN(SignalNamesTest)
#include "tst_signalnames.moc"
