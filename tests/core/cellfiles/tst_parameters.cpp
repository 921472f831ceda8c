// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "cellfiles/arm.h"
#include "cellfiles/parameters.h"
#include "support/samples.h"
#include <QTest>

using namespace cellfiles;

class ParametersTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void readsValues_data();
    void readsValues();
    void countsSections_data();
    void countsSections();
    void checkLinesAreNoValues_data();
    void checkLinesAreNoValues();
    void allIsTheSingleFiles();
    void damagedRows();
    void cutFile();
    void convertsDegrees_data();
    void convertsDegrees();
    void noRobotNoDegrees();
    void followsTheChain();
    void findsMeanings();
};

namespace {

Parameters parameters(const char *path)
{
    const QByteArray file = samples::read(QString::fromLatin1(path));
    return parametersFrom(file).value;
}

bool isNear(double a, double b, double tolerance) { return std::abs(a - b) <= tolerance; }

} // namespace

void ParametersTest::readsValues_data()
{
    QTest::addColumn<QByteArray>("path");
    QTest::addColumn<QByteArray>("section");
    QTest::addColumn<int>("number");
    QTest::addColumn<int>("value");
    const auto row = [](const char *path, const char *section, int number, int value) {
        QTest::addRow("%s %s %d", path, section, number)
            << QByteArray {path} << QByteArray {section} << number << value;
    };
    const std::pair<int, int> rs[] {
        {0, 2}, {3, 9}, {7, 2}, {22, 1}, {29, 1}, {34, 200}, {35, 200}, {59, 0}, {89, 1}, {214, 2}};
    for (const auto &[number, value] : rs)
        row("yrc1000/RS.PRM", "RS", number, value);
    const std::pair<int, int> rc[] {{1, 120000}, {3, 650000}, {5, 180000}, {8, 700000}, {12, 95000}, {1093, -10},
        {1105, 640}, {1030, 232107}, {1035, 201649}, {1040, -232107}};
    for (const auto &[number, value] : rc)
        row("yrc1000/RC.PRM", "RC1G", number, value);
    const std::pair<int, int> s2c[] {
        {224, 0}, {409, 0}, {431, 1}, {541, 0}, {542, 0}, {1100, 1}, {1102, 2}, {1103, 2}, {1104, 2}, {1119, 0}};
    for (const auto &[number, value] : s2c)
        row("yrc1000/SC.PRM", "S2C", number, value);
    row("yrc1000/SC.PRM", "S1C1G", 800, 232107);
    row("yrc1000/SC.PRM", "S1C1G", 810, -232107);
    row("yrc1000/SC.PRM", "S3C", 8, 900000);
    row("yrc1000/SC.PRM", "S3C", 9, -900000);
    for (const int number : {10, 11, 12, 13, 14, 16})
        row("yrc1000/SD.PRM", "S2D", number, 250);
    row("yrc1000/SD.PRM", "S2D", 15, 0);
    row("yrc1000/SD.PRM", "S2D", 17, 128);
    row("yrc1000/SD.PRM", "S2D", 18, 128);
    row("yrc1000/SD.PRM", "S3D", 0, 1);
    row("yrc1000/SD.PRM", "S3D", 1, 63);
    row("yrc1000/CIO.PRM", "CIO", 1450, 96);
    row("yrc1000/SV.PRM", "SV1G", 30, 4096);
    row("yrc1000/SV.PRM", "SV1G", 35, 4096);
    row("yrc1000/SV.PRM", "SVD", 4, 1024);
    row("yrc1000-fsu/RS.PRM", "RS", 22, 1);
    row("dx200/RS.PRM", "RS", 73, 41);
    row("dx200/RS.PRM", "RS", 76, 255);
    row("dx200/RS.PRM", "RS", 6, 1);
    row("dx100/RS.PRM", "RS", 34, 30);
    row("dx100/RS.PRM", "RS", 214, 0);
    row("yrc1000-later/RS.PRM", "RS", 22, 0);
}

void ParametersTest::readsValues()
{
    QFETCH(QByteArray, path);
    QFETCH(QByteArray, section);
    QFETCH(int, number);
    QFETCH(int, value);
    const QByteArray file = samples::read(QString::fromLatin1(path));
    const auto parsed = parametersFrom(file);
    QCOMPARE(parsed.warnings.count(), 0);
    QCOMPARE(parsed.value.value(section, number), std::optional {value});
}

void ParametersTest::countsSections_data()
{
    QTest::addColumn<QByteArray>("path");
    QTest::addColumn<QByteArray>("section");
    QTest::addColumn<int>("values"); // 0: there is none
    const auto row = [](const char *path, const char *section, int values) {
        QTest::addRow("%s %s", path, section) << QByteArray {path} << QByteArray {section} << values;
    };
    row("yrc1000/RS.PRM", "RS", 1000);
    row("yrc1000/RC.PRM", "RCD", 100);
    row("yrc1000/RC.PRM", "RC1G", 3000);
    row("yrc1000/RC.PRM", "RC2G", 3000);
    row("yrc1000/SC.PRM", "S1C1G", 2800);
    row("yrc1000/SC.PRM", "S2C", 2000);
    row("yrc1000/SC.PRM", "S3C", 3000);
    row("yrc1000/SC.PRM", "S4C", 2000);
    row("yrc1000/SD.PRM", "S1D", 1000);
    row("yrc1000/SD.PRM", "S4D", 600);
    row("yrc1000/CIO.PRM", "CIO", 3000);
    row("yrc1000/FD.PRM", "FD", 1000);
    row("yrc1000-fsu/RS.PRM", "RS", 1000); // ///CRC INVALID is neither a section nor a value
    row("yrc1000-fsu/RS.PRM", "CRC", 0);
    row("dx100/RS.PRM", "RS", 500);
}

void ParametersTest::countsSections()
{
    QFETCH(QByteArray, path);
    QFETCH(QByteArray, section);
    QTEST(int(parameters(path.constData()).sections.value(section).values.size()), "values");
}

void ParametersTest::checkLinesAreNoValues_data()
{
    QTest::addColumn<QByteArray>("path");
    QTest::addColumn<bool>("hasCheckLine");
    QTest::newRow("YRC1000") << QByteArray {"yrc1000/FD.PRM"} << true;
    QTest::newRow("DX200") << QByteArray {"dx200/FD.PRM"} << true;
    QTest::newRow("DX100") << QByteArray {"dx100/FD.PRM"} << false;
}

void ParametersTest::checkLinesAreNoValues()
{
    QFETCH(QByteArray, path);
    const Parameters read = parameters(path.constData());
    QCOMPARE(int(read.sections.value("FD").values.size()), 1000);
    QTEST(!read.checkLine.isEmpty(), "hasCheckLine");
}

void ParametersTest::allIsTheSingleFiles()
{
    const Parameters all = parameters("yrc1000/ALL.PRM");
    QCOMPARE(all.files, (QByteArrayList {"RC", "SD", "SC", "CIO", "FD", "RS", "SV"}));
    QCOMPARE(all.tag, QByteArray {"YAS"});
    for (const QByteArray &file : all.files) {
        const Parameters single = parameters(("yrc1000/" + file + ".PRM").constData());
        for (auto section = single.sections.begin(); section != single.sections.end(); ++section)
            QVERIFY2(all.sections.value(section.key()).values == section->values, section.key().constData());
    }
    QVERIFY(all.checkLine != parameters("yrc1000/FD.PRM").checkLine);
    QCOMPARE(parameters("yrc1000micro/ALL.PRM").tag, QByteArray {"YBS"});
}

void ParametersTest::damagedRows()
{
    const QByteArray file = samples::read(QStringLiteral("damaged/RS-unknown-section.PRM"));
    const auto parsed = parametersFrom(file);
    const auto at = [&](int number) { return parsed.value.value("RS", number); };
    QCOMPARE(at(22), std::optional {1});
    QCOMPARE(at(28), std::optional {0});
    QVERIFY(!at(29).has_value());
    QCOMPARE(at(34), std::optional {200});
    QCOMPARE(at(189), std::optional {0});
    QVERIFY(!at(190).has_value());
    QVERIFY(!at(214).has_value());
    QVERIFY(parsed.value.sections.contains("ZZZ 9"));
    QList<int> lines;
    for (const Warning &warning : parsed.warnings.list())
        lines << warning.line;
    QCOMPARE(lines, (QList<int> {4, 21, 22}));
}

void ParametersTest::cutFile()
{
    const QByteArray file = samples::read(QStringLiteral("damaged/ALL-cut.PRM"));
    const auto parsed = parametersFrom(file);
    QCOMPARE(parsed.value.files, (QByteArrayList {"RC", "SD", "SC", "CIO", "FD", "RS"}));
    QCOMPARE(parsed.value.value("RS", 59), std::optional {0});
    QCOMPARE(parsed.value.value("RS", 63), std::optional {0});
    QVERIFY(!parsed.value.value("RS", 64).has_value()); // its digits may be cut
    QVERIFY(!parsed.value.value("RS", 70).has_value());
    QVERIFY(!parsed.warnings.isEmpty());
}

void ParametersTest::convertsDegrees_data()
{
    QTest::addColumn<QByteArray>("path");
    QTest::newRow("blocks of ten") << QByteArray {"yrc1000/RC.PRM"};
    QTest::newRow("blocks of eight") << QByteArray {"dx200/RC.PRM"};
    QTest::newRow("DX100") << QByteArray {"dx100/RC.PRM"};
}

void ParametersTest::convertsDegrees()
{
    QFETCH(QByteArray, path);
    const Arm arm = armOf(parameters(path.constData()), 1);
    constexpr std::array perDegree {1365.3333, 1968.3556, 1846.7009, 922.7378, 1043.6525, 560.1368};
    constexpr std::array upper {170, 150, 230, 190, 140, 360};
    constexpr std::array lower {-170, -100, -75, -190, -140, -360};
    constexpr std::array speed {260, 225, 260, 430, 430, 600};
    for (std::size_t axis = 0; axis < perDegree.size(); ++axis) {
        const Axis &found = arm.axes[axis];
        QVERIFY(isNear(found.pulsesPerDegree(), perDegree[axis], 5e-5));
        QVERIFY(isNear(found.degrees(double(found.upperLimit)), upper[axis], 1e-3));
        QVERIFY(isNear(found.degrees(double(found.lowerLimit)), lower[axis], 1e-3));
        QVERIFY(isNear(found.degrees(double(found.topSpeed)), speed[axis], 1e-2));
    }
    QVERIFY(!arm.axes[6].exists());
    QVERIFY(arm.isStandard());
}

void ParametersTest::noRobotNoDegrees()
{
    const Parameters read = parameters("yrc1000/RC.PRM");
    QVERIFY(!armOf(read, 2).exists()); // all zero
    QVERIFY(!armOf(read, 3).exists()); // no such section
    QVERIFY(!armOf(read, 2).toolPoint({0, 0, 0, 0, 0, 0}, {}).has_value());
}

void ParametersTest::followsTheChain()
{
    const Arm arm = armOf(parameters("yrc1000/RC.PRM"), 1);
    const auto tools = toolsFrom(samples::read(QStringLiteral("yrc1000/TOOL.CND")), samples::codec()).value;
    const auto frames = userFramesFrom(samples::read(QStringLiteral("yrc1000/UFRAME.CND")), samples::codec()).value;
    const Frame &gripper = tools[1].point;
    const auto place = [&](const QList<qint64> &pulses) { return *arm.toolPoint(pulses, gripper); };
    const auto isAt = [](const motion::Vector &a, const motion::Vector &b, double tolerance) {
        return isNear(a[0], b[0], tolerance) && isNear(a[1], b[1], tolerance) && isNear(a[2], b[2], tolerance);
    };
    const motion::Pose origin = place(frames[0].taught[0]);
    const motion::Pose alongX = place(frames[0].taught[1]);
    const motion::Pose towardsY = place(frames[0].taught[2]);
    QVERIFY(isAt(origin.mm, {873.562, 478.508, -13.168}, 6e-4));
    QVERIFY(isAt(origin.degrees, {178.4023, 11.4503, 33.6516}, 6e-5));
    QVERIFY(isAt(alongX.mm, {1010.866, 253.781, -61.070}, 6e-4));
    QVERIFY(isAt(towardsY.mm, {761.766, 497.825, 24.935}, 6e-4));
    const auto frame = frameThrough(origin.mm, alongX.mm, towardsY.mm);
    const motion::Pose stored = poseOf(*frames[0].frame);
    QVERIFY(isAt(frame->mm, stored.mm, 1e-3));
    QVERIFY(isAt(frame->degrees, stored.degrees, 6e-5));
    const motion::Pose zero = place({0, 0, 0, 0, 0, 0});
    QVERIFY(isAt(zero.mm, {1078.25, -12.5, 830}, 1e-9));
    QVERIFY(isNear(zero.degrees[1], -90, 1e-6));
    constexpr std::array degrees {30.0293, 26.4180, -16.2993, 2.7093, -58.6402, 2.1423};
    for (std::size_t axis = 0; axis < degrees.size(); ++axis)
        QVERIFY(isNear(arm.axes[axis].degrees(double(frames[0].taught[0][qsizetype(axis)])), degrees[axis], 6e-5));
    QVERIFY(!frameThrough(origin.mm, alongX.mm, origin.mm).has_value()); // three points on one line
}

void ParametersTest::findsMeanings()
{
    QVERIFY(meaningOf("RS", 22).contains(QStringLiteral("network clients")));
    QVERIFY(meaningOf("S2C", 526).isEmpty());
    QVERIFY(findMeaning("RS", 70)->isSecret);
    QCOMPARE(parameterName("RS", 22), QStringLiteral("RS022"));
    QCOMPARE(parameterName("S2C", 1119), QStringLiteral("S2C1119"));
}

QTEST_APPLESS_MAIN(ParametersTest)
#include "tst_parameters.moc"
