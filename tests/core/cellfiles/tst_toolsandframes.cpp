// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "cellfiles/conditions.h"
#include "cellfiles/homepositions.h"
#include "support/samples.h"
#include <QTest>

using namespace cellfiles;

class ToolsAndFramesTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void readsTools();
    void readsToolChecks();
    void readsLineFeeds();
    void cutTool();
    void readsUserFrames();
    void userFrameWithoutPlace();
    void readsCubes_data();
    void readsCubes();
    void readsEncoderOffsets_data();
    void readsEncoderOffsets();
    void readsHomes();
    void readsPseudoInputs_data();
    void readsPseudoInputs();
};

namespace {

Parsed<QList<Tool>> tools(const char *path)
{
    const QByteArray file = samples::read(QString::fromLatin1(path));
    return toolsFrom(file, samples::codec());
}

Parsed<QList<UserFrame>> frames(const char *path)
{
    const QByteArray file = samples::read(QString::fromLatin1(path));
    return userFramesFrom(file, samples::codec());
}

QList<int> linesOf(const Warnings &warnings)
{
    QList<int> lines;
    for (const Warning &warning : warnings.list())
        lines << warning.line;
    return lines;
}

} // namespace

void ToolsAndFramesTest::readsTools()
{
    const auto parsed = tools("yrc1000/TOOL.CND");
    QCOMPARE(parsed.warnings.count(), 0);
    QCOMPARE(parsed.value.size(), 64);
    QCOMPARE(parsed.value[0], (Tool {0, 1, QStringLiteral("FLANGE"), {}, {}, 0, {}, 1, {}, true}));
    QCOMPARE(parsed.value[1],
        (Tool {1, 8, QStringLiteral("GRIPPER A"), {0, 12500, 163250, 0, 0, 0}, {-3100, 0, 82400}, 4200, {31, 28, 12}, 2,
            {}, true}));
    const Tool &spindle = parsed.value[2];
    QCOMPARE(spindle.name, QStringLiteral("SPINDLE"));
    QVERIFY((spindle.point == Frame {-85001, 500, 240000, 1800000, -450000, 2500}));
    QCOMPARE(spindle.weight, 9875);
    QCOMPARE(spindle.entryKind, 3);
}

void ToolsAndFramesTest::readsToolChecks()
{
    const auto parsed = tools("yrc1000-fsu/TOOL.CND");
    QCOMPARE(parsed.warnings.count(), 0);
    QCOMPARE(parsed.value.size(), 64);
    for (const Tool &tool : parsed.value)
        QCOMPARE(tool.crc, QByteArray {"2864434397"});
    QCOMPARE(parsed.value[1].weight, 4200);
}

void ToolsAndFramesTest::readsLineFeeds()
{
    const auto parsed = tools("damaged/TOOL-lfonly.CND");
    QCOMPARE(parsed.value.size(), 4);
    QCOMPARE(parsed.value[2].weight, 9875);
    QCOMPARE(linesOf(parsed.warnings), QList<int> {0});
    QVERIFY(parsed.warnings.list().first().reason.contains(QStringLiteral("CR LF")));
}

void ToolsAndFramesTest::cutTool()
{
    const QByteArray whole = samples::read(QStringLiteral("yrc1000/TOOL.CND"));
    const auto parsed = toolsFrom(whole.first(whole.indexOf("4.200") + 3), samples::codec());
    QCOMPARE(parsed.value.size(), 2);
    QVERIFY(parsed.value[0].isWhole);
    QVERIFY(!parsed.value[1].isWhole);
    QVERIFY(linesOf(parsed.warnings).contains(8));
}

void ToolsAndFramesTest::readsUserFrames()
{
    const auto parsed = frames("yrc1000/UFRAME.CND");
    QCOMPARE(parsed.warnings.count(), 0);
    QCOMPARE(parsed.value.size(), 2);
    const UserFrame &table = parsed.value[0];
    QCOMPARE(table.number, 1);
    QCOMPARE(table.name, QStringLiteral("TABLE"));
    QCOMPARE(table.tool, 1);
    QCOMPARE(table.taught[0].first(6), (QList<qint64> {41000, 52000, -30100, 2500, -61200, 1200}));
    QVERIFY((table.frame == Frame {873562, 478508, -13168, 1642240, 103091, -585758}));
    const UserFrame &other = parsed.value[1];
    QCOMPARE(other.number, 5);
    QVERIFY(other.name.isEmpty());
    QVERIFY((other.frame == Frame {100000, -200500, 0, 0, 0, 900000}));
}

void ToolsAndFramesTest::userFrameWithoutPlace()
{
    const auto parsed = frames("damaged/UFRAME-nobuser.CND");
    QCOMPARE(parsed.value.size(), 2);
    QVERIFY(!parsed.value[0].frame.has_value());
    QVERIFY((parsed.value[1].frame == Frame {1000, 2000, 3000, 0, 0, 0}));
    QCOMPARE(linesOf(parsed.warnings), QList<int> {1});
}

void ToolsAndFramesTest::readsCubes_data()
{
    QTest::addColumn<QString>("path");
    QTest::newRow("YRC1000") << QStringLiteral("yrc1000/CUBEINTF.CND");
    QTest::newRow("DX200") << QStringLiteral("dx200/CUBEINTF.CND");
    QTest::newRow("DX100, shorter blocks") << QStringLiteral("dx100/CUBEINTF.CND");
}

void ToolsAndFramesTest::readsCubes()
{
    QFETCH(QString, path);
    const QByteArray file = samples::read(path);
    const auto parsed = cubesFrom(file, samples::codec());
    QCOMPARE(parsed.warnings.count(), 0);
    QCOMPARE(parsed.value.size(), 64);
    const Cube &press = parsed.value[0];
    QCOMPARE(press.name, QStringLiteral("PRESS"));
    QVERIFY(press.coordinates() == CubeCoordinates::Robot);
    QVERIFY((press.upper == std::array<qint64, 8> {820000, 410500, 1200000, 0, 0, 0, 0, 0}));
    QVERIFY((press.lower == std::array<qint64, 8> {-15000, -410500, 150250, 0, 0, 0, 0, 0}));
    const Cube &fixture = parsed.value[1];
    QCOMPARE(fixture.name, QStringLiteral("FIXTURE"));
    QVERIFY(fixture.coordinates() == CubeCoordinates::User);
    QCOMPARE(fixture.userFrame, 5);
    QVERIFY((fixture.lower == std::array<qint64, 8> {0, 0, -50000, 0, 0, 0, 0, 0}));
    QVERIFY(!parsed.value[2].isSet());
    QCOMPARE(parsed.value[63].number, 64);
    QCOMPARE(parsed.value[63].coordinatesField, 193);
    QVERIFY(parsed.value[63].coordinates() == CubeCoordinates::Other);
}

void ToolsAndFramesTest::readsEncoderOffsets_data()
{
    QTest::addColumn<QString>("path");
    QTest::addColumn<QStringList>("groups");
    QTest::addColumn<QList<QList<qint64>>>("values");
    using Values = QList<QList<qint64>>;
    const QList<qint64> first {-12, -30450, 22100, 915, -7003, -61250};
    QTest::newRow("one robot") << QStringLiteral("yrc1000/ABSO.DAT") << QStringList {QStringLiteral("R1")}
                               << Values {first};
    QTest::newRow("packed") << QStringLiteral("yrc1000-fsu/ABSO.DAT")
                            << QStringList {QStringLiteral("R1"), QStringLiteral("R2")}
                            << Values {first, {333, -31111, 25252, 1717, -8008, 44044}};
    QTest::newRow("two rows a group") << QStringLiteral("dx200/ABSO.DAT")
                                      << QStringList {QStringLiteral("R1"), QStringLiteral("B1"), QStringLiteral("S1")}
                                      << Values {{-1501, -40404, 39993, 2020, -1212, -15151}, {606}, {-2727}};
    QTest::newRow("seven axes") << QStringLiteral("dx100/ABSO.DAT")
                                << QStringList {QStringLiteral("R1"), QStringLiteral("R2"), QStringLiteral("B1")}
                                << Values {{1201, 2302, 3403, 4504, 5605, 6706, 7807},
                                       {-70007, 66066, -20002, 1110, -909, 8808, 7707}, {3003}};
}

void ToolsAndFramesTest::readsEncoderOffsets()
{
    QFETCH(QString, path);
    QFETCH(QStringList, groups);
    QFETCH(QList<QList<qint64>>, values);
    const QByteArray file = samples::read(path);
    const auto parsed = encoderOffsetsFrom(file);
    QCOMPARE(parsed.warnings.count(), 0);
    QCOMPARE(parsed.value.crc, path.contains(u"fsu") ? QByteArray {"305419896"} : QByteArray {});
    QCOMPARE(parsed.value.groups.size(), groups.size());
    for (qsizetype index = 0; index < groups.size(); ++index) {
        const HomeGroup &group = parsed.value.groups[index];
        QCOMPARE(group.group.name, groups[index]);
        QList<qint64> found;
        for (const HomeAxis &axis : group.axes) {
            QVERIFY(axis.isValid);
            found << axis.pulses;
        }
        QCOMPARE(found, values[index]);
    }
}

void ToolsAndFramesTest::readsHomes()
{
    const auto second = homePositionsFrom(samples::read(QStringLiteral("yrc1000/HOME2.DAT")));
    QCOMPARE(second.warnings.count(), 0);
    const auto pulses = [](const HomeGroup &group) {
        QList<qint64> found;
        for (const HomeAxis &axis : group.axes)
            found << axis.pulses;
        return found;
    };
    QCOMPARE(pulses(second.value.groups[0]), (QList<qint64> {0, -10000, 20000, 0, -65000, 0}));
    const auto origin = homePositionsFrom(samples::read(QStringLiteral("yrc1000/OPEORG.DAT")));
    QCOMPARE(origin.warnings.count(), 0);
    QCOMPARE(pulses(origin.value.groups[0]), (QList<qint64> {1000, -97280, -55401, 0, -62619, 0}));
    QCOMPARE(origin.value.speeds.value(0), 5000);
    QCOMPARE(origin.value.cubes.size(), 1);
    QCOMPARE(origin.value.cubes[0].number, 64);
    QVERIFY((origin.value.cubes[0].upper == std::array<qint64, 8> {1100000, 300000, 900000, 0, 0, 0, 0, 0}));
    QVERIFY((origin.value.cubes[0].lower == std::array<qint64, 8> {1000000, -300000, 700000, 0, 0, 0, 0, 0}));
    const auto other = homePositionsFrom(samples::read(QStringLiteral("dx200/OPEORG.DAT")));
    QCOMPARE(other.value.cubes.size(), 1); // one robot
    QCOMPARE(other.value.groups.size(), 3);
}

void ToolsAndFramesTest::readsPseudoInputs_data()
{
    QTest::addColumn<QString>("path");
    QTest::addColumn<int>("base");
    QTest::addColumn<QList<int>>("on");
    QTest::newRow("YRC1000") << QStringLiteral("yrc1000/PSEUDOIN.DAT") << pseudoInputBase
                             << QList<int> {87015, 87016, 87030};
    QTest::newRow("DX100") << QStringLiteral("dx100/PSEUDOIN.DAT") << pseudoInputBaseDx100 << QList<int> {82015};
}

void ToolsAndFramesTest::readsPseudoInputs()
{
    QFETCH(QString, path);
    QFETCH(int, base);
    const QByteArray file = samples::read(path);
    const auto parsed = pseudoInputsFrom(file, samples::codec());
    QCOMPARE(parsed.warnings.count(), 0);
    QTEST(parsed.value.on(base), "on");
    QVERIFY(parsed.value.on(base).contains(base + commandRemoteSelect));
    if (base == pseudoInputBase)
        QCOMPARE(parsed.value.names.value(0), QStringLiteral("PULSE CHECK"));
}

QTEST_APPLESS_MAIN(ToolsAndFramesTest)
#include "tst_toolsandframes.moc"
