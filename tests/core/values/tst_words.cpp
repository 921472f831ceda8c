// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "values/alarm.h"
#include "values/control.h"
#include "values/form.h"
#include "values/managementtime.h"
#include "values/move.h"
#include "values/status.h"
#include "values/variable.h"
#include <QTest>

using namespace values;

/// What values say of themselves in words.
class WordsTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void alarmData_data();
    void alarmData();
    void formWordsBothWays_data();
    void formWordsBothWays();
    void formRejectsUnknownWord();
    void speeds_data();
    void speeds();
    void durations_data();
    void durations();
    void counters();
    void statusBits_data();
    void statusBits();
    void positionTypes();
    void pendantText();
    void ioBits();
};

void WordsTest::alarmData_data()
{
    QTest::addColumn<quint32>("value");
    QTest::addColumn<int>("type");
    QTest::addColumn<QString>("text");
    const auto row = [](const char *name, quint32 value, int type, const char *text) {
        QTest::newRow(name) << value << type << QString::fromLatin1(text);
    };
    // Reference §3.3.
    row("none", 7, 0, "");
    row("unsigned", 65535, 1, "65535");
    row("8 bits", 0x05, 2, "0000 0101");
    row("axes", 0x21, 3, "S T");
    row("x y z", 0x6, 4, "Y Z");
    row("x to rz", 0x3F, 5, "X Y Z Rx Ry Rz");
    row("conveyor files", 0x5, 6, "1 3");
    row("robots and stations, packing unknown", 0x101, 8, "0x00000101");
    row("signed", 0xFFF4, 9, "-12");
    row("signed over 32 bits", 0xFFFFFFF4, 9, "-12");
    row("16 bits", 0x8001, 10, "1000 0000 0000 0001");
    row("robots", 0x81, 11, "R1 R8");
    row("more bits than axes", 0x40, 3, "0x00000040");
    row("low and high, packing unknown", 0x00010203, 20, "0x00010203");
    row("number, packing unknown", 0x1A, 27, "0x0000001a");
    row("type that nobody knows", 0xABCD, 99, "0x0000abcd");
}

void WordsTest::alarmData()
{
    QFETCH(quint32, value);
    QFETCH(int, type);
    const AlarmData data {value, AlarmDataType(type)};
    QTEST(data.toString(), "text");
    QVERIFY(!toString(data.type).isEmpty());
}

void WordsTest::formWordsBothWays_data()
{
    QTest::addColumn<quint32>("form");
    QTest::addColumn<bool>("isExtended");
    QTest::addColumn<QStringList>("words");
    const auto words = [](const char *text) { return QString::fromLatin1(text).split(u'|'); };
    // Reference §5.2.
    QTest::newRow("all clear")
        << 0U << false << words("front|upper arm|flip|R < 180|T < 180|S < 180|redundant front|previous step's form");
    QTest::newRow("all set") << 0xFFU << false
                             << words("back|lower arm|no flip|R >= 180|T >= 180|S >= 180|redundant back|this form");
    QTest::newRow("no flip")
        << 4U << false << words("front|upper arm|no flip|R < 180|T < 180|S < 180|redundant front|previous step's form");
    QTest::newRow("extended clear") << 0U << true << words("L < 180|U < 180|B < 180|E < 180|W < 180");
    QTest::newRow("extended set") << 0x1FU << true << words("L >= 180|U >= 180|B >= 180|E >= 180|W >= 180");
}

void WordsTest::formWordsBothWays()
{
    QFETCH(quint32, form);
    QFETCH(bool, isExtended);
    QFETCH(QStringList, words);
    const auto table = isExtended ? extendedFormBits() : formBits();
    QCOMPARE(formWords(form, table), words);
    const auto back = formFromWords(words, table);
    QVERIFY(back);
    QCOMPARE(*back, form);
}

void WordsTest::formRejectsUnknownWord()
{
    QCOMPARE(*formFromWords({QStringLiteral("back")}, formBits()), 1U);
    const auto wrong = formFromWords({QStringLiteral("back"), QStringLiteral("sideways")}, formBits());
    QVERIFY(!wrong);
    QVERIFY(wrong.error().detail.contains(QLatin1StringView("sideways")));
}

void WordsTest::speeds_data()
{
    QTest::addColumn<int>("kind");
    QTest::addColumn<quint32>("value");
    QTest::addColumn<QString>("text");
    const auto row = [](int kind, quint32 value, const char *text) {
        QTest::newRow(text) << kind << value << QString::fromUtf8(text);
    };
    row(0, 1000, "10.00 %");
    row(0, 1, "0.01 %");
    row(1, 250, "25.0 mm/s");
    row(2, 35, "3.5 °/s");
    row(3, 35, "35");
}

void WordsTest::speeds()
{
    QFETCH(int, kind);
    QFETCH(quint32, value);
    QTEST((Speed {SpeedClass(kind), value}.toString()), "text");
}

void WordsTest::durations_data()
{
    QTest::addColumn<QByteArray>("elapsed");
    QTest::addColumn<int>("seconds"); // -1: no duration
    QTest::newRow("recorded") << QByteArray("18:19'02") << 18 * 3600 + 19 * 60 + 2;
    QTest::newRow("short hours") << QByteArray("3:37'14") << 3 * 3600 + 37 * 60 + 14;
    QTest::newRow("padded hours") << QByteArray("000100:00'00") << 100 * 3600;
    QTest::newRow("empty") << QByteArray {} << -1;
    QTest::newRow("no seconds") << QByteArray("3:37") << -1;
    QTest::newRow("sixty minutes") << QByteArray("3:60'00") << -1;
}

void WordsTest::durations()
{
    QFETCH(QByteArray, elapsed);
    QFETCH(int, seconds);
    const ManagementTime time {{}, FixedText<12> {elapsed}};
    const auto duration = time.duration();
    QCOMPARE(duration ? int(duration->count()) : -1, seconds);
}

/// Reference §3.9.
void WordsTest::counters()
{
    using Counter = ManagementTimeCounter;
    using enum ManagementTimeKind;
    QCOMPARE(Counter::controlPower().instance, quint16(1));
    QCOMPARE(Counter::total(ServoPower).instance, quint16(10));
    QCOMPARE(Counter::robot(ServoPower, 8).instance, quint16(18));
    QCOMPARE(Counter::station(ServoPower, 24).instance, quint16(44));
    QCOMPARE(Counter::total(Playback).instance, quint16(110));
    QCOMPARE(Counter::station(Playback, 1).instance, quint16(121));
    QCOMPARE(Counter::robot(Motion, 1).instance, quint16(211));
    QCOMPARE(Counter::application(8).instance, quint16(308));
}

void WordsTest::statusBits_data()
{
    QTest::addColumn<quint32>("data1");
    QTest::addColumn<quint32>("data2");
    QTest::addColumn<QString>("names");
    QTest::newRow("none") << 0U << 0U << QString {};
    QTest::newRow("all") << 0xFFU << 0xFFU
                         << QStringLiteral("step one_cycle continuous running speed_limited teach play remote "
                                           "hold_pendant hold_external hold_command alarm error servo_on");
    QTest::newRow("unused bits") << 0x100U << 0x81U << QString {};
}

void WordsTest::statusBits()
{
    QFETCH(quint32, data1);
    QFETCH(quint32, data2);
    const Status status {Status::Data1::fromInt(data1), Status::Data2::fromInt(data2)};
    QTEST(status.bitNames().join(u' '), "names");
}

void WordsTest::positionTypes()
{
    QCOMPARE(toString(PositionType::User), QStringLiteral("user frame")); // reference §12, conflict 27
    QCOMPARE(toString(PositionType::Tool), QStringLiteral("tool frame"));
    QCOMPARE(toString(PositionType(5)), QStringLiteral("unknown type 5"));
}

void WordsTest::pendantText()
{
    QVERIFY(PendantText::create(QByteArray(30, 'x')));
    QVERIFY(!PendantText::create(QByteArray(31, 'x')));
}

void WordsTest::ioBits()
{
    const IoGroup group {0x85};
    QVERIFY(group.isOn(0) && !group.isOn(1) && group.isOn(2) && group.isOn(7));
    QCOMPARE(group.with(1, true).bits, quint8(0x87));
    QCOMPARE(group.with(7, false).bits, quint8(0x05));
}

QTEST_APPLESS_MAIN(WordsTest)
#include "tst_words.moc"
