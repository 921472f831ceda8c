// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "variables/number.h"
#include <QTest>

using namespace variables;

Q_DECLARE_METATYPE(variables::Base)

class NumberTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void wholeNumbers_data();
    void wholeNumbers();
    void registers_data();
    void registers();
    void printsRegisters();
    void reals_data();
    void reals();
    void refusesReals_data();
    void refusesReals();
    void printsReals_data();
    void printsReals();
    void everyRealComesBack();
    void fixedPoints_data();
    void fixedPoints();
    void refusesFixedPoints_data();
    void refusesFixedPoints();
};

namespace {

constexpr qint64 refused = std::numeric_limits<qint64>::min();

} // namespace

void NumberTest::wholeNumbers_data()
{
    QTest::addColumn<QString>("typed");
    QTest::addColumn<qint64>("number"); // within -32768 to 32767
    const auto row = [](const char *typed, qint64 number) {
        QTest::newRow(typed) << QString::fromUtf8(typed) << number;
    };
    row("0", 0);
    row("17", 17);
    row(" +17 ", 17);
    row("010", 10); // never octal
    row("-32768", -32768);
    row("32767", 32767);
    row("−5", -5); // U+2212
    row("１２３", 123); // full-width
    row("－７", -7);
    row("٣", 3); // Arabic-Indic
    row("0x1F", 31);
    row("0b101", 5);
    row("-0x10", -16);
    row("32768", refused);
    row("-32769", refused);
    row("99999999999999999999", refused);
    row("", refused);
    row("-", refused);
    row("1 000", refused);
    row("1,000", refused);
    row("1.000", refused);
    row("1.5", refused);
    row("1e3", refused);
    row("nan", refused);
    row("inf", refused);
    row("0x", refused);
    row("0b2", refused);
    row("12a", refused);
    row("--1", refused);
}

void NumberTest::wholeNumbers()
{
    QFETCH(QString, typed);
    QFETCH(qint64, number);
    const auto read = wholeNumber(typed, -32768, 32767);
    QCOMPARE(read.value_or(refused), number);
    if (!read)
        QVERIFY2(read.error().detail.endsWith(u'.'), qPrintable(read.error().detail));
}

void NumberTest::registers_data()
{
    QTest::addColumn<QString>("typed");
    QTest::addColumn<Base>("base");
    QTest::addColumn<int>("bits"); // -1: refused
    const auto row = [](const char *typed, Base base, int bits) {
        QTest::addRow("%s as %d", typed, int(base)) << QString::fromUtf8(typed) << base << bits;
    };
    row("65535", Base::Decimal, 0xFFFF);
    row("65536", Base::Decimal, -1);
    row("-1", Base::Decimal, -1);
    row("0xFFFF", Base::Decimal, 0xFFFF);
    row("-1", Base::Signed, 0xFFFF);
    row("-32768", Base::Signed, 0x8000);
    row("32767", Base::Signed, 0x7FFF);
    row("32768", Base::Signed, -1);
    row("0xFFFF", Base::Signed, 0xFFFF);
    row("FFFF", Base::Hex, 0xFFFF);
    row("0xff", Base::Hex, 0xFF);
    row("10", Base::Hex, 0x10);
    row("10000", Base::Hex, -1);
    row("G", Base::Hex, -1);
    row("-1", Base::Hex, -1);
    row("101", Base::Binary, 5);
    row("0b1111 0000", Base::Binary, 0xF0);
    row("0x10", Base::Binary, 0x10);
    row("102", Base::Binary, -1);
    row("11111111111111111", Base::Binary, -1);
    row("", Base::Binary, -1);
    row("", Base::Hex, -1);
}

void NumberTest::registers()
{
    QFETCH(QString, typed);
    QFETCH(Base, base);
    QFETCH(int, bits);
    const auto read = bits16(typed, base);
    QCOMPARE(read ? int(*read) : -1, bits);
}

void NumberTest::printsRegisters()
{
    QCOMPARE(toText(quint16(65535), Base::Decimal), QStringLiteral("65535"));
    QCOMPARE(toText(quint16(65535), Base::Signed), QStringLiteral("-1"));
    QCOMPARE(toText(quint16(10), Base::Hex), QStringLiteral("0x000A"));
    QCOMPARE(toText(quint16(5), Base::Binary), QStringLiteral("0b0000000000000101"));
    for (const Base base : {Base::Decimal, Base::Signed, Base::Hex, Base::Binary}) {
        for (int bits = 0; bits <= 0xFFFF; ++bits)
            QCOMPARE(bits16(toText(quint16(bits), base), base), values::Result<quint16> {quint16(bits)});
    }
}

void NumberTest::reals_data()
{
    QTest::addColumn<QString>("typed");
    QTest::addColumn<float>("value");
    const auto row = [](const char *typed, float value) { QTest::newRow(typed) << QString::fromUtf8(typed) << value; };
    row("1.5", 1.5F);
    row("1,5", 1.5F);
    row("-0,25", -0.25F);
    row(".5", .5F);
    row("5.", 5.F);
    row("1e3", 1000.F);
    row("1,5E-2", 0.015F);
    row("0.1", 0.1F);
    row("16777217", 16777216.F); // the nearest real
    row("１，５", 1.5F);
    row("3.4028235e38", 3.4028235e38F); // the greatest
    row("0", 0.F);
}

void NumberTest::reals()
{
    QFETCH(QString, typed);
    const auto read = real(typed);
    QVERIFY2(read, read ? "" : qPrintable(read.error().detail));
    QTEST(*read, "value");
}

void NumberTest::refusesReals_data()
{
    QTest::addColumn<QString>("typed");
    for (const char *typed : {"", "nan", "NaN", "inf", "-inf", "∞", "1e39", "1e-60", "1.234,5", "1,234.5", "1..5",
             "0x10", "1 5", "e5", ".", "-", "1e", "5 mm"})
        QTest::newRow(typed) << QString::fromUtf8(typed);
}

void NumberTest::refusesReals()
{
    QFETCH(QString, typed);
    const auto read = real(typed);
    QVERIFY(!read);
    QVERIFY2(read.error().detail.endsWith(u'.'), qPrintable(read.error().detail));
}

void NumberTest::printsReals_data()
{
    QTest::addColumn<float>("value");
    QTest::addColumn<QString>("language");
    QTest::addColumn<QString>("text");
    QTest::newRow("point") << 0.1F << QStringLiteral("en_GB") << QStringLiteral("0.1");
    QTest::newRow("comma") << -12.5F << QStringLiteral("de_DE") << QStringLiteral("-12,5");
    QTest::newRow("whole") << 180.F << QStringLiteral("de_DE") << QStringLiteral("180");
    QTest::newRow("great") << 1e30F << QStringLiteral("en_GB") << QStringLiteral("1e+30");
    QTest::newRow("infinite") << std::numeric_limits<float>::infinity() << QStringLiteral("C") << QStringLiteral("inf");
    QTest::newRow("not a number") << std::numeric_limits<float>::quiet_NaN() << QStringLiteral("C")
                                  << QStringLiteral("not a number");
}

void NumberTest::printsReals()
{
    QFETCH(float, value);
    QFETCH(QString, language);
    QTEST(toText(value, QLocale(language)), "text");
}

void NumberTest::everyRealComesBack()
{
    for (quint32 bits = 1; bits < 0x7F800000; bits += 100'003) {
        const auto value = std::bit_cast<float>(bits);
        if (!std::isnormal(value))
            continue;
        const auto back = real(toText(value, QLocale(QStringLiteral("de_DE"))));
        QVERIFY(back);
        QCOMPARE(std::bit_cast<quint32>(*back), bits);
    }
}

void NumberTest::fixedPoints_data()
{
    QTest::addColumn<QString>("typed");
    QTest::addColumn<int>("decimals");
    QTest::addColumn<qint32>("value");
    QTest::addColumn<QString>("echo"); // in a German locale
    const auto row = [](const char *typed, int decimals, qint32 value, const char *echo) {
        QTest::addRow("%s with %d", typed, decimals)
            << QString::fromUtf8(typed) << decimals << value << QString::fromUtf8(echo);
    };
    row("812.5", 3, 812500, "812,500");
    row("812,5", 3, 812500, "812,500");
    row("0.001", 3, 1, "0,001");
    row("-0.001", 3, -1, "-0,001");
    row("-.5", 3, -500, "-0,500");
    row("1.0000", 3, 1000, "1,000");
    row("179.9999", 4, 1799999, "179,9999");
    row("0.29", 4, 2900, "0,2900"); // 0.29 * 10000 is 2899.99… in binary
    row("1.005", 3, 1005, "1,005");
    row("2147483.647", 3, 2147483647, "2147483,647");
    row("-2147483.648", 3, -2147483647 - 1, "-2147483,648");
    row("123456", 0, 123456, "123456");
    row("123456.0", 0, 123456, "123456");
    row("-0", 3, 0, "0,000");
    row("１．５", 3, 1500, "1,500");
}

void NumberTest::fixedPoints()
{
    QFETCH(QString, typed);
    QFETCH(int, decimals);
    QFETCH(qint32, value);
    const auto read = fixedPoint(typed, decimals);
    QVERIFY2(read, read ? "" : qPrintable(read.error().detail));
    QCOMPARE(*read, value);
    QTEST(toText(value, decimals, QLocale(QStringLiteral("de_DE"))), "echo");
}

void NumberTest::refusesFixedPoints_data()
{
    QTest::addColumn<QString>("typed");
    QTest::addColumn<int>("decimals");
    QTest::addColumn<QString>("part");
    const auto row = [](const char *typed, int decimals, const char *part) {
        QTest::addRow("%s with %d", typed, decimals) << QString::fromUtf8(typed) << decimals << QString::fromUtf8(part);
    };
    row("1.0005", 3, "too fine");
    row("1.5", 0, "not a whole number");
    row("2147483.648", 3, "out of range");
    row("99999999999999", 0, "out of range");
    row("1e3", 3, "not a number");
    row("", 3, "not a number");
    row("nan", 3, "not a number");
    row("1,234.5", 3, "not a number");
}

void NumberTest::refusesFixedPoints()
{
    QFETCH(QString, typed);
    QFETCH(int, decimals);
    QFETCH(QString, part);
    const auto read = fixedPoint(typed, decimals);
    QVERIFY(!read);
    QVERIFY2(read.error().detail.contains(part), qPrintable(read.error().detail));
    QVERIFY(read.error().detail.endsWith(u'.'));
}

QTEST_APPLESS_MAIN(NumberTest)
#include "tst_number.moc"
