// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "variables/text.h"
#include <QTest>

using namespace variables;
using protocol::Encoding;

Q_DECLARE_METATYPE(variables::Kind)
Q_DECLARE_METATYPE(protocol::Encoding)

/// Values as text and back, with the ranges of reference §4.3.
class ValuesTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void reads_data();
    void reads();
    void refuses_data();
    void refuses();
    void printsPositions();
    void readsAxes();
    void namesRanges();
    void comparesAndRebuilds();
};

namespace {

Format german(Encoding encoding = Encoding::Latin1, int stringSize = 16)
{
    return {QLocale(QStringLiteral("de_DE")), protocol::TextCodec {encoding}, stringSize, Base::Decimal};
}

} // namespace

void ValuesTest::reads_data()
{
    QTest::addColumn<Kind>("kind");
    QTest::addColumn<QString>("typed");
    QTest::addColumn<QString>("echo");
    const auto row = [](Kind kind, const char *typed, const char *echo) {
        QTest::addRow("%s %s", qPrintable(letters(kind)), typed)
            << kind << QString::fromUtf8(typed) << QString::fromUtf8(echo);
    };
    row(Kind::B, "0", "0");
    row(Kind::B, "255", "255");
    row(Kind::I, "-32768", "-32768");
    row(Kind::D, "2147483647", "2147483647");
    row(Kind::D, "-2147483648", "-2147483648");
    row(Kind::R, "1.5", "1,5");
    row(Kind::S, "", "");
    row(Kind::S, "Teil A", "Teil A");
    row(Kind::S, "sixteen bytes ok", "sixteen bytes ok");
    row(Kind::M, "65535", "65535");
}

void ValuesTest::reads()
{
    QFETCH(Kind, kind);
    QFETCH(QString, typed);
    const auto value = fromText(kind, typed, german());
    QVERIFY2(value, value ? "" : qPrintable(value.error().detail));
    QVERIFY(kindOf(*value) == kind);
    QTEST(toText(*value, german()), "echo");
}

void ValuesTest::refuses_data()
{
    QTest::addColumn<Kind>("kind");
    QTest::addColumn<QString>("typed");
    QTest::addColumn<Encoding>("encoding");
    QTest::addColumn<QString>("part");
    const auto row = [](Kind kind, const char *typed, const char *part, Encoding encoding = Encoding::Latin1) {
        QTest::addRow("%s %s", qPrintable(letters(kind)), typed)
            << kind << QString::fromUtf8(typed) << encoding << QString::fromUtf8(part);
    };
    row(Kind::B, "256", "from 0 to 255");
    row(Kind::B, "-1", "from 0 to 255");
    row(Kind::I, "32768", "from -32768 to 32767");
    row(Kind::D, "2147483648", "from -2147483648 to 2147483647");
    row(Kind::R, "nan", "not a number");
    row(Kind::M, "65536", "from 0 to 65535");
    row(Kind::S, "seventeen bytes!!", "takes 17 bytes; there is room for 16");
    row(Kind::S, "溶接", "\"溶\"");
    row(Kind::S, "テスト☃", "\"☃\"", Encoding::ShiftJis);
    row(Kind::S, "テストテストテスト", "takes 18 bytes", Encoding::ShiftJis);
    row(Kind::P, "1", "not written as one text");
}

void ValuesTest::refuses()
{
    QFETCH(Kind, kind);
    QFETCH(QString, typed);
    QFETCH(Encoding, encoding);
    QFETCH(QString, part);
    const auto value = fromText(kind, typed, german(encoding));
    QVERIFY(!value);
    QVERIFY2(value.error().detail.contains(part), qPrintable(value.error().detail));
    QVERIFY(value.error().detail.endsWith(u'.'));
}

void ValuesTest::printsPositions()
{
    values::Position position;
    position.type = values::PositionType::Base;
    position.axes = {812500, -12000, 0, 1800000, 0, -450000, 0, 0};
    QCOMPARE(toText(valueWith(Kind::P, position), german()),
        QStringLiteral("base frame  X 812,500  Y -12,000  Z 0,000  Rx 180,0000  Ry 0,0000  Rz -45,0000"));
    position.type = values::PositionType::Pulse;
    position.axes = {1000, -5};
    QCOMPARE(toText(valueWith(Kind::P, position), german()), QStringLiteral("pulse  S 1000  L -5  U 0  R 0  B 0  T 0"));
    QCOMPARE(toText(valueWith(Kind::EX, position), german()), QStringLiteral("pulse  1 1000  2 -5"));
}

void ValuesTest::readsAxes()
{
    using values::AxisUnit;
    QCOMPARE(axisFromText(u"1,5", AxisUnit::Micrometre), values::Result<qint32> {1500});
    QCOMPARE(axisFromText(u"1,5", AxisUnit::TenThousandthDegree), values::Result<qint32> {15000});
    QVERIFY(!axisFromText(u"1,5", AxisUnit::Pulse));
    QCOMPARE(axisText(-1500, AxisUnit::Micrometre, QLocale::c()), QStringLiteral("-1.500"));
}

void ValuesTest::namesRanges()
{
    QCOMPARE(rangeText(Kind::B, german()), QStringLiteral("0 … 255"));
    QCOMPARE(rangeText(Kind::I, german()), QStringLiteral("-32768 … 32767"));
    QCOMPARE(rangeText(Kind::M, german()), QStringLiteral("0 … 65535"));
    Format hex = german();
    hex.registerBase = Base::Hex;
    QCOMPARE(rangeText(Kind::M, hex), QStringLiteral("0x0000 … 0xFFFF"));
    hex.registerBase = Base::Signed;
    QCOMPARE(rangeText(Kind::M, hex), QStringLiteral("-32768 … 32767"));
}

void ValuesTest::comparesAndRebuilds()
{
    const float nan = std::numeric_limits<float>::quiet_NaN();
    QVERIFY(isSame(values::RealVariable {nan}, values::RealVariable {nan}));
    QVERIFY(!isSame(values::RealVariable {nan}, values::RealVariable {1}));
    QVERIFY(!isSame(values::ByteVariable {1}, values::IntegerVariable {1}));
    for (const Kind kind : {Kind::P, Kind::BP, Kind::EX}) {
        values::Position position;
        position.axes = {1, 2, 3, 4, 5, 6, 7, 8};
        const Value value = valueWith(kind, position);
        QVERIFY(kindOf(value) == kind);
        QVERIFY(positionOf(value) == position);
    }
    QVERIFY(!positionOf(values::ByteVariable {}));
}

QTEST_APPLESS_MAIN(ValuesTest)
#include "tst_values.moc"
