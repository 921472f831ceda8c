// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "cellfiles/variablefile.h"
#include "support/samples.h"
#include <QTest>

using namespace cellfiles;
using variables::Kind;

class VariableFileTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void readsIntegers();
    void readsTexts();
    void readsPositions_data();
    void readsPositions();
    void countsBySharedLine_data();
    void countsBySharedLine();
    void damaged_data();
    void damaged();
    void cutInAPosition();
    void realForms();
    void otherGenerations();
};

namespace {

Parsed<VariableFile> file(const QString &path)
{
    const QByteArray bytes = samples::read(path);
    return variablesFrom(bytes);
}

const QString yrc = QStringLiteral("yrc1000/VAR.DAT");

QList<int> linesOf(const Warnings &warnings)
{
    QList<int> lines;
    for (const Warning &warning : warnings.list())
        lines << warning.line;
    return lines;
}

} // namespace

void VariableFileTest::readsIntegers()
{
    const auto parsed = file(yrc);
    QCOMPARE(parsed.warnings.count(), 0);
    const auto at = [&](Kind kind, int number) { return parsed.value.integers[kind].at(number).value(); };
    QCOMPARE(at(Kind::B, 0), 1);
    QCOMPARE(at(Kind::B, 7), 255);
    QCOMPARE(at(Kind::B, 19), 16);
    QCOMPARE(at(Kind::I, 0), -32768);
    QCOMPARE(at(Kind::I, 1), 32767);
    QCOMPARE(at(Kind::I, 12), -5);
    QCOMPARE(at(Kind::D, 0), -2147483648LL);
    QCOMPARE(at(Kind::D, 3), 100000);
    QCOMPARE(at(Kind::D, 19), 7);
    QCOMPARE(parsed.value.reals, QByteArrayList(20, "0"));
}

void VariableFileTest::readsTexts()
{
    const auto texts = file(yrc).value.strings;
    QCOMPARE(texts, (QByteArrayList {"PART-0042", "", "A,B \"Q\" 100%", "", "", "", "", "", "", " x"}));
}

void VariableFileTest::readsPositions_data()
{
    QTest::addColumn<int>("number");
    QTest::addColumn<FilePosition>("position");
    QTest::newRow("pulse") << 0
                           << FilePosition {
                                  PositionFrame::Pulse, 0, 1, 0, {41000, 52000, -30100, 2500, -61200, 1200, 0, 0}};
    QTest::newRow("robot") << 2
                           << FilePosition {PositionFrame::Robot, 0, 1, 0,
                                  {512250, -30000, 640125, 1799000, -2500, 900000, 0, 0}};
    QTest::newRow("user, form bits 2 and 3")
        << 3 << FilePosition {PositionFrame::User, 5, 1, 0b1100, {10000, 20000, 30000, 0, 0, 0, 0, 0}};
    QTest::newRow("18 is tool") << 4 << FilePosition {PositionFrame::Tool, 0, 2, 0, {0, 0, -15500, 0, 0, 0, 0, 0}};
    QTest::newRow("base, form bits 0 and 1")
        << 5 << FilePosition {PositionFrame::Base, 0, 0, 0b11, {-612000, 805500, 333250, 1795000, 2500, -450500, 0, 0}};
}

void VariableFileTest::readsPositions()
{
    QFETCH(int, number);
    QFETCH(FilePosition, position);
    const auto slots_ = file(yrc).value.positions[Kind::P];
    QCOMPARE(slots_.size(), 10);
    QVERIFY(slots_[number] == (PositionSlot {Slot::Used, position}));
    for (const int unused : {1, 6, 7, 8, 9})
        QVERIFY(slots_[unused].slot == Slot::Unused);
}

void VariableFileTest::countsBySharedLine_data()
{
    QTest::addColumn<QString>("path");
    QTest::addColumn<int>("bytes");
    QTest::addColumn<int>("positions");
    QTest::addColumn<int>("bases");
    QTest::newRow("YRC1000") << yrc << 20 << 10 << 0;
    QTest::newRow("full size") << QStringLiteral("yrc1000-fsu/VAR.DAT") << 250 << 250 << 0;
    QTest::newRow("DX200") << QStringLiteral("dx200/VAR.DAT") << 20 << 8 << 8;
    QTest::newRow("announced more") << QStringLiteral("damaged/VAR-shortcount.DAT") << 30 << 12 << 0;
}

void VariableFileTest::countsBySharedLine()
{
    QFETCH(QString, path);
    const auto shares = file(path).value.shares;
    QTEST(shares.value(Kind::B), "bytes");
    QTEST(shares.value(Kind::P), "positions");
    QTEST(shares.value(Kind::BP), "bases");
}

void VariableFileTest::damaged_data()
{
    QTest::addColumn<QString>("path");
    QTest::addColumn<QList<int>>("lines");
    QTest::addColumn<QStringList>("unread");
    QTest::newRow("counts") << QStringLiteral("damaged/VAR-shortcount.DAT") << QList<int> {4, 27} << QStringList {};
    QTest::newRow("values") << QStringLiteral("damaged/VAR-badline.DAT") << QList<int> {8, 11, 31}
                            << QStringList {QStringLiteral("I001"), QStringLiteral("D000"), QStringLiteral("P003")};
}

void VariableFileTest::damaged()
{
    QFETCH(QString, path);
    QFETCH(QStringList, unread);
    const auto parsed = file(path);
    const auto good = file(yrc).value;
    QTEST(linesOf(parsed.warnings), "lines");
    QStringList missing;
    for (const Kind kind : {Kind::B, Kind::I, Kind::D}) {
        for (int number = 0; number < 20; ++number) {
            const auto value = parsed.value.integers[kind].at(number);
            if (!value)
                missing << toString(variables::Reference {kind, number});
            QVERIFY(!value || value == good.integers[kind].at(number));
        }
    }
    for (int number = 0; number < 10; ++number) {
        const PositionSlot found = parsed.value.positions[Kind::P].at(number);
        if (found.slot == Slot::Unread)
            missing << toString(variables::Reference {Kind::P, number});
        QVERIFY(found.slot == Slot::Unread || found == good.positions[Kind::P].at(number));
    }
    QCOMPARE(missing, unread);
    QCOMPARE(parsed.value.strings, good.strings);
}

void VariableFileTest::cutInAPosition()
{
    const auto parsed = file(QStringLiteral("damaged/VAR-cut.DAT"));
    const auto good = file(yrc).value;
    for (const Kind kind : {Kind::B, Kind::I, Kind::D})
        QVERIFY(parsed.value.integers[kind] == good.integers[kind]);
    QCOMPARE(parsed.value.strings, good.strings);
    const auto positions = parsed.value.positions[Kind::P];
    QCOMPARE(positions.size(), 3); // what is missing is not "unused"
    QVERIFY(positions[0] == good.positions[Kind::P].at(0));
    QVERIFY(positions[1].slot == Slot::Unused);
    QVERIFY(positions[2].slot == Slot::Unread);
    QCOMPARE(linesOf(parsed.warnings), (QList<int> {30, 30, 27}));
}

void VariableFileTest::realForms()
{
    const auto parsed = file(QStringLiteral("damaged/VAR-realforms.DAT"));
    QCOMPARE(parsed.warnings.count(), 0);
    QCOMPARE(parsed.value.reals.first(5), (QByteArrayList {"1.5", "-0.250000", "3.402823E+38", "1.5E-07", "0"}));
    QCOMPARE(parsed.value.strings.first(4), (QByteArrayList {"\"QUOTED\"", "PLAIN", "   ", ""}));
}

void VariableFileTest::otherGenerations()
{
    const auto dx200 = file(QStringLiteral("dx200/VAR.DAT"));
    QCOMPARE(dx200.warnings.count(), 0);
    QCOMPARE(dx200.value.axisCounts, (QList<qint64> {6, 1, 2, 1}));
    QCOMPARE(dx200.value.integers[Kind::D].at(0), std::optional<qint64> {-45});
    QCOMPARE(dx200.value.strings.at(1), QByteArray {"SKRZYNKA"});
    QCOMPARE(dx200.value.positions[Kind::BP].at(1).position.axes[0], 654321);
    QCOMPARE(dx200.value.positions[Kind::EX].at(3).position.axes[1], -123456);
    const auto dx100 = file(QStringLiteral("dx100/VAR.DAT"));
    QCOMPARE(dx100.value.axisCounts, (QList<qint64> {7, 1, 0, 1}));
    QCOMPARE(dx100.value.positions[Kind::P].at(0).position.axes[6], 777);
}

QTEST_APPLESS_MAIN(VariableFileTest)
#include "tst_variablefile.moc"
